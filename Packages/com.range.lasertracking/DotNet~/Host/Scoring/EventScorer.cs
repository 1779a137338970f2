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
    /// Compares the shots of events.jsonl with the truth. A true shot is found when one shot event lies within 3 px (scaled by
    /// width/640) of a place of its dot and was reported in one of its frames or up to two after. Every event that no true shot takes
    /// is a false shot. The matching finds the most shots; among equals it prefers near pairs.
    /// </summary>
    internal sealed class EventScorer
    {
        private const double TolerancePx = 3;
        private const double ToleranceWidth = 640;
        private const int LateFrames = 2;
        private const int MostFalseListed = 20;
        private readonly TruthClip _clip;
        private readonly IReadOnlyList<Reported> _events;
        private readonly int[] _takenBy;

        private EventScorer(TruthClip clip, IReadOnlyList<Reported> events)
        {
            _clip = clip;
            _events = events;
            _takenBy = Match(clip, events);
        }

        /// <summary>Scores a file of events and gives the result as JSON text, ended by a line feed.</summary>
        /// <param name="eventsPath">events.jsonl; only lines of type "shot" count.</param>
        /// <param name="truthPath">A truth file, see <see cref="TruthFile"/>.</param>
        /// <param name="clipName">Which of the truth's clips; null: the only one, or the one that the events' header names as input.</param>
        /// <exception cref="InputException">A file cannot be used, or the clip is not told.</exception>
        public static string Score(string eventsPath, string truthPath, string? clipName)
        {
            IReadOnlyList<TruthClip> clips = TruthFile.Read(truthPath);
            List<Reported> events = ReadShots(eventsPath, out List<string> inputs);
            TruthClip clip = Choose(clips, truthPath, clipName, inputs);
            if (new FileInfo(eventsPath).Length == 0)
                throw new InputException(eventsPath, "is empty (0 bytes)", "write it anew with ./range replay --events");
            return new EventScorer(clip, events).ToJson();
        }

        private static List<Reported> ReadShots(string path, out List<string> inputs)
        {
            var shots = new List<Reported>();
            inputs = new List<string>();
            foreach (EventLine line in EventLines.Read(path))
            {
                if (line.OptionalText("type") == "shot")
                {
                    double x = line.Double("x_px"), y = line.Double("y_px");
                    if (double.IsNaN(x + y))
                        throw line.Wrong("x_px", "or \"y_px\" is no number");
                    shots.Add(new Reported(line.Integer("frame"), new Vector2D(x, y), line.OptionalText("color")));
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

        private static double Distance(TruthShot shot, Reported reported) => shot.PlacesPx.Min(place => (place - reported.PositionPx).Length);

        /// <summary>Kuhn's augmenting paths over the possible pairs, nearest first. Gives each event's true shot, or -1.</summary>
        private static int[] Match(TruthClip clip, IReadOnlyList<Reported> events)
        {
            double tolerance = TolerancePx * clip.Width / ToleranceWidth;
            var pairs = new List<(double Distance, int Event)>[clip.Shots.Count];
            for (int i = 0; i < pairs.Length; i++)
            {
                TruthShot shot = clip.Shots[i];
                pairs[i] = Enumerable.Range(0, events.Count)
                    .Where(j => shot.FirstVisibleFrame <= events[j].Frame && events[j].Frame <= shot.LastVisibleFrame + LateFrames)
                    .Select(j => (Distance(shot, events[j]), j)).Where(pair => pair.Item1 <= tolerance).OrderBy(pair => pair).ToList();
            }

            int[] takenBy = Enumerable.Repeat(-1, events.Count).ToArray();
            foreach (int shot in Enumerable.Range(0, pairs.Length).OrderBy(i => pairs[i].Count > 0 ? pairs[i][0].Distance : 1e9))
                Augment(shot, pairs, takenBy, new bool[events.Count]);
            return takenBy;
        }

        private static bool Augment(int shot, List<(double Distance, int Event)>[] pairs, int[] takenBy, bool[] seen)
        {
            foreach ((double _, int candidate) in pairs[shot])
            {
                if (seen[candidate])
                    continue;
                seen[candidate] = true;
                if (takenBy[candidate] >= 0 && !Augment(takenBy[candidate], pairs, takenBy, seen))
                    continue;
                takenBy[candidate] = shot;
                return true;
            }

            return false;
        }

        private string ToJson()
        {
            int[] found = Enumerable.Range(0, _events.Count).Where(j => _takenBy[j] >= 0).ToArray();
            int colorOk = found.Count(j => _events[j].Color == _clip.Shots[_takenBy[j]].Color);
            double[] errors = found.Select(j => Distance(_clip.Shots[_takenBy[j]], _events[j])).OrderBy(e => e).ToArray();
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

        /// <summary>What of a reported shot counts here.</summary>
        private sealed record Reported(int Frame, Vector2D PositionPx, string? Color);
    }
}
