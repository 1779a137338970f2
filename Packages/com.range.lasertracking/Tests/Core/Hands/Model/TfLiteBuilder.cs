using System;
using System.Collections.Generic;
using System.Text;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// Writes small .tflite files for tests, in the plainest way the format allows: every table with its own vtable in front of it,
    /// references forward only.
    /// </summary>
    internal sealed class TfLiteBuilder
    {
        private readonly List<Node> _tensors = new List<Node>();
        private readonly List<Node> _operators = new List<Node>();
        private readonly List<Node> _codes = new List<Node>();
        private readonly List<Node> _buffers = new List<Node> { Node.Table() };

        public int Tensor(params int[] shape) => Add(0, 0, shape);

        public int Constant(float[] values, params int[] shape)
        {
            var bytes = new byte[4 * values.Length];
            Buffer.BlockCopy(values, 0, bytes, 0, bytes.Length);
            return Add(0, Data(bytes), shape);
        }

        public int Halves(ushort[] values, params int[] shape)
        {
            var bytes = new byte[2 * values.Length];
            Buffer.BlockCopy(values, 0, bytes, 0, bytes.Length);
            return Add(1, Data(bytes), shape);
        }

        public int Integers(int[] values, params int[] shape)
        {
            var bytes = new byte[4 * values.Length];
            Buffer.BlockCopy(values, 0, bytes, 0, bytes.Length);
            return Add(2, Data(bytes), shape);
        }

        /// <param name="code">Built-in operator.</param>
        /// <param name="output">Tensor number.</param>
        /// <param name="inputs">Tensor numbers.</param>
        /// <param name="options">Fields of the options' table in order: bytes or ints, null: left out.</param>
        public void Operator(int code, int output, int[] inputs, params object?[] options)
        {
            _codes.Add(Node.Table((byte)Math.Min(code, 127), null, 1, code));
            _operators.Add(Node.Table(_codes.Count - 1, Node.Integers(inputs), Node.Integers(output), (byte)0, options.Length == 0 ? null : Node.Table(options)));
        }

        public byte[] Build(int[] inputs, params int[] outputs)
        {
            Node subgraph = Node.Table(Node.Vector(_tensors), Node.Integers(inputs), Node.Integers(outputs), Node.Vector(_operators));
            Node model = Node.Table(3, Node.Vector(_codes), Node.Vector(new List<Node> { subgraph }), null, Node.Vector(_buffers));
            var bytes = new List<byte>(new byte[4]);
            bytes.AddRange(Encoding.ASCII.GetBytes("TFL3"));
            int root = model.Write(bytes);
            Patch(bytes, 0, root);
            return bytes.ToArray();
        }

        private static void Patch(List<byte> bytes, int at, int value)
        {
            for (int i = 0; i < 4; i++)
                bytes[at + i] = (byte)(value >> (8 * i));
        }

        private int Data(byte[] bytes)
        {
            _buffers.Add(Node.Table(Node.Bytes(bytes)));
            return _buffers.Count - 1;
        }

        private int Add(byte type, int buffer, int[] shape)
        {
            _tensors.Add(Node.Table(Node.Integers(shape), type, buffer));
            return _tensors.Count - 1;
        }

        /// <summary>A table or a vector of a FlatBuffers file.</summary>
        private sealed class Node
        {
            private readonly object?[]? _fields;
            private readonly byte[]? _vector;
            private readonly int _vectorCount;
            private readonly List<Node>? _children;

            private Node(object?[]? fields, byte[]? vector, int vectorCount, List<Node>? children)
            {
                _fields = fields;
                _vector = vector;
                _vectorCount = vectorCount;
                _children = children;
            }

            public static Node Table(params object?[] fields) => new Node(fields, null, 0, null);

            public static Node Bytes(byte[] bytes) => new Node(null, bytes, bytes.Length, null);

            public static Node Vector(List<Node> children) => new Node(null, null, 0, children);

            public static Node Integers(params int[] values)
            {
                var bytes = new byte[4 * values.Length];
                Buffer.BlockCopy(values, 0, bytes, 0, bytes.Length);
                return new Node(null, bytes, values.Length, null);
            }

            /// <summary>Appends it and all below it; returns its position.</summary>
            public int Write(List<byte> bytes)
            {
                while (bytes.Count % 4 != 0)
                    bytes.Add(0);
                return _fields != null ? WriteTable(bytes, _fields) : WriteVector(bytes);
            }

            private int WriteTable(List<byte> bytes, object?[] fields)
            {
                int size = 4 + 2 * fields.Length;
                int table = bytes.Count + (size + 3) / 4 * 4;
                int vtable = bytes.Count;
                AddUInt16(bytes, size);
                AddUInt16(bytes, 4 + 4 * fields.Length);
                for (int i = 0; i < fields.Length; i++)
                    AddUInt16(bytes, fields[i] == null ? 0 : 4 + 4 * i);
                while (bytes.Count < table + 4 + 4 * fields.Length)
                    bytes.Add(0);
                Patch(bytes, table, table - vtable);
                for (int i = 0; i < fields.Length; i++)
                {
                    int at = table + 4 + 4 * i;
                    if (fields[i] is int number)
                        Patch(bytes, at, number);
                    else if (fields[i] is byte small)
                        bytes[at] = small;
                    else if (fields[i] is Node child)
                        Patch(bytes, at, child.Write(bytes) - at);
                }

                return table;
            }

            private int WriteVector(List<byte> bytes)
            {
                int start = bytes.Count;
                bytes.AddRange(new byte[4]);
                Patch(bytes, start, _children?.Count ?? _vectorCount);
                if (_vector != null)
                    bytes.AddRange(_vector);
                if (_children == null)
                    return start;
                bytes.AddRange(new byte[4 * _children.Count]);
                for (int i = 0; i < _children.Count; i++)
                    Patch(bytes, start + 4 + 4 * i, _children[i].Write(bytes) - (start + 4 + 4 * i));
                return start;
            }

            private static void AddUInt16(List<byte> bytes, int value)
            {
                bytes.Add((byte)value);
                bytes.Add((byte)(value >> 8));
            }
        }
    }
}
