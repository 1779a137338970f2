using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>One scoring area in the target's plane: metres, x right, y up, origin at the target's centre.</summary>
    public sealed class TargetZone
    {
        private readonly Vector2D[] _corners;

        /// <param name="name">As shown to trainers: "A", "10", "head".</param>
        /// <param name="points">Score of a hit; negative for a penalty.</param>
        /// <param name="shape">Which outline the other values describe.</param>
        /// <param name="centerM">Centre of ellipse or rectangle; ignored for polygons.</param>
        /// <param name="sizeM">Full width and height of ellipse or rectangle; ignored for polygons.</param>
        /// <param name="cornersM">Corners of a polygon in order, at least three; empty otherwise.</param>
        public TargetZone(string name, int points, ZoneShape shape, Vector2D centerM, Vector2D sizeM, Vector2D[] cornersM)
        {
            if (shape == ZoneShape.Polygon && cornersM.Length < 3)
                throw new ArgumentException("zone " + name + ": a polygon has at least three corners");
            if (shape != ZoneShape.Polygon && !(sizeM.X > 0 && sizeM.Y > 0))
                throw new ArgumentException("zone " + name + ": width and height must be above zero");
            Name = name;
            Points = points;
            Shape = shape;
            CenterM = centerM;
            SizeM = sizeM;
            _corners = (Vector2D[])cornersM.Clone();
        }

        public string Name { get; }

        public int Points { get; }

        public ZoneShape Shape { get; }

        public Vector2D CenterM { get; }

        public Vector2D SizeM { get; }

        public IReadOnlyList<Vector2D> CornersM => _corners;

        /// <summary>True inside and on the border. No allocation.</summary>
        public bool Contains(Vector2D pointM)
        {
            Vector2D d = pointM - CenterM;
            switch (Shape)
            {
                case ZoneShape.Ellipse:
                    double x = 2 * d.X / SizeM.X, y = 2 * d.Y / SizeM.Y;
                    return x * x + y * y <= 1;
                case ZoneShape.Rectangle:
                    return Math.Abs(d.X) <= SizeM.X / 2 && Math.Abs(d.Y) <= SizeM.Y / 2;
                default:
                    return Polygon2D.Contains(_corners, pointM);
            }
        }
    }
}
