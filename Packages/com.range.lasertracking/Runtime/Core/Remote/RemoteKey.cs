using System;
using System.IO;
using System.Text;

namespace LaserTracking.Remote
{
    /// <summary>A secret of 16…64 bytes that sender and receiver share, written as hexadecimal digits. Immutable.</summary>
    public sealed class RemoteKey
    {
        private const int LeastBytes = 16;
        private const int MostBytes = 64;
        private const long MostFileBytes = 1024;

        private readonly byte[] _bytes;

        private RemoteKey(byte[] bytes)
        {
            _bytes = bytes;
        }

        /// <summary>A copy, for the algorithm.</summary>
        internal byte[] ToArray() => (byte[])_bytes.Clone();

        /// <param name="text">32…128 hexadecimal digits; white space around them is passed over.</param>
        /// <param name="source">What it is called in the message.</param>
        /// <exception cref="InputException">It is no key; the message does not repeat it.</exception>
        public static RemoteKey Parse(string text, string source)
        {
            string digits = text.Trim();
            if (digits.Length % 2 != 0 || digits.Length < 2 * LeastBytes || digits.Length > 2 * MostBytes)
                throw Wrong(source);
            var bytes = new byte[digits.Length / 2];
            for (int i = 0; i < bytes.Length; i++)
            {
                int high = Digit(digits[2 * i]), low = Digit(digits[2 * i + 1]);
                if (high < 0 || low < 0)
                    throw Wrong(source);
                bytes[i] = (byte)(high << 4 | low);
            }

            return new RemoteKey(bytes);
        }

        /// <exception cref="InputException">The file cannot be read or holds no key.</exception>
        public static RemoteKey ReadFile(string path)
        {
            try
            {
                if (new FileInfo(path).Length > MostFileBytes)
                    throw Wrong(path);
                return Parse(File.ReadAllText(path, Encoding.UTF8), path);
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException || e is ArgumentException || e is NotSupportedException)
            {
                throw new InputException(path, "the key cannot be read", "check its name and rights");
            }
        }

        private static InputException Wrong(string source) =>
            new InputException(source, "this is no key of 32 to 128 hexadecimal digits", "make one, for example with: openssl rand -hex 32");

        private static int Digit(char c) =>
            c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    }
}
