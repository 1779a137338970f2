using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Pictures;

namespace LaserTracking.Host.Explanations
{
    /// <summary>One place magnified: before, now, what its past explains, how far it rose; beside it the candidate's table or why there is none.</summary>
    internal static class SpotPicture
    {
        private const int PixelSize = 7;
        private const int Margin = ExplanationPicture.Margin;
        private const int ReasonLetters = 58;

        public static Canvas Draw(ExplainedFrame frame, Vector2D atPx)
        {
            ExplainedCandidate? candidate = frame.At(atPx);
            List<string> reasons = candidate == null ? SpotReason.Lines(frame, atPx) : new List<string>();
            int panel = frame.Spot is { IsSearched: true } seen ? seen.Side * PixelSize : 0, step = panel + Margin;
            (int magnification, int reduction) = ExplanationPicture.Scale(frame.Picture.Width, 640);
            int frameWidth = frame.Picture.Width / reduction * magnification, frameHeight = frame.Picture.Height / reduction * magnification;
            int left = Math.Max(frameWidth, panel == 0 ? 0 : 3 * step - Margin);
            int panels = panel == 0 ? 0 : 2 * (panel + CandidateCard.LineHeight + Margin);
            int right = Math.Max(CandidateCard.Width, ReasonLetters * 2 * BitmapFont.Advance);
            int cardHeight = candidate == null ? reasons.Count * 3 * CandidateCard.LineHeight : CandidateCard.Height(candidate);
            int top = Margin + 3 * CandidateCard.LineHeight;
            var canvas = new Canvas(left + right + 3 * Margin, top + Math.Max(panels + frameHeight, cardHeight) + Margin, Palette.Background);
            top = Math.Max(top, ExplanationPicture.DrawTitle(canvas, frame));
            if (panel > 0)
                DrawPanels(canvas, frame, frame.Spot!, candidate, top);
            int frameTop = top + panels;
            ExplanationPicture.DrawFrame(canvas, frame, Margin, frameTop, magnification, reduction, candidate == null ? [] : [candidate]);
            Cross(canvas, Margin + (int)((atPx.X + 0.5) * magnification / reduction), frameTop + (int)((atPx.Y + 0.5) * magnification / reduction), 26, 10);
            int x = left + 2 * Margin;
            if (candidate != null)
                CandidateCard.Draw(canvas, x, top, candidate);
            else
                DrawReasons(canvas, x, top, atPx, reasons);
            return canvas;
        }

        private static void DrawReasons(Canvas canvas, int x, int y, Vector2D atPx, List<string> reasons)
        {
            canvas.Text(x, y, FormattableString.Invariant($"no candidate at {atPx.X:0.##}, {atPx.Y:0.##}"), Palette.Asked);
            y += CandidateCard.LineHeight + 6;
            for (int i = 0; i < reasons.Count; i++)
                y = CandidateCard.Lines(canvas, x, y, reasons[i], i == 0 ? Palette.Waiting : Palette.Text, ReasonLetters) + 4;
        }

        private static void DrawPanels(Canvas canvas, ExplainedFrame frame, SpotTrace spot, ExplainedCandidate? candidate, int top)
        {
            // One scale for both: what hardly rose is to be seen as well.
            int white = Math.Max(8, spot.Rise(true).ToArray().Concat(spot.Rise(false).ToArray()).Max(v => (int)v));
            uint[][] pictures =
            {
                spot.Before.ToArray(), spot.Now.ToArray(), Heat(spot.Rise(true), white),
                Gray(spot.Envelope(true)), Gray(spot.Envelope(false)), Heat(spot.Rise(false), white),
            };
            string scale = FormattableString.Invariant($" (0…{white / 255.0:0.##})");
            string[] names = { "frame before", "this frame", "rise, smallest" + scale, "past, smallest channel", "past, largest channel", "rise, largest" + scale };
            int size = spot.Side * PixelSize;
            for (int i = 0; i < pictures.Length; i++)
            {
                int x = Margin + i % 3 * (size + Margin), y = top + i / 3 * (size + CandidateCard.LineHeight + Margin);
                canvas.Text(x, y, names[i], Palette.Quiet);
                y += CandidateCard.LineHeight;
                canvas.Magnify(pictures[i], spot.Side, x, y, PixelSize);
                bool isRise = i % 3 == 2;
                if (isRise && candidate != null && candidate.IsSmallestChannel == (i == 2))
                    Contour(canvas, spot, i == 2, candidate, x, y);
                if (i == 1)
                    Boxes(canvas, frame, spot, candidate, x, y);
                if (candidate == null)
                    Cross(canvas, x + spot.Radius * PixelSize + PixelSize / 2, y + spot.Radius * PixelSize + PixelSize / 2, 24, 10);
            }
        }

