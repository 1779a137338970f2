using LaserTracking.Host.Scoring;

namespace LaserTracking.Host.Studies.Simulated
{
    /// <summary>A simulated shot as the camera saw it.</summary>
    /// <param name="Truth">Frames and places.</param>
    /// <param name="Rise">How far the best pixel near it rose, in its strongest channel and its best frame, above itself in the frame before the shot, share of the room left there, 0…1.</param>
    /// <param name="RiseLevels">The same in levels of the strongest channel.</param>
    /// <param name="RiseOfAll">The same of the weakest channel: what light that saturates raises.</param>
    /// <param name="BestFrame">The frame in which it rose most.</param>
    /// <param name="PulseMs">How long the light was on.</param>
    internal sealed record TracedShot(TruthShot Truth, double Rise, double RiseLevels, double RiseOfAll, int BestFrame, double PulseMs)
    {
        public bool IsFound { get; set; }
    }
}
