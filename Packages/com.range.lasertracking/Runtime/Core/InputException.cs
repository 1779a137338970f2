using System;

namespace LaserTracking
{
    /// <summary>
    /// A file or setting from outside cannot be used at all. The message is one line "SOURCE: what is wrong, where, what to do".
    /// Damage that leaves most of the input usable is reported as a problem or health entry instead, never by an exception.
    /// </summary>
    public sealed class InputException : Exception
    {
        /// <param name="source">File, folder or setting as the user named it.</param>
        /// <param name="what">What is wrong and where (byte, frame, field), without a full stop.</param>
        /// <param name="remedy">What the user can do about it, without a full stop.</param>
        public InputException(string source, string what, string remedy)
            : base(source + ": " + what + "; " + remedy)
        {
        }
    }
}
