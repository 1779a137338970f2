using System;
using System.Buffers.Binary;
using System.Globalization;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// The bytes of a FlatBuffers file, read with every access checked: a file that is cut or damaged gives an
    /// <see cref="InputException"/> that names the byte, and nothing else. Tables and vectors are positions in the file, 0 = absent.
    /// </summary>
    internal sealed class FlatBuffer
    {
        private readonly byte[] _bytes;

        /// <param name="bytes">The whole file.</param>
        /// <param name="source">How messages name it.</param>
        public FlatBuffer(byte[] bytes, string source)
        {
            _bytes = bytes;
            Source = source;
        }

        public string Source { get; }

        public int Length => _bytes.Length;

        /// <summary>The table that the file's first four bytes point to.</summary>
        public int Root => Follow(0);

        public InputException Broken(string what) => new InputException(Source, what, "run './range models' to fetch it again");

        /// <summary>Position of a table's field, 0 when the table does not hold it.</summary>
        public int Field(int table, int index)
        {
            long vtable = table - (long)Int32(table);
            int size = UInt16(vtable);
            int entry = 4 + 2 * index;
            if (entry + 2 > size)
                return 0;
            int offset = UInt16(vtable + entry);
            if (offset == 0)
                return 0;
            Check(table + (long)offset, 1);
            return table + offset;
        }

        public int Int32Field(int table, int index, int absent)
        {
            int at = Field(table, index);
            return at == 0 ? absent : Int32(at);
        }

        public int ByteField(int table, int index, int absent)
        {
            int at = Field(table, index);
            return at == 0 ? absent : _bytes[at];
        }

        /// <summary>The table that a field points to, 0 when there is none.</summary>
        public int TableField(int table, int index)
        {
            int at = Field(table, index);
            return at == 0 ? 0 : Follow(at);
        }

        /// <summary>Position of the first element of a table's vector; <paramref name="count"/> 0 when there is none.</summary>
        public int VectorField(int table, int index, int elementBytes, int maxCount, out int count)
        {
            count = 0;
            int at = Field(table, index);
            if (at == 0)
                return 0;
            int vector = Follow(at);
            count = Int32(vector);
            if (count < 0 || count > maxCount)
                throw Broken(At(vector) + "a list of " + count.ToString(CultureInfo.InvariantCulture) + " entries");
            Check(vector + 4L, (long)count * elementBytes);
            return vector + 4;
        }

        /// <summary>The tables of a vector of tables.</summary>
        public int[] Tables(int table, int index, int maxCount)
        {
            int first = VectorField(table, index, 4, maxCount, out int count);
            var tables = new int[count];
            for (int i = 0; i < count; i++)
                tables[i] = Follow(first + 4 * i);
            return tables;
        }

        public int[] Int32s(int table, int index, int maxCount)
        {
            int first = VectorField(table, index, 4, maxCount, out int count);
            var values = new int[count];
            for (int i = 0; i < count; i++)
                values[i] = Int32(first + 4 * i);
            return values;
        }

        public ReadOnlySpan<byte> Bytes(int at, int count)
        {
            Check(at, count);
            return new ReadOnlySpan<byte>(_bytes, at, count);
        }

        private int Follow(int at)
        {
            uint offset = BinaryPrimitives.ReadUInt32LittleEndian(Bytes(at, 4));
            Check(at + (long)offset, 4);
            return (int)(at + offset);
        }

        private int Int32(int at) => BinaryPrimitives.ReadInt32LittleEndian(Bytes(at, 4));

        private int UInt16(long at)
        {
            Check(at, 2);
            return BinaryPrimitives.ReadUInt16LittleEndian(new ReadOnlySpan<byte>(_bytes, (int)at, 2));
        }

        private void Check(long at, long count)
        {
            if (at < 0 || count < 0 || at + count > _bytes.Length)
                throw Broken(At(at) + "a reference leads out of the file's " + _bytes.Length.ToString(CultureInfo.InvariantCulture) + " bytes");
        }

        private static string At(long at) => "byte " + at.ToString(CultureInfo.InvariantCulture) + ": ";
    }
}
