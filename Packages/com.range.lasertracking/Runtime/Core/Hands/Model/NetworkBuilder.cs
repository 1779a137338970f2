using System;
using System.Collections.Generic;
using System.Globalization;

namespace LaserTracking.Hands.Model
{
    /// <summary>Makes layers of a model's operators: checks their shapes, reads their weights, places their activations.</summary>
    internal sealed unsafe class NetworkBuilder
    {
        private const long MaxActivations = 1 << 26;
        private const long MaxConstants = 1 << 25;
        private const long MaxMultiplyAdds = 4_000_000_000;

        private readonly TfLiteModel _model;
        private readonly float[]?[] _constants;
        private readonly long[] _offsets;
        private readonly int[] _lastUse;
        private readonly int _bandCount;
        private readonly List<NetworkLayer> _layers = new List<NetworkLayer>();
        private FloatBuffer? _activations;
        private long _constantCount;
        private long _multiplyAdds;
        private int _operator;

        /// <param name="model">Its source.</param>
        /// <param name="bandCount">Of what will run the layers.</param>
        public NetworkBuilder(TfLiteModel model, int bandCount)
        {
            _bandCount = bandCount;
            _model = model;
            _constants = new float[model.Tensors.Length][];
            _offsets = new long[model.Tensors.Length];
            _lastUse = new int[model.Tensors.Length];
        }

        /// <summary>Layers in the order in which they run, and the memory between them, which the caller owns.</summary>
        /// <exception cref="InputException">The operators do not fit together, or need more than is sensible.</exception>
        public NetworkLayer[] Build(out FloatBuffer activations)
        {
            activations = _activations = PlaceActivations();
            try
            {
                for (_operator = 0; _operator < _model.Operators.Length; _operator++)
                    AddLayer(_model.Operators[_operator]);
            }
            catch (InputException)
            {
                foreach (NetworkLayer layer in _layers)
                    (layer as IDisposable)?.Dispose();
                activations.Dispose();
                throw;
            }

            return _layers.ToArray();
        }

        /// <summary>Where an activation lies. After <see cref="Build"/> or while it goes on.</summary>
        public FeatureMap Map(int tensor)
        {
            int[] shape = _model.Tensors[tensor].Shape;
            int rank = shape.Length;
            if (rank == 0 || rank > 4 || (rank > 2 && shape[0] != 1) || rank == 3)
                throw Wrong("works on a tensor that is no picture and no vector");
            float* data = _activations!.Floats + _offsets[tensor];
            return rank == 4 ? new FeatureMap(data, shape[1], shape[2], shape[3])
                : rank == 2 ? new FeatureMap(data, 1, shape[0], shape[1]) : new FeatureMap(data, 1, 1, shape[0]);
        }

        private FloatBuffer PlaceActivations()
        {
            var isKnown = new bool[_model.Tensors.Length];
            long count = 0;
            for (int i = 0; i < _model.Operators.Length; i++)
            {
                foreach (int input in _model.Operators[i].Inputs)
                {
                    if (input >= 0)
                        _lastUse[input] = i;
                }
            }

            foreach (int output in _model.Outputs)
                _lastUse[output] = int.MaxValue;
            var plan = new ActivationPlan();
            foreach (int input in _model.Inputs)
            {
                // They are written from outside and stay.
                _lastUse[input] = int.MaxValue;
                Place(plan, input, -1, isKnown, ref count);
            }

            for (_operator = 0; _operator < _model.Operators.Length; _operator++)
            {
                TfLiteOperator step = _model.Operators[_operator];
                foreach (int input in step.Inputs)
                {
                    if (input >= 0 && !isKnown[input] && !_model.Tensors[input].IsConstant)
                        throw Wrong("reads a tensor that nothing has written");
                }

                if (step.Code == OperatorCode.Dequantize)
                {
                    Dequantize(step, isKnown);
                    continue;
                }

                Place(plan, step.Output, _operator, isKnown, ref count);
            }

            foreach (int output in _model.Outputs)
            {
                if (!isKnown[output] || _constants[output] != null)
                    throw _model.File.Broken("an output is computed by nothing");
            }

            return new FloatBuffer(plan.Length);
        }

        private void Place(ActivationPlan plan, int number, int firstUse, bool[] isKnown, ref long count)
        {
            TfLiteTensor tensor = _model.Tensors[number];
            count += tensor.Elements;
            if (isKnown[number] || tensor.IsConstant || tensor.Type != TensorType.Float32 || count > MaxActivations)
                throw Wrong("writes a tensor that is a constant, written twice, no float32 or too large");
            isKnown[number] = true;
            _offsets[number] = plan.Place(tensor.Elements, firstUse, Math.Max(firstUse, _lastUse[number]));
        }

