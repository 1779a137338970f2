using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host.Pictures;

namespace LaserTracking.Host.Explanations
{
    /// <summary>An explanation as a picture: the frame with its candidates on the left, their tables on the right, the rest below.</summary>
    internal static class ExplanationPicture
    {
        public const int Margin = 16;

        private const int CardGap = 10;
        private const int MinHeight = 900;
        private const int MaxLabels = 40;
        private const int MaxNotes = 4;
        private const int MaxColumns = 2;
        private const int MaxRestLines = 24;
        private const int RestLetters = 66;
        private const int Letter = 2 * BitmapFont.Advance;

        /// <param name="frame">What is explained.</param>
        /// <param name="atPx">Only what is there, magnified; null: the whole frame.</param>
        public static Canvas Draw(ExplainedFrame frame, Vector2D? atPx) => atPx is { } at ? SpotPicture.Draw(frame, at) : DrawWhole(frame);

        /// <summary>The size at which a frame is looked at with ease: whole multiples or whole parts.</summary>
        public static (int Magnification, int Reduction) Scale(int width, int wished) =>
            width <= wished ? (Math.Max(1, wished / width), 1) : (1, (width + wished - 1) / wished);

        /// <summary>Two lines; returns where the next thing goes.</summary>
        public static int DrawTitle(Canvas canvas, ExplainedFrame frame)
        {
            string title = ExplanationText.Title(frame).Replace(frame.InputName, Path.GetFileName(frame.InputName.TrimEnd('/', '\\')), StringComparison.Ordinal);
            canvas.Text(Margin, Margin, title, Palette.Text);
            int y = CandidateCard.Lines(canvas, Margin, Margin + CandidateCard.LineHeight, ExplanationText.Summary(frame), Palette.Quiet, 200);
            foreach (string note in frame.Notes.Take(MaxNotes))
                y = CandidateCard.Lines(canvas, Margin, y, note, Palette.Waiting, (canvas.Width - 2 * Margin) / Letter);
            return y + 8;
        }

        /// <summary>The frame with a box and a number for each candidate.</summary>
        public static void DrawFrame(Canvas canvas, ExplainedFrame frame, int x, int y, int magnification, int reduction, IEnumerable<ExplainedCandidate> labelled)
        {
            canvas.Draw(frame.Picture, x, y, magnification, reduction);
            double scale = magnification / (double)reduction;
            var named = new HashSet<ExplainedCandidate>(labelled);
            foreach (ExplainedCandidate candidate in frame.Candidates.OrderBy(c => named.Contains(c)).ThenBy(c => c.State))
            {
                uint color = Palette.Of(candidate.State);
                int left = x + (int)((candidate.TopLeftPx.X + 0.5) * scale - scale / 2) - 4, top = y + (int)((candidate.TopLeftPx.Y + 0.5) * scale - scale / 2) - 4;
                int width = (int)((candidate.BottomRightPx.X - candidate.TopLeftPx.X + 1) * scale) + 8, height = (int)((candidate.BottomRightPx.Y - candidate.TopLeftPx.Y + 1) * scale) + 8;
                bool isNamed = named.Contains(candidate);
                canvas.Outline(left - 1, top - 1, width + 2, height + 2, 0x000000);
                canvas.Outline(left, top, width, height, color, candidate.State != CandidateState.Rejected || isNamed ? 2 : 1);
                if (isNamed)
                    Label(canvas, left + width + 3, top - 6, candidate.Number.ToString(System.Globalization.CultureInfo.InvariantCulture), color, candidate.State != CandidateState.Rejected);
            }
        }

        private static void Label(Canvas canvas, int x, int y, string text, uint color, bool isLarge)
        {
            int scale = isLarge ? 2 : 1;
            canvas.Fill(x - 2, y - 1, text.Length * BitmapFont.Advance * scale + 3, BitmapFont.Rows * scale, 0x000000);
            canvas.Text(x, y, text, color, isLarge);
        }

        private static Canvas DrawWhole(ExplainedFrame frame)
        {
            (int magnification, int reduction) = Scale(frame.Picture.Width, 1280);
            int width = frame.Picture.Width / reduction * magnification, height = frame.Picture.Height / reduction * magnification;
            int top = Margin + (2 + Math.Min(MaxNotes, frame.Notes.Count)) * CandidateCard.LineHeight + 8;
            ExplainedCandidate[] ordered = frame.ByInterest().ToArray();
            int room = Math.Max(MinHeight, height);
            List<(ExplainedCandidate Candidate, int Column, int Y)> cards = Arrange(ordered, room, out int columns, out int tallest);
            ExplainedCandidate[] rest = ordered.Skip(cards.Count).ToArray();
            int totalWidth = Math.Max(900, Margin + width + columns * (CandidateCard.Width + Margin) + Margin);
            int restColumns = Math.Max(1, (totalWidth - Margin) / (RestLetters * Letter)), restRows = Math.Min(MaxRestLines, (rest.Length + restColumns - 1) / restColumns);
            int below = top + Math.Max(height, tallest) + CardGap;
            int totalHeight = below + (rest.Length == 0 ? 0 : restRows + 2) * CandidateCard.LineHeight + Margin;
            var canvas = new Canvas(totalWidth, totalHeight, Palette.Background);
            DrawTitle(canvas, frame);
            DrawFrame(canvas, frame, Margin, top, magnification, reduction, cards.Select(c => c.Candidate).Take(MaxLabels));
            foreach ((ExplainedCandidate candidate, int column, int y) in cards)
                CandidateCard.Draw(canvas, 2 * Margin + width + column * (CandidateCard.Width + Margin), top + y, candidate);
            DrawRest(canvas, Margin, below, rest, restColumns, restRows);
            return canvas;
        }

        private static List<(ExplainedCandidate Candidate, int Column, int Y)> Arrange(ExplainedCandidate[] ordered, int room, out int columns, out int tallest)
        {
            var cards = new List<(ExplainedCandidate, int, int)>();
            int column = 0, y = 0;
            tallest = 0;
            foreach (ExplainedCandidate candidate in ordered)
            {
                int height = CandidateCard.Height(candidate);
                if (y > 0 && y + height > room)
                {
                    if (++column == MaxColumns)
                        break;
                    y = 0;
                }

                cards.Add((candidate, column, y));
                tallest = Math.Max(tallest, y + height);
                y += height + CardGap;
            }

            columns = cards.Count == 0 ? 0 : Math.Min(MaxColumns, column + 1);
            return cards;
        }

        /// <summary>One line each for those that have no table, column by column.</summary>
        private static void DrawRest(Canvas canvas, int x0, int y0, ExplainedCandidate[] rest, int columns, int rows)
        {
            for (int i = 0; i < Math.Min(rest.Length, columns * rows); i++)
            {
                int x = x0 + i / rows * RestLetters * Letter, y = y0 + i % rows * CandidateCard.LineHeight;
                string place = FormattableString.Invariant($"#{rest[i].Number} at {rest[i].PositionPx.X:F1}, {rest[i].PositionPx.Y:F1}");
                canvas.Text(canvas.Text(x, y, place.PadRight(22), Palette.Text), y, rest[i].Verdict, Palette.Of(rest[i].State));
            }

            if (rest.Length > columns * rows)
                canvas.Text(x0, y0 + rows * CandidateCard.LineHeight, FormattableString.Invariant($"… and {rest.Length - columns * rows} more: the text on standard output lists them all"), Palette.Quiet);
        }
    }
}
