using System;
using System.Globalization;
using System.Text;

namespace LaserTracking.Session
{
    /// <summary>
    /// Text of an HTML page that is also well-formed XML. Markup is written as it is, everything that comes from outside is escaped.
    /// Numbers are the same on every machine.
    /// </summary>
    internal sealed class HtmlWriter
    {
        private readonly StringBuilder _text = new StringBuilder(1 << 16);
        private readonly byte[] _digits = new byte[FixedDecimal.MaximumLength];

        public HtmlWriter Raw(string markup)
        {
            _text.Append(markup);
            return this;
        }

        /// <summary>Text or an attribute's value in double quotes.</summary>
        public HtmlWriter Text(string? value)
        {
            if (value == null)
                return this;
            for (int i = 0; i < value.Length; i++)
            {
                char c = value[i];
                switch (c)
                {
                    case '&':
                        _text.Append("&amp;");
                        break;
                    case '<':
                        _text.Append("&lt;");
                        break;
                    case '>':
                        _text.Append("&gt;");
                        break;
                    case '"':
                        _text.Append("&quot;");
                        break;
                    case '\'':
                        _text.Append("&#39;");
                        break;
                    default:
                        if (char.IsHighSurrogate(c) && i + 1 < value.Length && char.IsLowSurrogate(value[i + 1]))
                            _text.Append(c).Append(value[++i]);
                        else
                            _text.Append(IsXml(c) ? c : '\uFFFD');
                        break;
                }
            }

            return this;
        }

        /// <summary>At most this many decimals; a dash for what is no number.</summary>
        public HtmlWriter Number(double value, int decimals)
        {
            int length = FixedDecimal.Write(value, decimals, _digits);
            if (length == 0)
                _text.Append('–');
            for (int i = 0; i < length; i++)
                _text.Append((char)_digits[i]);
            return this;
        }

        /// <summary>Exactly this many decimals, for columns of numbers, with a true minus sign; a dash for what is no number.</summary>
        public HtmlWriter Column(double value, int decimals)
        {
            int length = FixedDecimal.Write(value, decimals, _digits);
            if (length == 0)
                return Raw("–");
            int point = -1;
            for (int i = 0; i < length; i++)
            {
                if (_digits[i] == '.')
                    point = i;
                _text.Append(_digits[i] == '-' ? '−' : (char)_digits[i]);
            }

            if (decimals == 0)
                return this;
            if (point < 0)
                _text.Append('.');
            _text.Append('0', decimals - (point < 0 ? 0 : length - 1 - point));
            return this;
        }

        public HtmlWriter Integer(long value)
        {
            _text.Append(value.ToString(CultureInfo.InvariantCulture));
            return this;
        }

        /// <summary>A share as whole percent; below 100 only when it is.</summary>
        public HtmlWriter Percent(double share)
        {
            double percent = share * 100;
            if (share < 1 && percent > 99)
                percent = Math.Floor(percent);
            return Number(percent, 0).Raw(" %");
        }

        public override string ToString() => _text.ToString();

        private static bool IsXml(char c) => c >= ' ' && !char.IsSurrogate(c) && c < '\uFFFE' || c == '\t' || c == '\n' || c == '\r';
    }
}
