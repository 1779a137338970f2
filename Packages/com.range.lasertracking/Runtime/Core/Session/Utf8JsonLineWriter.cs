using System;
using LaserTracking.Geometry;

namespace LaserTracking.Session
{
    /// <summary>
    /// Writes JSON objects, one a line, into a byte buffer that grows until it fits and is then used again: no allocation once
    /// warm. UTF-8 without byte order mark, no spaces, LF. What JSON cannot say (NaN, infinity) becomes null. One thread.
    /// </summary>
    public sealed class Utf8JsonLineWriter
    {
        private byte[] _buffer;
        private bool _needsComma;

        public Utf8JsonLineWriter(int capacity = 1024)
        {
            _buffer = new byte[Math.Max(capacity, 2 * FixedDecimal.MaximumLength)];
        }

        /// <summary>Bytes written since the last <see cref="Clear"/>.</summary>
        public int Length { get; private set; }

        public ReadOnlySpan<byte> Written => new ReadOnlySpan<byte>(_buffer, 0, Length);

        public void Clear()
        {
            Length = 0;
            _needsComma = false;
        }

        public void BeginObject() => Open('{');

        public void EndObject() => Close('}');

        public void BeginArray() => Open('[');

        public void EndArray() => Close(']');

        /// <summary>Ends the line after an object.</summary>
        public void EndLine()
        {
            Put((byte)'\n');
            _needsComma = false;
        }

        /// <summary>The name of the member whose value follows. Names are plain ASCII and not escaped.</summary>
        public void Name(string name)
        {
            Separate();
            Put((byte)'"');
            Reserve(name.Length + 2);
            foreach (char c in name)
                _buffer[Length++] = (byte)c;
            Put((byte)'"');
            Put((byte)':');
            _needsComma = false;
        }

        public void Null() => Word("null");

        public void True() => Word("true");

        public void Number(long value)
        {
            Separate();
            Reserve(FixedDecimal.MaximumLength);
            Length += FixedDecimal.Write(value, new Span<byte>(_buffer, Length, FixedDecimal.MaximumLength));
            _needsComma = true;
        }

        /// <summary>A number with at most this many decimals; null when it is not finite.</summary>
        public void Number(double value, int decimals)
        {
            Separate();
            Reserve(FixedDecimal.MaximumLength);
            int length = FixedDecimal.Write(value, decimals, new Span<byte>(_buffer, Length, FixedDecimal.MaximumLength));
            Length += length;
            if (length == 0)
                Word("null");
            _needsComma = true;
        }

        /// <summary>[x,y], or null when either is not finite.</summary>
        public void Vector(Vector2D value, int decimals)
        {
            if (!value.IsFinite)
            {
                Null();
                return;
            }

            BeginArray();
            Number(value.X, decimals);
            Number(value.Y, decimals);
            EndArray();
        }

        /// <summary>[x,y,z], or null when one is not finite.</summary>
        public void Vector(Vector3D value, int decimals)
        {
            if (!value.IsFinite)
            {
                Null();
                return;
            }

            BeginArray();
            Number(value.X, decimals);
            Number(value.Y, decimals);
            Number(value.Z, decimals);
            EndArray();
        }

        /// <summary>A string with everything escaped that JSON wants escaped, or null. Lone surrogates become U+FFFD.</summary>
        public void Text(string? value)
        {
            if (value == null)
            {
                Null();
                return;
            }

            Separate();
            Put((byte)'"');
            Reserve(6 * value.Length + 1);
            for (int i = 0; i < value.Length; i++)
            {
                char c = value[i];
                if (char.IsHighSurrogate(c) && i + 1 < value.Length && char.IsLowSurrogate(value[i + 1]))
                    PutUtf8(char.ConvertToUtf32(c, value[++i]));
                else
                    PutEscaped(char.IsSurrogate(c) ? '\uFFFD' : c);
            }

            Put((byte)'"');
            _needsComma = true;
        }

        private void PutEscaped(char c)
        {
            int escape = "\"\\\b\f\n\r\t".IndexOf(c);
            if (escape >= 0)
            {
                _buffer[Length++] = (byte)'\\';
                _buffer[Length++] = (byte)"\"\\bfnrt"[escape];
            }
            else if (c < ' ')
            {
                _buffer[Length++] = (byte)'\\';
                _buffer[Length++] = (byte)'u';
                _buffer[Length++] = (byte)'0';
                _buffer[Length++] = (byte)'0';
                _buffer[Length++] = (byte)('0' + (c >> 4));
                _buffer[Length++] = (byte)"0123456789abcdef"[c & 15];
            }
            else
            {
                PutUtf8(c);
            }
        }

        private void PutUtf8(int codePoint)
        {
            if (codePoint < 0x80)
            {
                _buffer[Length++] = (byte)codePoint;
                return;
            }

            if (codePoint < 0x800)
            {
                _buffer[Length++] = (byte)(0xC0 | codePoint >> 6);
            }
            else
            {
                if (codePoint < 0x10000)
                {
                    _buffer[Length++] = (byte)(0xE0 | codePoint >> 12);
                }
                else
                {
                    _buffer[Length++] = (byte)(0xF0 | codePoint >> 18);
                    _buffer[Length++] = (byte)(0x80 | codePoint >> 12 & 0x3F);
                }

                _buffer[Length++] = (byte)(0x80 | codePoint >> 6 & 0x3F);
            }

            _buffer[Length++] = (byte)(0x80 | codePoint & 0x3F);
        }

        private void Word(string word)
        {
            Separate();
            Reserve(word.Length);
            foreach (char c in word)
                _buffer[Length++] = (byte)c;
            _needsComma = true;
        }

        private void Open(char bracket)
        {
            Separate();
            Put((byte)bracket);
            _needsComma = false;
        }

        private void Close(char bracket)
        {
            Put((byte)bracket);
            _needsComma = true;
        }

        private void Separate()
        {
            if (_needsComma)
                Put((byte)',');
            _needsComma = false;
        }

        private void Put(byte value)
        {
            Reserve(1);
            _buffer[Length++] = value;
        }

        private void Reserve(int bytes)
        {
            if (Length + bytes > _buffer.Length)
                Array.Resize(ref _buffer, Math.Max(Length + bytes, 2 * _buffer.Length));
        }
    }
}
