using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>A pulse of light after every random choice has been made. Times are true seconds.</summary>
    internal sealed class PlannedShot
    {
        public PlannedShot(double startS, double pulseS, int shooter, int target, Vector2D pointM, Vector2D sweepMPerS)
        {
            StartS = startS;
            EndS = startS + pulseS;
            Shooter = shooter;
            Target = target;
            PointM = pointM;
            SweepMPerS = sweepMPerS;
        }

        public double StartS { get; }

        public double EndS { get; }

        /// <summary>0-based.</summary>
        public int Shooter { get; }

        /// <summary>Index of the scene object aimed at, or -1.</summary>
        public int Target { get; }

        /// <summary>In the target's plane, or on the screen when there is no target.</summary>
        public Vector2D PointM { get; }

        public Vector2D SweepMPerS { get; }
    }
}
