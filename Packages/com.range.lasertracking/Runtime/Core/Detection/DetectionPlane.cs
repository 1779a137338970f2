namespace LaserTracking.Detection
{
    /// <summary>What is searched: saturated dots raise the smallest channel as nothing else does, faint ones only the largest.</summary>
    internal enum DetectionPlane : byte
    {
        Smallest = 0,
        Largest = 1,
    }
}
