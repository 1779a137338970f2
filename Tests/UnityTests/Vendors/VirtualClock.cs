namespace LaserTracking.Unity
{
    /// <summary>A host's clock that goes on by a frame whenever a source asks it: seconds pass in milliseconds.</summary>
    internal sealed class VirtualClock
    {
        private long _us = 1_000_000;

        public long StepUs { get; set; } = 16_667;

        public long NowUs() => _us += StepUs;
    }
}
