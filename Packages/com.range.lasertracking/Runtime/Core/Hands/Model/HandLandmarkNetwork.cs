using System;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// MediaPipe's hand landmark model, read and executed by this package itself: a square of a picture in, 21 landmarks out. One
    /// thread at a time; a run allocates nothing. Fast where .NET has AVX2 with fused multiply-add, scalar elsewhere; both agree with
    /// the original runtime to 2e-3 px of the crop.
    /// </summary>
    public sealed unsafe class HandLandmarkNetwork : IDisposable
    {
        /// <summary>Side of the crop that the network takes, px.</summary>
        public const int InputSizePx = 224;

        /// <summary>MediaPipe's limit: below this presence there is no hand.</summary>
        public const double MinPresence = 0.5;

        private const int Values = 3 * HandLandmarks.Count;

        private readonly TfLiteNetwork _network;
        private readonly KernelRunner _kernels;
        private readonly float[] _rowSums = new float[InputSizePx];

        private HandLandmarkNetwork(TfLiteNetwork network, KernelRunner kernels)
        {
            _network = network;
            _kernels = kernels;
        }

        /// <param name="path">Of the .tflite file.</param>
        /// <param name="file">Which one it must be; its SHA-256 is checked.</param>
        /// <param name="kernels">What runs the heavy kernels; this thread when absent.</param>
        /// <exception cref="InputException">Missing, cut, or another file.</exception>
        public static HandLandmarkNetwork Open(string path, HandModelFile file, KernelRunner? kernels = null) => Read(file.Read(path), path, kernels);

        /// <param name="bytes">A .tflite file with the inputs and outputs of a hand landmark model; not needed afterwards.</param>
        /// <param name="source">How messages name it.</param>
        /// <param name="kernels">What runs the heavy kernels; this thread when absent.</param>
        /// <exception cref="InputException">Damaged, or a network for something else.</exception>
        public static HandLandmarkNetwork Read(byte[] bytes, string source, KernelRunner? kernels = null) => Read(bytes, source, TfLiteNetwork.HasVectors, kernels);

        internal static HandLandmarkNetwork Read(byte[] bytes, string source, bool useVectors, KernelRunner? kernels = null)
        {
            TfLiteModel model = TfLiteModel.Read(bytes, source);
            bool fits = model.Inputs.Length == 1 && Elements(model, model.Inputs[0]) == InputSizePx * InputSizePx * 3
                && model.Outputs.Length == 4 && Elements(model, model.Outputs[0]) == Values && Elements(model, model.Outputs[1]) == 1
                && Elements(model, model.Outputs[2]) == 1 && Elements(model, model.Outputs[3]) == Values;
            if (!fits)
                throw model.File.Broken("is a network for something else than hand landmarks");
            return new HandLandmarkNetwork(new TfLiteNetwork(model, useVectors, kernels), kernels ?? KernelRunner.Plain);
        }

        /// <summary>Looks at one region of a picture.</summary>
        /// <param name="picture">Colour, grey or infrared.</param>
        /// <param name="region">Valid; may reach over the picture's edges.</param>
        /// <param name="landmarks">Receives the answer.</param>
        /// <exception cref="ArgumentException">No such picture, or the region is none.</exception>
        public void Run(Image picture, HandRegion region, HandLandmarks landmarks)
        {
            if (!CanRead(picture))
                throw new ArgumentException($"a picture of format {picture.Format} shows no hand", nameof(picture));
            if (!region.IsValid)
                throw new ArgumentException("the region must be finite and its side above zero", nameof(region));
            Cut(picture, region, _network.Inputs[0].Data);
            _network.Run();
            ReadOnlySpan<FeatureMap> outputs = _network.Outputs;
            landmarks.Set(region, new ReadOnlySpan<float>(outputs[0].Data, Values), new ReadOnlySpan<float>(outputs[3].Data, Values),
                outputs[1].Data[0], outputs[2].Data[0]);
        }

        private void Cut(Image picture, in HandRegion region, float* crop)
        {
            fixed (float* sums = _rowSums)
            {
                CropBands cut = CropBands.Of(picture, region, InputSizePx, crop, sums);
                _kernels.Run(&cut, InputSizePx);
                if (picture.Format != PixelFormat.Infrared16)
                    return;
                var exposure = new ExposureBands { Rgb = crop, Width = InputSizePx, Gain = cut.ExposureGain() };
                _kernels.Run(&exposure, InputSizePx);
            }
        }

        /// <summary>There is a picture, and it is no depth.</summary>
        public static bool CanRead(Image picture) => picture.IsPresent && picture.Format != PixelFormat.Depth16;

        public void Dispose() => _network.Dispose();

        private static int Elements(TfLiteModel model, int tensor) => model.Tensors[tensor].Elements;
    }
}
