using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>A green spot that the colour picture showed without having to change, and for how long it has been there.</summary>
    internal struct RestingDot
    {
        public Vector2D PositionPx;
        public int Frames;
        public Spot Spot;
        public double RelativeRise;
        public int Peak;
    }
}
