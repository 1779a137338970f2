using System;
using LaserTracking.Geometry;
using LaserTracking.Host.Explanations;
using LaserTracking.Host.Pictures;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Calibration
{
    /// <summary>
    /// The errors of a calibration over the screen: every point where it was projected, coloured by its error with its direction as a
    /// stroke, the points that were not measured with the reason, and the nine parts with their figures.
    /// </summary>
    internal static class ErrorMap
    {
        private const int ScreenWidth = 1200, Margin = 24, Head = 66, Foot = 76;
        private const uint Grid = 0x3A4452, Covered = 0x6B7787, Outside = 0x3F74C9, Unclear = 0xC9A23F;

        public static Canvas Draw(ScreenCalibration found, Vector2D sizeM, double limitMm)
        {
            int width = ScreenWidth, height = (int)Math.Round(Math.Clamp(width * sizeM.Y / sizeM.X, 300, 1600));
            var canvas = new Canvas(width + 2 * Margin, height + Head + Foot, Palette.Background);
            canvas.Fill(Margin, Head, width, height, Palette.Panel);
            canvas.Outline(Margin - 2, Head - 2, width + 4, height + 4, Palette.Quiet, 2);
            for (int i = 1; i < ScreenRegion.Across; i++)
                canvas.Fill(Margin + i * width / ScreenRegion.Across, Head, 2, height, Grid);
            for (int i = 1; i < ScreenRegion.Down; i++)
                canvas.Fill(Margin, Head + i * height / ScreenRegion.Down, width, 2, Grid);
            (int X, int Y) At(Vector2D place) => (Margin + (int)Math.Round(place.X * width), Head + (int)Math.Round(place.Y * height));

            foreach (ScreenPoint[] board in new[] { found.View.First, found.View.Second })
            {
                foreach (ScreenPoint point in board)
                {
                    (int x, int y) = At(point.Place);
                    if (point.State != ScreenPointState.Measured)
                        Cross(canvas, x, y, point.State switch { ScreenPointState.Covered => Covered, ScreenPointState.OutOfPicture => Outside, _ => Unclear });
                }
            }

            double full = FullStrokeMm(found.Errors(true, inMm: true).P95), stroke = width / (3.0 * ScreenBoard.CellsAcross) / full;
            DrawFigures(canvas, found, width, height, limitMm);
            foreach (ScreenCheckPoint check in found.Points)
            {
                (int x, int y) = At(check.Point.Place);
                double mm = check.OffMm.Length, shown = Math.Min(mm, full * 4) / Math.Max(1e-9, mm) * stroke;
                uint color = check.IsLeftOut ? Unclear : Color(mm / limitMm);
                canvas.Line(x, y, x + check.OffMm.X * shown, y + check.OffMm.Y * shown, color, 2);
                int half = check.IsHeldOut ? 4 : 2;
                canvas.Fill(x - half, y - half, 2 * half, 2 * half, color);
            }

            PointErrors all = found.Errors(true, inMm: true), px = found.Errors(true, inMm: false);
            canvas.Text(Margin, 10, FormattableString.Invariant($"{(found.IsAccepted ? "accepted" : "REFUSED")}: {all.Count} held-out points, median {all.Median:F2} mm ({px.Median:F3} px), 95 % {all.P95:F2} mm, worst {all.Max:F2} mm"), found.IsAccepted ? Palette.Passed : Palette.Failed);
            canvas.Text(Margin, 36, FormattableString.Invariant($"limit {limitMm} mm; in each part: median / worst, points; strokes: {full:0.###} mm is a third of a cell"), Palette.Quiet);
            Legend(canvas, Head + height + 14, limitMm);
            return canvas;
        }

        private static void DrawFigures(Canvas canvas, ScreenCalibration found, int width, int height, double limitMm)
        {
            for (int i = 0; i < found.Regions.Length; i++)
            {
                ScreenRegion region = found.Regions[i];
                int x = Margin + i % ScreenRegion.Across * width / ScreenRegion.Across + 10, y = Head + i / ScreenRegion.Across * height / ScreenRegion.Down + 10;
                bool isOver = region.HeldOutMm.Max > limitMm;
                string text = region.HeldOutMm.Count == 0
                    ? "nothing held out"
                    : FormattableString.Invariant($"{region.HeldOutMm.Median:F2} / {region.HeldOutMm.Max:F2} mm");
                int end = canvas.Text(x, y, text, isOver ? Palette.Failed : Palette.Text);
                canvas.Text(end + 14, y, FormattableString.Invariant($"{region.Measured} of {region.Projected}"), Palette.Quiet);
            }
        }

        /// <summary>The round number of millimetres next to an error.</summary>
        private static double FullStrokeMm(double mm)
        {
            double power = Math.Pow(10, Math.Floor(Math.Log10(Math.Max(1e-3, mm))));
            return mm < 1.5 * power ? power : mm < 3.5 * power ? 2 * power : mm < 7 * power ? 5 * power : 10 * power;
        }

        private static void Legend(Canvas canvas, int y, double limitMm)
        {
            int x = Margin;
            foreach (double share in new[] { 0, 0.251, 0.501, 1.01 })
            {
                canvas.Fill(x, y + 2, 14, 14, Color(share));
                x = canvas.Text(x + 20, y, share > 1 ? "over the limit" : FormattableString.Invariant($"from {share * limitMm:0.#} mm"), Palette.Quiet) + 24;
            }

            x = Margin;
            y += 28;
            foreach ((uint color, string text) in new[] { (Covered, "covered or dark"), (Outside, "outside the picture"), (Unclear, "unclear or left out") })
            {
                Cross(canvas, x + 7, y + 8, color);
                x = canvas.Text(x + 20, y, text, Palette.Quiet) + 24;
            }

            canvas.Text(x, y, "large: held out, small: fit", Palette.Quiet);
        }

        private static uint Color(double share) => share > 1 ? Palette.Failed : share > 0.5 ? Palette.Waiting : share > 0.25 ? Palette.Dot : Palette.Passed;

        private static void Cross(Canvas canvas, int x, int y, uint color)
        {
            canvas.Line(x - 5, y - 5, x + 5, y + 5, color, 2);
            canvas.Line(x - 5, y + 5, x + 5, y - 5, color, 2);
        }
    }
}
