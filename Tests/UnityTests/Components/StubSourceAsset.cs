using System;
using LaserTracking.Capture;

namespace LaserTracking.Unity
{
    /// <summary>Gives the range whatever source a test has made.</summary>
    internal sealed class StubSourceAsset : FrameSourceAsset
    {
        public Func<IFrameSource> Create { get; set; } = () => throw new InputException("stub", "no source", "set one");

        public double Latency { get; set; }

        public bool Live { get; set; }

        public byte[]? Device { get; set; }

        public override byte[]? DeviceCalibration => Device;

        public override bool IsLive => Live;

        public long OffsetUs { get; set; }

        public long? SceneZeroUs { get; set; }

        public override double LatencyS => Latency;

        public override long ClockOffsetUs => OffsetUs;

        public override long? SceneTimeZeroUs => SceneZeroUs;

        public override IFrameSource CreateSource(LaserRange range) => Create();
    }
}
