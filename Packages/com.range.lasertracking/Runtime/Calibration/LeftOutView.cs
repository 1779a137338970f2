namespace LaserTracking.Calibration
{
    /// <summary>A view that a calibration did without, and why.</summary>
    public readonly struct LeftOutView
    {
        public readonly string Name;

        /// <summary>One line, without the view's name.</summary>
        public readonly string Reason;

        public LeftOutView(string name, string reason)
        {
            Name = name;
            Reason = reason;
        }
    }
}
