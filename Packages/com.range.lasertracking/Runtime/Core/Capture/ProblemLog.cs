using System.Collections.Generic;

namespace LaserTracking.Capture
{
    /// <summary>
    /// Collects what was found damaged, once per byte offset and at most <see cref="Capacity"/> entries, so that a hopeless file
    /// cannot fill the memory. Not thread-safe.
    /// </summary>
    public sealed class ProblemLog
    {
        /// <summary>Most entries that are kept; the last one then says that there are more.</summary>
        public const int Capacity = 200;

        private readonly List<FrameProblem> _problems = new List<FrameProblem>();

        public IReadOnlyList<FrameProblem> Problems => _problems;

        /// <summary>False when an entry for this offset would not be kept: build no message for it.</summary>
        public bool Accepts(long offset)
        {
            if (_problems.Count >= Capacity)
                return false;
            if (offset < 0)
                return true;
            for (int i = _problems.Count - 1; i >= 0; i--)
            {
                if (_problems[i].Offset == offset)
                    return false;
            }

            return true;
        }

        /// <param name="offset">Byte offset in the file, or -1 when it has no place there.</param>
        /// <param name="what">One line: what is wrong and what was done about it.</param>
        /// <param name="frameIndex">The frame it belongs to, or -1.</param>
        public void Add(long offset, string what, int frameIndex = -1)
        {
            if (!Accepts(offset))
                return;
            _problems.Add(_problems.Count == Capacity - 1
                ? new FrameProblem(-1, "there are more problems, which are not listed")
                : new FrameProblem(offset, what, frameIndex));
        }
    }
}
