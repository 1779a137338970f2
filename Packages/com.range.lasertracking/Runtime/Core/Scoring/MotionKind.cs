namespace LaserTracking.Scoring
{
    /// <summary>How a target moves with time.</summary>
    public enum MotionKind
    {
        None = 0,

        /// <summary>At constant speed from rest to rest + travel and back; one period there and back.</summary>
        PingPong = 1,

        /// <summary>rest + travel · sin(2π t / period).</summary>
        Sine = 2,

        /// <summary>On an ellipse in the plane z = const with half axes travel.x and travel.y.</summary>
        Circle = 3,
    }
}