        /// <summary>Once, here: weights lie in the file at half precision.</summary>
        private void Dequantize(TfLiteOperator step, bool[] isKnown)
        {
            if (step.Inputs.Length != 1 || step.Inputs[0] < 0 || !_model.Tensors[step.Inputs[0]].IsConstant || isKnown[step.Output]
                || _model.Tensors[step.Output].IsConstant || _model.Tensors[step.Output].Elements != _model.Tensors[step.Inputs[0]].Elements)
                throw Wrong("does not unpack a constant");
            isKnown[step.Output] = true;
            _constants[step.Output] = ReadConstant(step.Inputs[0]);
        }

        private float[] ReadConstant(int number)
        {
            TfLiteTensor tensor = _model.Tensors[number];
            _constantCount += tensor.Elements;
            if (tensor.Type == TensorType.Int32 || _constantCount > MaxConstants)
                throw Wrong("has weights that are no floats or too many");
            int size = tensor.Type == TensorType.Float16 ? 2 : 4;
            ReadOnlySpan<byte> bytes = _model.File.Bytes(tensor.DataPosition, tensor.Elements * size);
            var values = new float[tensor.Elements];
            for (int i = 0; i < values.Length; i++)
            {
                values[i] = size == 2 ? HalfFloat.ToSingle((ushort)(bytes[2 * i] | bytes[2 * i + 1] << 8))
                    : BitConverter.Int32BitsToSingle(bytes[4 * i] | bytes[4 * i + 1] << 8 | bytes[4 * i + 2] << 16 | bytes[4 * i + 3] << 24);
            }

            return values;
        }

        private void AddLayer(TfLiteOperator step)
        {
            switch (step.Code)
            {
                case OperatorCode.Dequantize:
                    break;
                case OperatorCode.Conv2D:
                    Convolution(step);
                    break;
                case OperatorCode.DepthwiseConv2D:
                    Depthwise(step);
                    break;
                case OperatorCode.FullyConnected:
                    FullyConnected(step);
                    break;
                case OperatorCode.MaxPool2D:
                    MaxPool(step);
                    break;
                case OperatorCode.Add:
                    Require(step.Inputs.Length == 2, "adds other than two tensors");
                    FeatureMap first = Activation(step, 0), second = Activation(step, 1), sum = Map(step.Output);
                    Require(IsSame(first, second) && IsSame(first, sum), "adds tensors of different shapes");
                    _layers.Add(new AddLayer(first, second, sum, Activate(step, 0)));
                    break;
                case OperatorCode.Logistic:
                    Require(step.Inputs.Length == 1 && IsSame(Activation(step, 0), Map(step.Output)), "gives another shape than it takes");
                    _layers.Add(new LogisticLayer(Activation(step, 0), Map(step.Output)));
                    break;
                default:
                    Mean(step);
                    break;
            }
        }

        private void Convolution(TfLiteOperator step)
        {
            FeatureMap input = Activation(step, 0), output = Map(step.Output);
            float[] weights = Weights(step, out int[] shape);
            SlidingWindow window = Window(step, shape, shape.Length == 4 ? shape[1] : 0, shape.Length == 4 ? shape[2] : 0, 4, input, output);
            Require(shape[0] == output.Channels && shape[3] == input.Channels, "has weights for other channels");
            Count((long)output.Count * window.Height * window.Width * input.Channels);
            _layers.Add(new ConvolutionLayer(input, output, window, weights, Bias(step, output.Channels), Activate(step, 3), _bandCount));
        }

        private void Depthwise(TfLiteOperator step)
        {
            FeatureMap input = Activation(step, 0), output = Map(step.Output);
            float[] weights = Weights(step, out int[] shape);
            SlidingWindow window = Window(step, shape, shape.Length == 4 ? shape[1] : 0, shape.Length == 4 ? shape[2] : 0, 5, input, output);
            Require(shape[0] == 1 && shape[3] == output.Channels && input.Channels == output.Channels, "is a depthwise convolution with a multiplier other than 1");
            Count((long)output.Count * window.Height * window.Width);
            _layers.Add(new DepthwiseLayer(input, output, window, weights, Bias(step, output.Channels), Activate(step, 4), _bandCount));
        }

        /// <summary>A convolution over a picture of one pixel.</summary>
        private void FullyConnected(TfLiteOperator step)
        {
            FeatureMap input = Activation(step, 0), output = Map(step.Output);
            float[] weights = Weights(step, out int[] shape);
            Require(shape.Length == 2 && shape[0] == output.Count && shape[1] == input.Count && Option(step, 1) == 0, "has weights for other vectors");
            Count((long)input.Count * output.Count);
            _layers.Add(new ConvolutionLayer(new FeatureMap(input.Data, 1, 1, input.Count), new FeatureMap(output.Data, 1, 1, output.Count),
                new SlidingWindow(false, 1, 1, 1, 1), weights, Bias(step, output.Count), Activate(step, 0), _bandCount));
        }

        private void MaxPool(TfLiteOperator step)
        {
            FeatureMap input = Activation(step, 0), output = Map(step.Output);
            Require(step.Inputs.Length == 1 && input.Channels == output.Channels, "has other inputs than a picture");
            SlidingWindow window = Window(step, null, Integer(step, 4, 0), Integer(step, 3, 0), 0, input, output);
            Count((long)output.Count * window.Height * window.Width);
            _layers.Add(new MaxPoolLayer(input, output, window, Activate(step, 5)));
        }

