using System;
using System.Collections.Generic;
using LaserTracking.Host.Pictures;

namespace LaserTracking.Host.Explanations
{
    /// <summary>A candidate's table: tests in order, value against limit, the final word.</summary>
    internal static class CandidateCard
    {
        public const int Width = Letters * Letter + 2 * Padding;

        public const int LineHeight = 21;

        private const int Letters = 44;
        private const int Letter = 2 * BitmapFont.Advance;
        private const int Padding = 10;
        private const int ValueColumn = 24;
        private const int LimitColumn = 34;

        public static int Height(ExplainedCandidate candidate) =>
            LineHeight * (1 + Wrap(candidate.FoundIn, Letters).Count + candidate.Tests.Count + Headings(candidate) + Wrap(candidate.Verdict, Letters).Count) + 2 * Padding;

        /// <summary>Returns the height drawn.</summary>
        public static int Draw(Canvas canvas, int x, int y, ExplainedCandidate candidate)
        {
            int height = Height(candidate);
            uint color = Palette.Of(candidate.State);
            canvas.Fill(x, y, Width, height, Palette.Panel);
            canvas.Fill(x, y, 4, height, color);
            x += Padding;
            y += Padding;
            canvas.Text(x, y, FormattableString.Invariant($"#{candidate.Number} at {candidate.PositionPx.X:F1}, {candidate.PositionPx.Y:F1}"), Palette.Text);
            y = Lines(canvas, x, y + LineHeight, candidate.FoundIn, Palette.Quiet);
            var section = TestSection.Tests;
            foreach (TestRow row in TestRow.Of(candidate.Tests))
            {
                if (row.Section != section && TestRow.Heading(row.Section) is { } heading)
                {
                    canvas.Text(x, y, heading, Palette.Quiet);
                    y += LineHeight;
                }

                section = row.Section;
                DrawRow(canvas, x, y, row);
                y += LineHeight;
            }

            Lines(canvas, x, y, candidate.Verdict, color);
            return height;
        }

        /// <summary>Draws a text in as many lines as it needs; returns where the next one goes.</summary>
        public static int Lines(Canvas canvas, int x, int y, string text, uint color, int letters = Letters)
        {
            foreach (string line in Wrap(text, letters))
            {
                canvas.Text(x, y, line, color);
                y += LineHeight;
            }

            return y;
        }

        private static void DrawRow(Canvas canvas, int x, int y, TestRow row)
        {
            if (row.Section == TestSection.Evidence)
            {
                DrawEvidence(canvas, x, y, row);
                return;
            }

            uint color = row.IsPassed ? Palette.Text : Palette.Failed;
            canvas.Fill(x, y + 2, 10, 10, row.IsPassed ? Palette.Passed : Palette.Failed);
            if (!row.IsPassed)
                canvas.Fill(x + 3, y + 5, 4, 4, Palette.Panel);
            canvas.Text(x + 18, y, row.What, color);
            canvas.Text(x + (ValueColumn + 7 - row.Value.Length) * Letter, y, row.Value, color);
            canvas.Text(x + (LimitColumn - 2) * Letter, y, row.Sign + " " + row.Limit, Palette.Quiet);
        }

        private static void DrawEvidence(Canvas canvas, int x, int y, TestRow row)
        {
            uint color = row.IsPassed ? row.Mark[0] == '-' ? Palette.Quiet : Palette.Text : Palette.Failed;
            canvas.Text(x + (6 - row.Mark.Length) * Letter, y, row.Mark, color);
            canvas.Text(x + 7 * Letter, y, row.What, color);
            string right = (row.Value + " " + row.Sign + " " + row.Limit).Trim();
            canvas.Text(x + (Letters - right.Length) * Letter, y, right, Palette.Quiet);
        }

        private static int Headings(ExplainedCandidate candidate)
        {
            int count = 0;
            var section = TestSection.Tests;
            foreach (TestRow row in TestRow.Of(candidate.Tests))
            {
                count += row.Section != section && TestRow.Heading(row.Section) != null ? 1 : 0;
                section = row.Section;
            }

            return count;
        }

        /// <summary>Breaks at spaces; longer words are cut.</summary>
        private static List<string> Wrap(string text, int letters)
        {
            var lines = new List<string>();
            while (text.Length > letters)
            {
                int cut = text.LastIndexOf(' ', letters);
                if (cut <= 0)
                    cut = letters;
                lines.Add(text[..cut]);
                text = "  " + text[cut..].TrimStart();
            }

            if (text.Trim().Length > 0)
                lines.Add(text);
            return lines;
        }
    }
}
