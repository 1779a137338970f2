using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Host.Sessions;
using LaserTracking.Host.Studies;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Calibration
{
    /// <summary>A folder of calibrations, one file a session: the files are the record, there is no list beside them.</summary>
    internal sealed class CalibrationHistory
    {
        private readonly List<CalibrationRecord> _records = new();

        private CalibrationHistory()
        {
        }

        /// <summary>Files that are no calibrations, with the reason.</summary>
        public List<string> Problems { get; } = new();

        /// <exception cref="InputException">The folder is not there or holds no calibration.</exception>
        public static CalibrationHistory Open(string folder)
        {
            if (!Directory.Exists(folder))
                throw new InputException(folder, File.Exists(folder) ? "is a file, not a folder" : "no such folder", "name the folder given to --history");
            var history = new CalibrationHistory();
            foreach (string path in Directory.GetFiles(folder, "*.json").Order(StringComparer.Ordinal))
            {
                try
                {
                    history._records.Add(CalibrationRecord.Read(path));
                }
                catch (InputException problem)
                {
                    history.Problems.Add(problem.Message);
                }
            }

            if (history._records.Count == 0)
                throw new InputException(folder, "holds no calibration" + (history.Problems.Count == 0 ? string.Empty : FormattableString.Invariant($" that can be read, of {history.Problems.Count} files; {history.Problems[0]}")), "'./range calibrate board --history DIR --date YYYY-MM-DD' puts one there");
            return history;
        }

        /// <summary>Puts a calibration into the folder under a name of its own: date, kind, and a number when there are several.</summary>
        public static void Keep(string folder, JObject calibration, byte[] content)
        {
            string stem = $"{(string?)calibration["date"]}-{(string?)calibration["kind"]}";
            string path = Path.Combine(folder, stem + ".json");
            for (int i = 2; File.Exists(path); i++)
                path = Path.Combine(folder, FormattableString.Invariant($"{stem}-{i}.json"));
            using var file = new ResultFile(path);
            file.Stream.Write(content);
            file.Commit();
        }

        /// <summary>Why a calibration that is there must not give way to a new one; null when it may, or when there is none.</summary>
        public static string? WhyKept(string path, JObject calibration)
        {
            if (path == "-" || !File.Exists(path))
                return null;
            CalibrationRecord old, fresh = CalibrationRecord.Of(calibration, path);
            try
            {
                old = CalibrationRecord.Read(path);
            }
            catch (InputException problem)
            {
                return "what is there is no calibration that this can judge (" + problem.Message + ")";
            }

            if (old.Kind != fresh.Kind || old.ImageSize != fresh.ImageSize)
                return $"what is there is of another camera ({old.Kind} {old.ImageSize}, the new one {fresh.Kind} {fresh.ImageSize})";
            if (!fresh.IsWorseThan(old))
                return null;
            if (old.Kind == "screen")
                return FormattableString.Invariant($"what is there is better ({old.HeldOut:F3} mm on held-out points, the new one {(fresh.HeldOut is double mm ? FormattableString.Invariant($"{mm:F3} mm") : "unproven")})");
            bool byHeldOut = old.HeldOut != null && fresh.HeldOut != null;
            return $"what is there is better ({old.Error(byHeldOut)}, the new one {fresh.Error(byHeldOut)})";
        }

        /// <summary>A table for each kind, in order of date, with the best and the trend below.</summary>
        public IEnumerable<StudyTable> Tables()
        {
            foreach (IGrouping<string, CalibrationRecord> kind in _records.GroupBy(record => record.Kind).OrderBy(kind => kind.Key, StringComparer.Ordinal))
            {
                CalibrationRecord[] records = kind.OrderBy(record => record.Date, StringComparer.Ordinal).ThenBy(record => record.File, StringComparer.Ordinal).ToArray();
                CalibrationRecord best = Best(records);
                string unit = best.HeldOutUnit;
                var table = new StudyTable(kind.Key, "date", "file", "rms_px", "held_out_" + unit, "views", "best");
                foreach (CalibrationRecord record in records)
                    table.Add(record.Date, record.File, Cell(record.RmsPx), Cell(record.HeldOut), record.Views?.ToString() ?? "-", record == best ? "*" : string.Empty);
                bool byHeldOut = records.All(record => record.HeldOut != null);
                table.Notes.Add($"best: {best.File}, {best.Error(byHeldOut)}; " + Trend(records, byHeldOut, byHeldOut ? unit : "px"));
                yield return table;
            }
        }

        /// <summary>The smallest error; the first of equals.</summary>
        private static CalibrationRecord Best(CalibrationRecord[] records)
        {
            CalibrationRecord best = records[0];
            foreach (CalibrationRecord record in records)
                best = best.IsWorseThan(record) || (best.RmsPx == null && record.RmsPx != null && !record.IsWorseThan(best)) ? record : best;
            return best;
        }

        /// <summary>The middle of all slopes between two sessions (Theil 1950): one bad session does not make a trend.</summary>
        private static string Trend(CalibrationRecord[] records, bool byHeldOut, string unit)
        {
            double[] errors = records.Select(record => byHeldOut ? record.HeldOut : record.RmsPx).OfType<double>().ToArray();
            if (errors.Length < 3)
                return "too few sessions for a trend";
            double[] slopes = Enumerable.Range(0, errors.Length).SelectMany(i => Enumerable.Range(i + 1, errors.Length - i - 1).Select(j => (errors[j] - errors[i]) / (j - i))).Order().ToArray();
            double slope = (slopes[(slopes.Length - 1) / 2] + slopes[slopes.Length / 2]) / 2;
            string word = Math.Abs(slope) < 0.02 * errors.Average() ? "steady" : slope > 0 ? "getting worse" : "getting better";
            return FormattableString.Invariant($"trend: {word} ({slope:+0.0000;-0.0000;0.0000} {unit} a session)");
        }

        private static object Cell(double? value) => value is double number ? number : "-";
    }
}
