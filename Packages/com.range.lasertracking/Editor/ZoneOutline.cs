using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using LaserTracking.Unity;
using UnityEngine;

namespace LaserTracking.Editor
{
    /// <summary>Outlines of a target's zones as a picture of it: y down, scaled to fit.</summary>
    public sealed class ZoneOutline
    {
        private const int EllipseCorners = 48;
        private const float Margin = 8;

        private readonly Vector2D _centerPx;
        private readonly double _pxPerM;

        /// <param name="sizeM">Of the box that holds all zones.</param>
        /// <param name="area">Where the picture goes.</param>
        public ZoneOutline(Vector2D sizeM, Rect area)
        {
            _centerPx = new Vector2D(area.x + area.width / 2, area.y + area.height / 2);
            _pxPerM = Math.Max(0, Math.Min((area.width - 2 * Margin) / sizeM.X, (area.height - 2 * Margin) / sizeM.Y));
        }

        /// <summary>The outline of a zone, closed: its last corner is its first.</summary>
        public Vector3[] Of(TargetZone zone)
        {
            IReadOnlyList<Vector2D> corners = CornersM(zone);
            var outline = new Vector3[corners.Count + 1];
            for (int i = 0; i < outline.Length; i++)
                outline[i] = ToPx(corners[i % corners.Count]);
            return outline;
        }

        /// <summary>Where a point of the target lies in the picture.</summary>
        public Vector3 ToPx(Vector2D pointM) => new Vector2D(_centerPx.X + pointM.X * _pxPerM, _centerPx.Y - pointM.Y * _pxPerM).ToUnity();

        private static IReadOnlyList<Vector2D> CornersM(TargetZone zone)
        {
            if (zone.Shape == ZoneShape.Polygon)
                return zone.CornersM;
            Vector2D half = zone.SizeM * 0.5, c = zone.CenterM;
            if (zone.Shape == ZoneShape.Rectangle)
                return new[] { new Vector2D(c.X - half.X, c.Y - half.Y), new Vector2D(c.X + half.X, c.Y - half.Y), new Vector2D(c.X + half.X, c.Y + half.Y), new Vector2D(c.X - half.X, c.Y + half.Y) };
            var ellipse = new Vector2D[EllipseCorners];
            for (int i = 0; i < EllipseCorners; i++)
            {
                double angle = 2 * Math.PI * i / EllipseCorners;
                ellipse[i] = new Vector2D(c.X + half.X * Math.Cos(angle), c.Y + half.Y * Math.Sin(angle));
            }

            return ellipse;
        }
    }
}
