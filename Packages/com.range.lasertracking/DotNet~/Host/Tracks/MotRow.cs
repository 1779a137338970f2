using LaserTracking.Tracking;

namespace LaserTracking.Host.Tracks
{
    /// <summary>One line of a MOT15 text file.</summary>
    /// <param name="Frame">From 1.</param>
    /// <param name="Id">-1 in files of detections.</param>
    /// <param name="Box">Px.</param>
    /// <param name="Score">Confidence of a detection; in files of truth 0: not to be counted. 1 where the line ends before it.</param>
    internal readonly record struct MotRow(int Frame, int Id, BoundingBox Box, double Score);
}
