using System.Collections.Generic;
using LaserTracking.Host.Studies.Clips;
using LaserTracking.Host.Studies.Measuring;
using LaserTracking.Host.Studies.Multiuser;
using LaserTracking.Host.Studies.Simulated;
using LaserTracking.Host.Studies.Dual;
using LaserTracking.Host.Studies.Tracks;

namespace LaserTracking.Host.Studies
{
    /// <summary>All studies by the names of the command line.</summary>
    internal static class StudyList
    {
        public static IReadOnlyList<IStudy> All { get; } = new IStudy[]
        {
            new ClipStressStudy(),
            new AmbientStudy(),
            new AdvisorStudy(),
            new Moving.MovingStudy(),
            new PastedDotsStudy(),
            new PositionStudy(),
            new EllipseStudy(),
            new ConfidenceStudy(),
            new TimingStudy(),
            new ColorStudy(),
            new StaticStudy(),
            new FrameRateStudy(),
            new DotTracksStudy(),
            new MultiuserStudy(),
            new Calibration.ScreenCalibrationStudy(),
            new Calibration.BoardStudy(),
            new Drift.DriftStudy(),
            new RemoteFloodStudy(),
            new SessionStudy(),
        };
    }
}
