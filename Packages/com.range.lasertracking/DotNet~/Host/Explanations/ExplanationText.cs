using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Explanations
{
    /// <summary>An explanation as text.</summary>
    internal static class ExplanationText
    {
        public static string Title(ExplainedFrame frame) =>
            FormattableString.Invariant($"frame {frame.Index} of {frame.InputName}, {frame.TimeUs * 1e-6:F3} s, {frame.Picture.Width}×{frame.Picture.Height}, detector {frame.Detector}");

        public static string Summary(ExplainedFrame frame)
        {
            string Count(CandidateState state, string word) => frame.Candidates.Count(c => c.State == state) is var count and > 0
                ? FormattableString.Invariant($", {count} {word}")
                : string.Empty;
            return FormattableString.Invariant($"{frame.Candidates.Count} candidate{(frame.Candidates.Count == 1 ? string.Empty : "s")}") + Count(CandidateState.Shot, "shot") + Count(CandidateState.Dot, "of a shot before")
                + Count(CandidateState.Waiting, "given up after waiting") + Count(CandidateState.Rejected, "rejected");
        }

        /// <summary>"#3 at 301.4, 288.1: smallest channel".</summary>
        public static string Head(ExplainedCandidate c) =>
            FormattableString.Invariant($"#{c.Number} at {c.PositionPx.X:F1}, {c.PositionPx.Y:F1}") + (c.FoundIn.Length > 0 ? ": " + c.FoundIn : string.Empty);

        /// <param name="frame">What is explained.</param>
        /// <param name="atPx">Only what is there; null: everything.</param>
        /// <param name="to">Where to write.</param>
        public static void Write(ExplainedFrame frame, Vector2D? atPx, TextWriter to)
        {
            to.WriteLine(Title(frame));
            to.WriteLine(Summary(frame));
            foreach (string note in frame.Notes)
                to.WriteLine(note);
            IEnumerable<ExplainedCandidate> shown = frame.ByInterest();
            if (atPx is { } at)
            {
                ExplainedCandidate? there = frame.At(at);
                shown = there == null ? [] : [there];
                if (there == null)
                {
                    to.WriteLine(FormattableString.Invariant($"no candidate at {at.X:0.##}, {at.Y:0.##}"));
                    foreach (string line in SpotReason.Lines(frame, at))
                        to.WriteLine("  " + line);
                }
            }

            foreach (ExplainedCandidate candidate in shown)
                Write(candidate, to);
        }

        private static void Write(ExplainedCandidate candidate, TextWriter to)
        {
            to.WriteLine();
            to.WriteLine(Head(candidate));
            var section = TestSection.Tests;
            foreach (TestRow row in TestRow.Of(candidate.Tests))
            {
                if (row.Section != section && TestRow.Heading(row.Section) is { } heading)
                    to.WriteLine("  " + heading);
                section = row.Section;
                to.WriteLine((section == TestSection.Evidence
                    ? $"  {row.Mark,6}  {row.What,-31} {row.Value,8} {row.Sign,1} {row.Limit}"
                    : $"  {row.Mark,-4} {row.What,-22} {row.Value,8} {row.Sign,1} {row.Limit}").TrimEnd());
            }

            to.WriteLine("  " + candidate.Verdict);
        }
    }
}
