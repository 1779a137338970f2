namespace LaserTracking.Editor
{
    /// <summary>One line of the set-up window.</summary>
    public readonly struct SetupLine
    {
        public SetupLine(string name, SetupState state, string text)
        {
            Name = name;
            State = state;
            Text = text;
        }

        /// <summary>What it is about: "screen".</summary>
        public string Name { get; }

        public SetupState State { get; }

        /// <summary>How it stands and, where something is missing, what to do.</summary>
        public string Text { get; }
    }
}
