using LaserTracking.Session;

namespace LaserTracking.Health
{
    /// <summary>Says things about one frame after the other to a sink.</summary>
    internal sealed class HealthWriter
    {
        private readonly IEventSink _sink;
        private int _frameIndex;

        public HealthWriter(IEventSink sink) => _sink = sink;

        /// <summary>Time of the frame spoken of, µs.</summary>
        public long TimeUs { get; private set; }

        /// <summary>What is said from now on is about this frame.</summary>
        public void Begin(int frameIndex, long timeUs)
        {
            _frameIndex = frameIndex;
            TimeUs = timeUs;
        }

        public void Say(HealthKind kind, double value, string text) =>
            _sink.OnHealth(new HealthEvent { FrameIndex = _frameIndex, TimeUs = TimeUs, Kind = kind, Value = value, Text = text });
    }
}
