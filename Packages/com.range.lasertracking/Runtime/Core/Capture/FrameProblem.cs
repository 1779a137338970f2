namespace LaserTracking.Capture
{
    /// <summary>One piece of damage in an input that is otherwise usable.</summary>
    public readonly struct FrameProblem
    {
        /// <param name="offset">Byte offset in the file, or -1 when it has no place there.</param>
        /// <param name="what">One line: what is wrong and what was done about it.</param>
        /// <param name="frameIndex">The frame it belongs to, or -1.</param>
        public FrameProblem(long offset, string what, int frameIndex = -1)
        {
            Offset = offset;
            What = what;
            FrameIndex = frameIndex;
        }

        public long Offset { get; }

        public string What { get; }

        public int FrameIndex { get; }
    }
}