        private void Mean(TfLiteOperator step)
        {
            FeatureMap input = Activation(step, 0), output = Map(step.Output);
            TfLiteTensor? axes = step.Inputs.Length == 2 && step.Inputs[1] >= 0 ? _model.Tensors[step.Inputs[1]] : null;
            Require(axes != null && axes.Type == TensorType.Int32 && axes.IsConstant && axes.Elements == 2
                && _model.File.Bytes(axes.DataPosition, 8).SequenceEqual(new byte[] { 1, 0, 0, 0, 2, 0, 0, 0 }), "is a mean over other than height and width");
            Require(output.Count == input.Channels, "gives another shape than its input has");
            _layers.Add(new MeanLayer(input, output));
        }

        /// <param name="step">With padding, stride x and stride y as its first options.</param>
        /// <param name="shape">Of the weights, which must have four sides; null: there are none.</param>
        /// <param name="height">Of the window.</param>
        /// <param name="width">Of the window.</param>
        /// <param name="dilation">First of the two options that say how far the window is spread; 0: there are none.</param>
        /// <param name="input">What it goes over.</param>
        /// <param name="output">What must come out.</param>
        private SlidingWindow Window(TfLiteOperator step, int[]? shape, int height, int width, int dilation, FeatureMap input, FeatureMap output)
        {
            int strideX = Integer(step, 1, 0), strideY = Integer(step, 2, 0);
            Require((shape == null || shape.Length == 4) && Math.Min(height, width) > 0 && Math.Max(height, width) <= SlidingWindow.MaxSide
                && Math.Min(strideX, strideY) > 0 && Math.Max(strideX, strideY) <= SlidingWindow.MaxSide, "has a window or a stride that cannot be");
            Require(dilation == 0 || (Integer(step, dilation, 1) == 1 && Integer(step, dilation + 1, 1) == 1), "has a window with gaps");
            var window = new SlidingWindow(Option(step, 0) == 0, height, width, strideY, strideX);
            Require(window.OutputHeight(input.Height) == output.Height && window.OutputWidth(input.Width) == output.Width,
                "has an output of another size than its window gives");

            // Columns of a convolution and rows of a depthwise one are copied side by side.
            long scratch = Math.Max((long)output.Width * height * width, (height + 1L) * (input.Width + output.Width * (long)strideX + width)) * input.Channels;
            Require(scratch <= MaxActivations, "has windows that are too large");
            return window;
        }

        private FeatureMap Activation(TfLiteOperator step, int index)
        {
            Require(index < step.Inputs.Length && step.Inputs[index] >= 0 && !_model.Tensors[step.Inputs[index]].IsConstant
                && _constants[step.Inputs[index]] == null, "needs an input that is computed");
            return Map(step.Inputs[index]);
        }

        private float[] Weights(TfLiteOperator step, out int[] shape)
        {
            Require(step.Inputs.Length >= 2 && step.Inputs.Length <= 3 && step.Inputs[1] >= 0, "has no weights");
            shape = _model.Tensors[step.Inputs[1]].Shape;
            return Constant(step.Inputs[1]);
        }

        private float[] Bias(TfLiteOperator step, int count)
        {
            if (step.Inputs.Length < 3 || step.Inputs[2] < 0)
                return new float[count];
            float[] bias = Constant(step.Inputs[2]);
            Require(bias.Length == count, "has a bias for other channels");
            return bias;
        }

        private float[] Constant(int number)
        {
            float[]? known = _constants[number];
            Require(known != null || _model.Tensors[number].IsConstant, "has weights that are no constants");
            return known ?? (_constants[number] = ReadConstant(number));
        }

        private Clamp Activate(TfLiteOperator step, int option)
        {
            Require(Clamp.TryCreate(Option(step, option), out Clamp clamp), "has an activation other than none, ReLU and ReLU6");
            return clamp;
        }

        private int Option(TfLiteOperator step, int index) => step.Options == 0 ? 0 : _model.File.ByteField(step.Options, index, 0);

        private int Integer(TfLiteOperator step, int index, int absent) => step.Options == 0 ? absent : _model.File.Int32Field(step.Options, index, absent);

        private static bool IsSame(FeatureMap a, FeatureMap b) => a.Height == b.Height && a.Width == b.Width && a.Channels == b.Channels;

        private void Count(long multiplyAdds)
        {
            _multiplyAdds += multiplyAdds;
            Require(_multiplyAdds <= MaxMultiplyAdds, "makes the network too large to run live");
        }

        private void Require(bool isTrue, string otherwise)
        {
            if (!isTrue)
                throw Wrong(otherwise);
        }

        private InputException Wrong(string what) => _model.File.Broken(
            _operator < 0 || _operator >= _model.Operators.Length ? "the network " + what
                : "operator " + _operator.ToString(CultureInfo.InvariantCulture) + " (" + _model.Operators[_operator].Code + ") " + what);
    }
}
