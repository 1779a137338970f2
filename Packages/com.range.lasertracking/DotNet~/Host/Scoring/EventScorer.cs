using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using LaserTracking.Geometry;
using LaserTracking.Host.Events;

namespace LaserTracking.Host.Scoring
{
    /// <summary>
    /// Compares the shots of events.jsonl with the truth by <see cref="ShotMatcher"/>. Every event that no true shot takes is a false shot.
    /// </summary>
    internal sealed class EventScorer
    {
        private const int MostFalseListed = 20;
        private readonly TruthClip _clip;
        private readonly IReadOnlyList<ReportedShot> _events;
        private readonly int[] _takenBy;

        private EventScorer(TruthClip clip, IReadOnlyList<ReportedShot> events)
        {
            _clip = clip;
            _events = events;
            _takenBy = ShotMatcher.Match(clip, events);
        }

        /// <summary>Scores a file of events and gives the result as JSON text, ended by a line feed.</summary>
        /// <param name="eventsPath">events.jsonl; only lines of type "shot" count.</param>
        /// <param name="truthPath">A truth file, see <see cref="TruthFile"/>.</param>
        /// <param name="clipName">Which of the truth's clips; null: the only one, or the one that the events' header names as input.</param>
        /// <exception cref="InputException">A file cannot be used, or the clip is not told.</exception>
        public static string Score(string eventsPath, string truthPath, string? clipName)
        {
            IReadOnlyList<TruthClip> clips = TruthFile.Read(truthPath);
            List<ReportedShot> events = ReadShots(eventsPath, out List<string> inputs);
            TruthClip clip = Choose(clips, truthPath, clipName, inputs);
            if (new FileInfo(eventsPath).Length == 0)
                throw new InputException(eventsPath, "is empty (0 bytes)", "write it anew with ./range replay --events");
            return new EventScorer(clip, events).ToJson();
        }

        private static List<ReportedShot> ReadShots(string path, out List<string> inputs)
        {
            var shots = new List<ReportedShot>();
            inputs = new List<string>();
            foreach (EventLine line in EventLines.Read(path))
            {
                if (line.OptionalText("type") == "shot")
                {
                    double x = line.Double("x_px"), y = line.Double("y_px");
                    if (double.IsNaN(x + y))
                        throw line.Wrong("x_px", "or \"y_px\" is no number");
                    shots.Add(new ReportedShot(line.Integer("frame"), new Vector2D(x, y), line.OptionalText("color")));
                }
                else if (line.OptionalText("type") == "header" && line.Root.TryGetProperty("inputs", out JsonElement list) && list.ValueKind == JsonValueKind.Array)
                {
                    inputs.AddRange(list.EnumerateArray().Where(input => input.ValueKind == JsonValueKind.Object)
                        .Select(input => line.OptionalText(input, "path")).OfType<string>());
                }
            }

            return shots;
        }

        private static TruthClip Choose(IReadOnlyList<TruthClip> clips, string path, string? name, List<string> inputs)
        {
            if (name != null)
                return clips.FirstOrDefault(clip => clip.File == name) ?? throw new InputException(path, "has no clip \"" + name + "\"", "name one of its " + clips.Count + " clips with --clip");
            if (clips.Count == 1)
                return clips[0];
            return clips.FirstOrDefault(clip => inputs.Any(input => input.Replace('\\', '/').Split('/')[^1] == clip.File))
                ?? throw new InputException(path, "has " + clips.Count + " clips, and none is named as the events' input", "name one with --clip");
        }

        private string ToJson()
        {
            int[] found = Enumerable.Range(0, _events.Count).Where(j => _takenBy[j] >= 0).ToArray();
            int colorOk = found.Count(j => _events[j].Color == _clip.Shots[_takenBy[j]].Color);
            double[] errors = found.Select(j => ShotMatcher.DistancePx(_clip.Shots[_takenBy[j]], _events[j])).OrderBy(e => e).ToArray();
            using var stream = new MemoryStream();
            using (var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true, NewLine = "\n", Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping }))
            {
                json.WriteStartObject();
                json.WriteStartArray("clips");
                json.WriteStartObject();
                json.WriteString("clip", _clip.File);
                Counts(json, found.Length, colorOk);
                Error(json, "error_px_median", errors, errors.Length / 2, 6);
                json.WriteStartArray("missed");
                foreach (int i in Enumerable.Range(0, _clip.Shots.Count).Where(i => !_takenBy.Contains(i)))
                    json.WriteStringValue(_clip.Shots[i].Id);
                json.WriteEndArray();
                json.WriteStartArray("false_at");
                foreach (int j in Enumerable.Range(0, _events.Count).Where(j => _takenBy[j] < 0).Take(MostFalseListed))
                {
                    json.WriteStartArray();
                    json.WriteNumberValue(_events[j].Frame);
                    json.WriteNumberValue(Round(_events[j].PositionPx.X, 1));
                    json.WriteNumberValue(Round(_events[j].PositionPx.Y, 1));
                    json.WriteEndArray();
                }

                json.WriteEndArray();
                json.WriteEndObject();
                json.WriteEndArray();
                json.WriteStartObject("total");
                Counts(json, found.Length, colorOk);
                Error(json, "error_px_median", errors, errors.Length / 2, 3);
                Error(json, "error_px_p95", errors, (int)(0.95 * (errors.Length - 1)), 3);
                json.WriteEndObject();
                json.WriteEndObject();
            }

            return Encoding.UTF8.GetString(stream.ToArray()) + "\n";
        }

        private void Counts(Utf8JsonWriter json, int found, int colorOk)
        {
            json.WriteNumber("shots", _clip.Shots.Count);
            json.WriteNumber("found", found);
            json.WriteNumber("false", _events.Count - found);
            json.WriteNumber("color_ok", colorOk);
        }

        private static void Error(Utf8JsonWriter json, string name, double[] errors, int index, int decimals)
        {
            if (errors.Length == 0)
                json.WriteNull(name);
            else
                json.WriteNumber(name, Round(errors[index], decimals));
        }

        /// <summary>
        /// Rounds the number's exact binary value as the reference tool does, ties to even. Math.Round multiplies first and so takes
        /// 6.35 (which lies below the tie) up.
        /// </summary>
        private static double Round(double value, int decimals)
        {
            bool mayBeTie = value * 1024 == Math.Floor(value * 1024);
            return mayBeTie ? Math.Round(value, decimals)
                : double.Parse(value.ToString("F" + decimals, CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
        }
    }
}
