using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Tracks
{
    /// <summary>
    /// Reads MOT15 text strictly: "frame,id,x,y,w,h[,score[,…]]", every field a finite number, frame and id whole, boxes with area.
    /// Lines may come in any order of frames; empty lines are allowed at the end only. Writes the same, 6 decimals.
    /// </summary>
    internal static class MotFile
    {
        /// <summary>Highest frame number: five days at 30 frames a second.</summary>
        public const int MaximumFrame = 12_960_000;

        private const int LeastFields = 6;
        private const int MostFields = 10;
        private const string Remedy = "give lines \"frame,id,x,y,w,h,score\"";
        private static readonly string[] Names = { "frame", "id", "x", "y", "w", "h", "score", "7 after frame", "8 after frame", "9 after frame" };

        /// <summary>All lines by frame; lines of one frame in the file's order.</summary>
        /// <exception cref="InputException">The file cannot be read, or a line breaks the rules; the message names line and field.</exception>
        public static List<MotRow> Read(string path)
        {
            var rows = new List<MotRow>();
            var fields = new double[MostFields];
            int number = 0, blank = 0;
            foreach (string line in Lines(path))
            {
                number++;
                if (string.IsNullOrWhiteSpace(line))
                {
                    blank = blank == 0 ? number : blank;
                    continue;
                }

                if (blank > 0)
                    throw new InputException(path, FormattableString.Invariant($"line {blank} is empty"), "take it out");
                rows.Add(Parse(path, number, line, fields));
            }

            return rows.OrderBy(row => row.Frame).ToList();
        }

        /// <exception cref="InputException">As <see cref="Read"/>, or there is no line at all, or an id stands twice in a frame.</exception>
        public static List<MotRow> ReadTracks(string path, bool mayBeEmpty)
        {
            List<MotRow> rows = Read(path);
            if (rows.Count == 0 && !mayBeEmpty)
                throw Empty(path);
            var seen = new HashSet<(int, int)>();
            foreach (MotRow row in rows)
            {
                if (!seen.Add((row.Frame, row.Id)))
                    throw new InputException(path, FormattableString.Invariant($"frame {row.Frame} holds id {row.Id} twice"), "give every object one id, and every id once a frame");
            }

            return rows;
        }

        public static InputException Empty(string path) => new(path, "is empty (no line)", Remedy);

        /// <summary>"frame,id,x,y,w,h" and a line feed.</summary>
        public static void Write(TextWriter to, in MotRow row) =>
            to.Write(string.Create(CultureInfo.InvariantCulture, $"{row.Frame},{row.Id},{row.Box.X:F6},{row.Box.Y:F6},{row.Box.Width:F6},{row.Box.Height:F6}\n"));

        private static MotRow Parse(string path, int number, string line, double[] fields)
        {
            int count = 0;
            foreach (Range part in line.AsSpan().Split(','))
            {
                ReadOnlySpan<char> text = line.AsSpan(part).Trim();
                if (count == MostFields)
                    throw Wrong(path, number, FormattableString.Invariant($"has more than {MostFields} fields"));
                if (!double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out fields[count]) || !double.IsFinite(fields[count]))
                    throw Wrong(path, number, "field " + Names[count] + ": \"" + Shown(text) + "\" is no finite number");
                count++;
            }

            if (count < LeastFields)
                throw Wrong(path, number, FormattableString.Invariant($"has {count} of at least {LeastFields} fields"));
            if (!IsWhole(fields[0], 1, MaximumFrame))
                throw Wrong(path, number, FormattableString.Invariant($"field frame: {fields[0]} is no whole number in 1…{MaximumFrame}"));
            if (!IsWhole(fields[1], int.MinValue, int.MaxValue))
                throw Wrong(path, number, FormattableString.Invariant($"field id: {fields[1]} is no whole number"));
            if (!(fields[4] > 0))
                throw Wrong(path, number, FormattableString.Invariant($"field w: {fields[4]} is not above 0"));
            if (!(fields[5] > 0))
                throw Wrong(path, number, FormattableString.Invariant($"field h: {fields[5]} is not above 0"));
            var box = new BoundingBox(fields[2], fields[3], fields[4], fields[5]);
            if (!box.IsUsable)
                throw Wrong(path, number, "the box lies beyond any picture");
            return new MotRow((int)fields[0], (int)fields[1], box, count > LeastFields ? fields[LeastFields] : 1);
        }

        private static bool IsWhole(double value, double least, double most) => value == Math.Floor(value) && value >= least && value <= most;

        private static InputException Wrong(string path, int line, string what) => new(path, FormattableString.Invariant($"line {line} ") + what, Remedy);

        /// <summary>Also of binary files: a short piece without control characters.</summary>
        private static string Shown(ReadOnlySpan<char> text)
        {
            var shown = new StringBuilder();
            foreach (char c in text.Length > 20 ? text[..20] : text)
                shown.Append(char.IsControl(c) || char.IsSurrogate(c) || c is '\u2028' or '\u2029' ? '?' : c);
            return shown + (text.Length > 20 ? "…" : string.Empty);
        }

        private static IEnumerable<string> Lines(string path)
        {
            if (Directory.Exists(path))
                throw new InputException(path, "is a folder", "name a text file");
            try
            {
                return File.ReadAllLines(path);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
            {
                throw new InputException(path, File.Exists(path) ? "cannot be read" : "is not there", "check its name and rights");
            }
        }
    }
}
