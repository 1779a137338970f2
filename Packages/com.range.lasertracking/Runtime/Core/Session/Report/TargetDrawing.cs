using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Session
{
    /// <summary>Targets as shapes: outlines of zones in the target's plane, and how each kind of target is painted.</summary>
    internal static class TargetDrawing
    {
        /// <summary>Corners of a zone's outline in the target's plane; curves in this many steps.</summary>
        public static List<Vector2D> Outline(TargetZone zone, int steps)
        {
            var points = new List<Vector2D>();
            switch (zone.Shape)
            {
                case ZoneShape.Ellipse:
                    for (int i = 0; i < steps; i++)
                    {
                        double angle = 2 * Math.PI * i / steps;
                        points.Add(zone.CenterM + new Vector2D(zone.SizeM.X / 2 * Math.Cos(angle), zone.SizeM.Y / 2 * Math.Sin(angle)));
                    }

                    break;
                case ZoneShape.Rectangle:
                    points.Add(zone.CenterM + new Vector2D(-zone.SizeM.X / 2, zone.SizeM.Y / 2));
                    points.Add(zone.CenterM + new Vector2D(zone.SizeM.X / 2, zone.SizeM.Y / 2));
                    points.Add(zone.CenterM + new Vector2D(zone.SizeM.X / 2, -zone.SizeM.Y / 2));
                    points.Add(zone.CenterM + new Vector2D(-zone.SizeM.X / 2, -zone.SizeM.Y / 2));
                    break;
                default:
                    points.AddRange(zone.CornersM);
                    break;
            }

            return points;
        }

        /// <summary>The zones from the outermost to the most valuable; false for a zone that cannot be mapped is skipped.</summary>
        public static void Draw(HtmlWriter html, TargetDefinition target, int steps, Mapping map)
        {
            for (int i = target.Zones.Count - 1; i >= 0; i--)
            {
                if (TryMap(Outline(target.Zones[i], steps), map, out List<Vector2D> view))
                    Path(html, view, PaintClass(target, i));
            }
        }

        /// <summary>Only the outline of the whole: the zones that no later zone holds.</summary>
        public static void DrawGhost(HtmlWriter html, TargetDefinition target, int steps, Mapping map)
        {
            if (TryMap(Outline(target.Zones[target.Zones.Count - 1], steps), map, out List<Vector2D> view))
                Path(html, view, "edge");
        }

        public static void Path(HtmlWriter html, List<Vector2D> points, string paintClass, bool closed = true)
        {
            html.Raw("<path class=\"").Raw(paintClass).Raw("\" d=\"");
            for (int i = 0; i < points.Count; i++)
                html.Raw(i == 0 ? "M" : "L").Number(points[i].X, 1).Raw(" ").Number(points[i].Y, 1);
            html.Raw(closed ? "Z\"/>" : "\"/>");
        }

        public static bool TryMap(List<Vector2D> points, Mapping map, out List<Vector2D> view)
        {
            view = new List<Vector2D>(points.Count);
            foreach (Vector2D point in points)
            {
                if (!map(point, out Vector2D mapped))
                    return false;
                view.Add(mapped);
            }

            return view.Count > 0;
        }

        /// <summary>The middle of the most valuable zone: what one aims at.</summary>
        public static TargetZone AimZone(TargetDefinition target)
        {
            TargetZone best = target.Zones[0];
            foreach (TargetZone zone in target.Zones)
            {
                if (zone.Points > best.Points)
                    best = zone;
            }

            return best;
        }

        /// <summary>Middle of a zone's bounding box.</summary>
        public static Vector2D Middle(TargetZone zone)
        {
            Bounds(Outline(zone, 4), out Vector2D low, out Vector2D high);
            return (low + high) * 0.5;
        }

        public static void Bounds(List<Vector2D> points, out Vector2D low, out Vector2D high)
        {
            double left = double.PositiveInfinity, bottom = left, right = -left, top = -left;
            foreach (Vector2D point in points)
            {
                left = Math.Min(left, point.X);
                right = Math.Max(right, point.X);
                bottom = Math.Min(bottom, point.Y);
                top = Math.Max(top, point.Y);
            }

            low = new Vector2D(left, bottom);
            high = new Vector2D(right, top);
        }

        private static string PaintClass(TargetDefinition target, int zone)
        {
            int count = target.Zones.Count;
            switch (target.Kind)
            {
                case TargetKind.SteelPopper:
                    return zone == count - 1 ? "steel" : "steel in";
                case TargetKind.RingPaper:
                    return 2 * zone < count - 1 || count == 1 ? "ring dark" : "ring";
                case TargetKind.NoShoot:
                    return zone == count - 1 ? "noshoot" : "noshoot in";
                default:
                    return zone == count - 1 ? "card" : "card in";
            }
        }

        /// <summary>From the target's plane, metres, to the drawing; false for what cannot be seen.</summary>
        internal delegate bool Mapping(Vector2D localM, out Vector2D view);
    }
}
