using System;
using LaserTracking.Geometry;
using LaserTracking.Patterns;
using UnityEngine;
using UnityEngine.UIElements;

namespace LaserTracking.Unity
{
    /// <summary>
    /// The errors of a calibration where they are on the screen: every measured point coloured by its error, the nine parts with their
    /// figures, the verdict.
    /// </summary>
    internal static class CalibrationMap
    {
        private const float PointPx = 6, TextPx = 20;

        private static readonly Color Dark = new Color(0.06f, 0.08f, 0.1f, 1);
        private static readonly Color Good = new Color(0.25f, 0.75f, 0.4f, 1);
        private static readonly Color Fair = new Color(0.9f, 0.75f, 0.25f, 1);
        private static readonly Color Bad = new Color(0.9f, 0.3f, 0.25f, 1);
        private static readonly Color Unknown = new Color(0.55f, 0.6f, 0.65f, 1);

        /// <summary>One sentence: whether it holds, with the figures of the points that the fit has not seen, or why not.</summary>
        public static string Verdict(ScreenCalibration found)
        {
            if (!found.IsAccepted)
                return "refused: " + string.Join("; ", found.Refusals);
            PointErrors errors = found.Errors(true, inMm: true);
            string text = FormattableString.Invariant($"accepted: {errors.Count} held-out points, median {errors.Median:F2} mm, 95 % {errors.P95:F2} mm, worst {errors.Max:F2} mm");
            return found.Notes.Count == 0 ? text : text + "; " + string.Join("; ", found.Notes);
        }

        /// <summary>Fills an element with the map.</summary>
        public static void Show(VisualElement parent, ScreenCalibration found, double limitMm)
        {
            parent.Clear();
            parent.style.backgroundColor = Dark;
            for (int i = 0; i < found.Regions.Length; i++)
                AddRegion(parent, found.Regions[i], i, limitMm);
            foreach (ScreenCheckPoint check in found.Points)
            {
                VisualElement point = PanelElements.Box(parent, "point", check.IsLeftOut ? Unknown : ColorOf(check.OffMm.Length, limitMm), 0);
                point.style.position = Position.Absolute;
                point.style.left = PanelElements.Percent((float)check.Point.Place.X * 100);
                point.style.top = PanelElements.Percent((float)check.Point.Place.Y * 100);
                point.style.width = point.style.height = PointPx;
            }

            VisualElement foot = PanelElements.Box(parent, "verdict", Dark, TextPx);
            foot.style.position = Position.Absolute;
            foot.style.left = foot.style.right = foot.style.bottom = 0f;
            PanelElements.Text(foot, TextPx * 1.3f, found.IsAccepted ? Good : Bad).text = Verdict(found);
        }

        private static void AddRegion(VisualElement parent, ScreenRegion region, int index, double limitMm)
        {
            VisualElement part = PanelElements.Box(parent, region.Name, Dark, TextPx / 2);
            part.style.position = Position.Absolute;
            part.style.left = PanelElements.Percent(index % ScreenRegion.Across * 100f / ScreenRegion.Across);
            part.style.top = PanelElements.Percent(index / ScreenRegion.Across * 100f / ScreenRegion.Down);
            bool isProven = region.HeldOutMm.Count > 0;
            PanelElements.Text(part, TextPx, isProven ? ColorOf(region.HeldOutMm.Max, limitMm) : Unknown).text = isProven
                ? FormattableString.Invariant($"{region.Name}: {region.HeldOutMm.Median:F2} / {region.HeldOutMm.Max:F2} mm, {region.Measured} of {region.Projected} points")
                : region.Name + ": nothing measured";
        }

        private static Color ColorOf(double mm, double limitMm) => mm > limitMm ? Bad : mm > limitMm / 2 ? Fair : Good;
    }
}
