using System;
using System.Globalization;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// A network in a .tflite file: FlatBuffers with identifier "TFL3" (schema version 3 of TensorFlow Lite, one subgraph). Only what
    /// the hand models use is understood; anything else, and any damage, is an <see cref="InputException"/>.
    /// </summary>
    internal sealed class TfLiteModel
    {
        private const int MaxEntries = 4096;
        private const int MaxRank = 6;
        private const int MaxElements = 1 << 26;

        private TfLiteModel(FlatBuffer file, TfLiteTensor[] tensors, TfLiteOperator[] operators, int[] inputs, int[] outputs)
        {
            File = file;
            Tensors = tensors;
            Operators = operators;
            Inputs = inputs;
            Outputs = outputs;
        }

        public FlatBuffer File { get; }

        public TfLiteTensor[] Tensors { get; }

        /// <summary>In the order in which they run.</summary>
        public TfLiteOperator[] Operators { get; }

        public int[] Inputs { get; }

        public int[] Outputs { get; }

        /// <param name="bytes">The whole file; kept.</param>
        /// <param name="source">How messages name it.</param>
        /// <exception cref="InputException">It is cut, damaged, no such file, or a network that needs more than there is here.</exception>
        public static TfLiteModel Read(byte[] bytes, string source)
        {
            var file = new FlatBuffer(bytes, source);
            if (bytes.Length < 8 || !bytes.AsSpan(4, 4).SequenceEqual(new[] { (byte)'T', (byte)'F', (byte)'L', (byte)'3' }))
                throw file.Broken("is no TensorFlow Lite model (its bytes 4 to 7 are not \"TFL3\")");
            int model = file.Root;
            int[] codes = file.Tables(model, 1, MaxEntries);
            int[] subgraphs = file.Tables(model, 2, MaxEntries);
            int[] buffers = file.Tables(model, 4, MaxEntries);
            if (subgraphs.Length != 1)
                throw file.Broken("holds " + Text(subgraphs.Length) + " networks instead of one");
            int[] tables = file.Tables(subgraphs[0], 0, MaxEntries);
            var tensors = new TfLiteTensor[tables.Length];
            for (int i = 0; i < tensors.Length; i++)
                tensors[i] = ReadTensor(file, tables[i], buffers, i);
            tables = file.Tables(subgraphs[0], 3, MaxEntries);
            var operators = new TfLiteOperator[tables.Length];
            for (int i = 0; i < operators.Length; i++)
                operators[i] = ReadOperator(file, tables[i], codes, tensors.Length, i);
            int[] inputs = TensorNumbers(file, subgraphs[0], 1, tensors.Length, 0);
            int[] outputs = TensorNumbers(file, subgraphs[0], 2, tensors.Length, 0);
            return new TfLiteModel(file, tensors, operators, inputs, outputs);
        }

        private static TfLiteTensor ReadTensor(FlatBuffer file, int table, int[] buffers, int number)
        {
            string name = "tensor " + Text(number);
            int type = file.ByteField(table, 1, 0);
            if (type > (int)TensorType.Int32)
                throw file.Broken(name + " is of type " + Text(type) + ", which is not known here (quantised?)");
            if (file.Field(table, 6) != 0)
                throw file.Broken(name + " is sparse, which is not known here");
            int[] shape = file.Int32s(table, 0, MaxRank);
            long elements = 1;
            foreach (int size in shape)
            {
                if (size < 1)
                    throw file.Broken(name + " has a side of " + Text(size));
                elements *= size;
                if (elements > MaxElements)
                    throw file.Broken(name + " is too large");
            }

            int buffer = file.Int32Field(table, 2, 0);
            if (buffer < 0 || buffer >= buffers.Length)
                throw file.Broken(name + " has its values in buffer " + Text(buffer) + " of " + Text(buffers.Length));
            int data = file.VectorField(buffers[buffer], 0, 1, int.MaxValue, out int bytes);
            if (bytes == 0)
                return new TfLiteTensor((TensorType)type, shape, (int)elements, 0);
            if (bytes != elements * (type == (int)TensorType.Float16 ? 2 : 4))
                throw file.Broken(name + " has " + Text(bytes) + " bytes for " + Text((int)elements) + " values");
            return new TfLiteTensor((TensorType)type, shape, (int)elements, data);
        }

        private static TfLiteOperator ReadOperator(FlatBuffer file, int table, int[] codes, int tensors, int number)
        {
            string name = "operator " + Text(number);
            int index = file.Int32Field(table, 0, 0);
            if (index < 0 || index >= codes.Length)
                throw file.Broken(name + " is of kind " + Text(index) + " of " + Text(codes.Length));

            // Old files have the code in a byte, newer ones in both; the larger one counts.
            int code = Math.Max(file.ByteField(codes[index], 0, 0), file.Int32Field(codes[index], 3, 0));
            if (!Enum.IsDefined(typeof(OperatorCode), code))
                throw file.Broken(name + " is built-in operator " + Text(code) + ", which the hand models do not use");
            int[] inputs = TensorNumbers(file, table, 1, tensors, -1);
            int[] outputs = TensorNumbers(file, table, 2, tensors, 0);
            if (outputs.Length != 1)
                throw file.Broken(name + " has " + Text(outputs.Length) + " outputs");
            return new TfLiteOperator((OperatorCode)code, inputs, outputs[0], file.TableField(table, 4));
        }

        private static int[] TensorNumbers(FlatBuffer file, int table, int field, int tensors, int least)
        {
            int[] numbers = file.Int32s(table, field, 16);
            foreach (int number in numbers)
            {
                if (number < least || number >= tensors)
                    throw file.Broken("tensor " + Text(number) + " is used, of " + Text(tensors));
            }

            return numbers;
        }

        private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);
    }
}