        /// <summary>The outline of what rose at least half as far as the candidate's seed.</summary>
        private static void Contour(Canvas canvas, SpotTrace spot, bool ofSmallest, ExplainedCandidate candidate, int x0, int y0)
        {
            (int seedX, int seedY) = Place(spot, candidate.SeedPx);
            if (seedX < 0 || seedY < 0 || seedX >= spot.Side || seedY >= spot.Side)
                return;
            byte[] rise = spot.Rise(ofSmallest).ToArray();
            int threshold = Math.Max(1, (rise[seedY * spot.Side + seedX] + 1) / 2);
            bool IsIn(int x, int y) => x >= 0 && y >= 0 && x < spot.Side && y < spot.Side && rise[y * spot.Side + x] >= threshold;
            for (int y = 0; y < spot.Side; y++)
            {
                for (int x = 0; x < spot.Side; x++)
                {
                    if (!IsIn(x, y))
                        continue;
                    int left = x0 + x * PixelSize, top = y0 + y * PixelSize;
                    canvas.Fill(left, top, IsIn(x - 1, y) ? 0 : 1, PixelSize, Palette.Shot);
                    canvas.Fill(left + PixelSize - 1, top, IsIn(x + 1, y) ? 0 : 1, PixelSize, Palette.Shot);
                    canvas.Fill(left, top, PixelSize, IsIn(x, y - 1) ? 0 : 1, Palette.Shot);
                    canvas.Fill(left, top + PixelSize - 1, PixelSize, IsIn(x, y + 1) ? 0 : 1, Palette.Shot);
                }
            }
        }

        private static void Boxes(Canvas canvas, ExplainedFrame frame, SpotTrace spot, ExplainedCandidate? chosen, int x0, int y0)
        {
            int size = spot.Side * PixelSize;
            foreach (ExplainedCandidate candidate in frame.Candidates.Where(c => chosen == null || c == chosen))
            {
                (int left, int top) = Place(spot, candidate.TopLeftPx);
                (int right, int bottom) = Place(spot, candidate.BottomRightPx);
                if (right < 0 || bottom < 0 || left >= spot.Side || top >= spot.Side)
                    continue;
                int x = Math.Max(0, left * PixelSize - 2), y = Math.Max(0, top * PixelSize - 2);
                int endX = Math.Min(size, (right + 1) * PixelSize + 2), endY = Math.Min(size, (bottom + 1) * PixelSize + 2);
                canvas.Outline(x0 + x, y0 + y, endX - x, endY - y, Palette.Of(candidate.State));
            }
        }

        /// <summary>Searched pixel inside what is kept.</summary>
        private static (int X, int Y) Place(SpotTrace spot, Vector2D px)
        {
            int Axis(double value, double center) => (int)Math.Floor((value + 0.5) / spot.Factor) - (int)(center + 0.5) / spot.Factor + spot.Radius;
            return (Axis(px.X, spot.AtPx.X), Axis(px.Y, spot.AtPx.Y));
        }

        private static void Cross(Canvas canvas, int x, int y, int reach, int gap)
        {
            canvas.Fill(x - reach, y - 1, reach - gap, 2, Palette.Asked);
            canvas.Fill(x + gap, y - 1, reach - gap, 2, Palette.Asked);
            canvas.Fill(x - 1, y - reach, 2, reach - gap, Palette.Asked);
            canvas.Fill(x - 1, y + gap, 2, reach - gap, Palette.Asked);
        }

        private static uint[] Heat(ReadOnlySpan<byte> values, int white) => values.ToArray().Select(v => Palette.Heat(v * 255 / white)).ToArray();

        private static uint[] Gray(ReadOnlySpan<byte> values) => values.ToArray().Select(v => v * 0x010101u).ToArray();
    }
}
