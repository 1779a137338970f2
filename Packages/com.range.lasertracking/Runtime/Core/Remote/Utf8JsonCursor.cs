using System;
using System.Buffers.Text;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Walks over the members of an object or the elements of a list in a text that <see cref="Utf8JsonText"/> has found well-formed.
    /// Values come as the bytes they are written with. No allocation.
    /// </summary>
    internal ref struct Utf8JsonCursor
    {
        private readonly ReadOnlySpan<byte> _text;
        private readonly bool _isObject;
        private int _at;

        /// <param name="text">An object or list, white space around it allowed.</param>
        public Utf8JsonCursor(ReadOnlySpan<byte> text)
        {
            _text = text;
            _at = Utf8JsonText.SkipSpace(text, 0);
            _isObject = text[_at] == '{';
            _at++;
        }

        /// <param name="name">Without quotes, escapes as they stand; empty in a list.</param>
        /// <param name="value">As it is written.</param>
        public bool TryNext(out ReadOnlySpan<byte> name, out ReadOnlySpan<byte> value)
        {
            name = default;
            value = default;
            _at = Utf8JsonText.SkipSpace(_text, _at);
            if (_text[_at] == '}' || _text[_at] == ']')
                return false;
            if (_text[_at] == ',')
                _at = Utf8JsonText.SkipSpace(_text, _at + 1);
            if (_isObject)
            {
                int nameEnd = Utf8JsonText.Value(_text, _at, 0);
                name = _text.Slice(_at + 1, nameEnd - _at - 2);
                _at = Utf8JsonText.SkipSpace(_text, nameEnd) + 1;
                _at = Utf8JsonText.SkipSpace(_text, _at);
            }

            int end = Utf8JsonText.Value(_text, _at, int.MaxValue);
            value = _text.Slice(_at, end - _at);
            _at = end;
            return true;
        }

        public static bool Is(ReadOnlySpan<byte> bytes, string ascii)
        {
            if (bytes.Length != ascii.Length)
                return false;
            for (int i = 0; i < ascii.Length; i++)
            {
                if (bytes[i] != ascii[i])
                    return false;
            }

            return true;
        }

        /// <summary>False for anything but a number; what is too large for a double is infinite.</summary>
        public static bool TryNumber(ReadOnlySpan<byte> value, out double number)
        {
            number = double.NaN;
            if (value[0] != '-' && (value[0] < '0' || value[0] > '9'))
                return false;
            if (!Utf8Parser.TryParse(value, out number, out int used) || used != value.Length)
                number = double.PositiveInfinity;
            return true;
        }

        /// <summary>False for anything but a number written without fraction and exponent that fits.</summary>
        public static bool TryInteger(ReadOnlySpan<byte> value, out long number) =>
            Utf8Parser.TryParse(value, out number, out int used) && used == value.Length;

        /// <summary>[x,y,…] or {"x":…,"y":…,"z":…}, exactly as many numbers as there is room.</summary>
        public static bool TryNumbers(ReadOnlySpan<byte> value, Span<double> numbers)
        {
            if (value[0] != '[' && value[0] != '{')
                return false;
            var elements = new Utf8JsonCursor(value);
            int count = 0, known = 0;
            while (elements.TryNext(out ReadOnlySpan<byte> name, out ReadOnlySpan<byte> element))
            {
                int at = value[0] == '[' ? count : name.Length == 1 ? name[0] - 'x' : -1;
                if (at < 0 || at >= numbers.Length || !TryNumber(element, out numbers[at]))
                    return false;
                known |= 1 << at;
                count++;
            }

            return count == numbers.Length && known == (1 << count) - 1;
        }
    }
}
