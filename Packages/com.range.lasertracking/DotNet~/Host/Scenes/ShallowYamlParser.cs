using System;
using System.IO;
using YamlDotNet.Core;
using YamlDotNet.Core.Events;

namespace LaserTracking.Host.Scenes
{
    /// <summary>Stops at a depth no Unity file has: the tree is built by recursion, and a damaged file must not exhaust the stack.</summary>
    internal sealed class ShallowYamlParser : IParser
    {
        private const int Deepest = 64;
        private readonly Parser _inner;
        private int _depth;

        public ShallowYamlParser(TextReader text) => _inner = new Parser(text);

        public ParsingEvent? Current => _inner.Current;

        /// <exception cref="YamlException">Broken or too deep.</exception>
        public bool MoveNext()
        {
            bool more = Advance();
            if (more && _inner.Current != null)
            {
                _depth += _inner.Current.NestingIncrease;
                if (_depth > Deepest)
                    throw new YamlException(_inner.Current.Start, _inner.Current.End, "nested too deeply");
            }

            return more;
        }

        private bool Advance()
        {
            try
            {
                return _inner.MoveNext();
            }
            catch (Exception e) when (e is not YamlException and not OutOfMemoryException)
            {
                // On some garbage the scanner fails with exceptions of its own state in place of a syntax error.
                throw new YamlException(Mark.Empty, Mark.Empty, "not YAML", e);
            }
        }
    }
}
