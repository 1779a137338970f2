using System;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>A place at which four cells of a checkerboard may meet, with the two edges that cross in it.</summary>
    internal readonly struct ScreenSaddle
    {
        /// <param name="place">Pixels of the plane it was found in.</param>
        /// <param name="xx">Second derivatives of the brightness.</param>
        /// <param name="xy">The mixed one.</param>
        /// <param name="yy">Along y.</param>
        public ScreenSaddle(Vector2D place, double xx, double xy, double yy)
        {
            Place = place;
            double mean = (xx + yy) / 2, half = (xx - yy) / 2, size = Math.Sqrt(half * half + xy * xy);
            Strength = size * size - mean * mean;
            DoubledBright = Math.Atan2(xy, half);
            double opening = Math.Acos(Math.Max(-1, Math.Min(1, -mean / size)));
            FirstEdge = Direction((DoubledBright - opening) / 2);
            SecondEdge = Direction((DoubledBright + opening) / 2);
        }

        public Vector2D Place { get; }

        /// <summary>Minus the determinant of the second derivatives: above zero at a saddle.</summary>
        public double Strength { get; }

        /// <summary>Unit vectors along the edges, where the brightness neither rises nor falls.</summary>
        public Vector2D FirstEdge { get; }

        public Vector2D SecondEdge { get; }

        /// <summary>Twice the angle of the line through the two bright cells: the opposite at the next corner along an edge.</summary>
        private double DoubledBright { get; }

        /// <summary>Bright where the other is dark, as neighbours on a checkerboard are.</summary>
        public bool IsOpposite(in ScreenSaddle other) => Math.Cos(DoubledBright - other.DoubledBright) < -0.4;

        private static Vector2D Direction(double angle) => new Vector2D(Math.Cos(angle), Math.Sin(angle));
    }
}
