using System;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Is it UTF-8, is it JSON (RFC 8259, without leniency)? Newtonsoft's reader would make strings of whatever strangers send and
    /// lets through what JSON does not know (NaN, comments, single quotes); this one allocates nothing and goes no deeper than told.
    /// </summary>
    internal static class Utf8JsonText
    {
        /// <summary>No overlong forms, no surrogates, nothing above U+10FFFF, nothing cut off.</summary>
        public static bool IsUtf8(ReadOnlySpan<byte> bytes)
        {
            for (int i = 0; i < bytes.Length;)
            {
                byte first = bytes[i++];
                if (first < 0x80)
                    continue;
                int more = first >= 0xC2 && first <= 0xDF ? 1 : first >= 0xE0 && first <= 0xEF ? 2 : first >= 0xF0 && first <= 0xF4 ? 3 : 0;
                if (more == 0 || bytes.Length - i < more)
                    return false;
                byte least = first == 0xE0 ? (byte)0xA0 : first == 0xF0 ? (byte)0x90 : (byte)0x80;
                byte most = first == 0xED ? (byte)0x9F : first == 0xF4 ? (byte)0x8F : (byte)0xBF;
                if (bytes[i] < least || bytes[i] > most)
                    return false;
                for (int k = 1; k < more; k++)
                {
                    if ((bytes[i + k] & 0xC0) != 0x80)
                        return false;
                }

                i += more;
            }

            return true;
        }

        /// <summary>One JSON object with nothing but white space around it.</summary>
        /// <param name="text">UTF-8.</param>
        /// <param name="maximumDepth">Objects and lists within each other, the outermost counted.</param>
        public static bool IsObject(ReadOnlySpan<byte> text, int maximumDepth)
        {
            int at = SkipSpace(text, 0);
            if (at == text.Length || text[at] != '{')
                return false;
            at = Value(text, at, maximumDepth);
            return at > 0 && SkipSpace(text, at) == text.Length;
        }

        public static int SkipSpace(ReadOnlySpan<byte> text, int at)
        {
            while (at < text.Length && (text[at] == ' ' || text[at] == '\t' || text[at] == '\n' || text[at] == '\r'))
                at++;
            return at;
        }

        /// <summary>Where the value that begins here ends, or -1: none does.</summary>
        public static int Value(ReadOnlySpan<byte> text, int at, int depth)
        {
            if (at >= text.Length)
                return -1;
            switch (text[at])
            {
                case (byte)'{':
                case (byte)'[':
                    return depth > 0 ? Container(text, at, depth - 1) : -1;
                case (byte)'"':
                    return Text(text, at);
                case (byte)'t':
                    return Word(text, at, "true");
                case (byte)'f':
                    return Word(text, at, "false");
                case (byte)'n':
                    return Word(text, at, "null");
                default:
                    return Number(text, at);
            }
        }

        private static int Container(ReadOnlySpan<byte> text, int at, int depth)
        {
            bool isObject = text[at] == '{';
            byte close = isObject ? (byte)'}' : (byte)']';
            at = SkipSpace(text, at + 1);
            if (at < text.Length && text[at] == close)
                return at + 1;
            while (true)
            {
                if (isObject)
                {
                    at = at < text.Length && text[at] == '"' ? Text(text, at) : -1;
                    if (at < 0)
                        return -1;
                    at = SkipSpace(text, at);
                    if (at >= text.Length || text[at] != ':')
                        return -1;
                    at = SkipSpace(text, at + 1);
                }

                at = Value(text, at, depth);
                if (at < 0)
                    return -1;
                at = SkipSpace(text, at);
                if (at >= text.Length)
                    return -1;
                if (text[at] == close)
                    return at + 1;
                if (text[at] != ',')
                    return -1;
                at = SkipSpace(text, at + 1);
            }
        }

        private static int Text(ReadOnlySpan<byte> text, int at)
        {
            for (at++; at < text.Length; at++)
            {
                byte c = text[at];
                if (c == '"')
                    return at + 1;
                if (c < ' ')
                    return -1;
                if (c != '\\')
                    continue;
                at++;
                if (at >= text.Length)
                    return -1;
                if (text[at] == 'u')
                {
                    for (int k = 0; k < 4; k++)
                    {
                        at++;
                        if (at >= text.Length || !IsHex(text[at]))
                            return -1;
                    }
                }
                else if ("\"\\/bfnrt".IndexOf((char)text[at]) < 0)
                {
                    return -1;
                }
            }

            return -1;
        }

        private static int Number(ReadOnlySpan<byte> text, int at)
        {
            if (text[at] == '-')
                at++;
            int digits = Digits(text, at);
            if (digits == at || (text[at] == '0' && digits > at + 1))
                return -1;
            at = digits;
            if (at < text.Length && text[at] == '.')
            {
                digits = Digits(text, at + 1);
                if (digits == at + 1)
                    return -1;
                at = digits;
            }

            if (at < text.Length && (text[at] == 'e' || text[at] == 'E'))
            {
                at++;
                if (at < text.Length && (text[at] == '+' || text[at] == '-'))
                    at++;
                digits = Digits(text, at);
                if (digits == at)
                    return -1;
                at = digits;
            }

            return at;
        }

        private static int Digits(ReadOnlySpan<byte> text, int at)
        {
            while (at < text.Length && text[at] >= '0' && text[at] <= '9')
                at++;
            return at;
        }

        private static int Word(ReadOnlySpan<byte> text, int at, string word)
        {
            if (text.Length - at < word.Length)
                return -1;
            for (int i = 0; i < word.Length; i++)
            {
                if (text[at + i] != word[i])
                    return -1;
            }

            return at + word.Length;
        }

        private static bool IsHex(byte c) => c >= '0' && c <= '9' || c >= 'a' && c <= 'f' || c >= 'A' && c <= 'F';
    }
}
