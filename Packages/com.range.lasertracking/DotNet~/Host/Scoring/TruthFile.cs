using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Scoring
{
    /// <summary>
    /// Reads truth files of two layouts: a list of clips with shots ("clips": file, width, shots with first_visible_frame,
    /// last_visible_frame, path or x_px, y_px), and one recording with dots frame by frame ("file", "shots" with first_frame and
    /// frames, "frames" with "dots").
    /// </summary>
    internal static class TruthFile
    {
        private const string Remedy = "give a truth file as Documentation~/events.md describes";

        /// <exception cref="InputException">The file cannot be used.</exception>
        public static IReadOnlyList<TruthClip> Read(string path)
        {
            using JsonDocument document = Open(path);
            JsonElement root = document.RootElement;
            if (root.ValueKind != JsonValueKind.Object)
                throw new InputException(path, "is no JSON object", Remedy);
            if (!root.TryGetProperty("clips", out JsonElement clips))
                return new[] { Recording(path, root) };
            var list = new List<TruthClip>();
            foreach (JsonElement clip in Items(path, clips, "clips"))
            {
                string file = Text(path, clip, "clips[" + list.Count + "].file", "file");
                var shots = new List<TruthShot>();
                foreach (JsonElement shot in Items(path, Member(path, clip, file + ".shots", "shots"), file + ".shots"))
                    shots.Add(Shot(path, shot, file + ".shots[" + shots.Count + "]", shots.Count));
                list.Add(new TruthClip(file, Integer(path, clip, file + ".width", "width"), shots));
            }

            return list;
        }

        private static JsonDocument Open(string path)
        {
            if (Directory.Exists(path))
                throw new InputException(path, "is a folder", "name a truth file");
            try
            {
                return JsonDocument.Parse(File.ReadAllBytes(path));
            }
            catch (JsonException e)
            {
                throw new InputException(path, "is no JSON, at line " + ((e.LineNumber ?? 0) + 1) + ", character " + ((e.BytePositionInLine ?? 0) + 1), Remedy);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
            {
                throw new InputException(path, File.Exists(path) ? "cannot be opened" : "is not there", "check its name and rights");
            }
        }

        private static TruthShot Shot(string path, JsonElement shot, string where, int index)
        {
            var places = new List<Vector2D>();
            if (Object(path, shot, where).TryGetProperty("path", out JsonElement way) && way.ValueKind == JsonValueKind.Array)
            {
                foreach (JsonElement point in way.EnumerateArray())
                {
                    if (point.ValueKind != JsonValueKind.Array || point.GetArrayLength() != 3 || point.EnumerateArray().Any(n => n.ValueKind != JsonValueKind.Number))
                        throw new InputException(path, where + ".path holds something that is not [frame, x, y]", Remedy);
                    places.Add(new Vector2D(point[1].GetDouble(), point[2].GetDouble()));
                }
            }

            places.Add(new Vector2D(Number(path, shot, where + ".x_px", "x_px"), Number(path, shot, where + ".y_px", "y_px")));
            return new TruthShot(Id(shot, index), shot.TryGetProperty("color", out JsonElement color) && color.ValueKind == JsonValueKind.String ? color.GetString() : null,
                Integer(path, shot, where + ".first_visible_frame", "first_visible_frame"),
                Integer(path, shot, where + ".last_visible_frame", "last_visible_frame"), places);
        }

        private static TruthClip Recording(string path, JsonElement root)
        {
            if (!root.TryGetProperty("shots", out JsonElement list) || !root.TryGetProperty("frames", out JsonElement frames))
                throw new InputException(path, "has neither \"clips\" nor \"shots\" with \"frames\"", Remedy);
            var places = new Dictionary<string, List<Vector2D>>();
            foreach (JsonElement frame in Items(path, frames, "frames"))
            {
                if (!Object(path, frame, "frames").TryGetProperty("dots", out JsonElement dots))
                    continue;
                foreach (JsonElement dot in Items(path, dots, "dots"))
                {
                    string id = Text(path, dot, "dots.id", "id");
                    if (!places.TryGetValue(id, out List<Vector2D>? points))
                        places.Add(id, points = new List<Vector2D>());
                    points.Add(new Vector2D(Number(path, dot, "dots.x", "x"), Number(path, dot, "dots.y", "y")));
                }
            }

            var shots = new List<TruthShot>();
            foreach (JsonElement shot in Items(path, list, "shots"))
            {
                string where = "shots[" + shots.Count + "]", id = Text(path, shot, where + ".id", "id");
                int first = Integer(path, shot, where + ".first_frame", "first_frame");
                if (!places.TryGetValue(id, out List<Vector2D>? points))
                    throw new InputException(path, where + ": no frame has a dot \"" + id + "\"", Remedy);
                shots.Add(new TruthShot(id, ColorOf(root), first, first + Integer(path, shot, where + ".frames", "frames") - 1, points));
            }

            JsonElement size = root.TryGetProperty("color", out JsonElement color) && color.ValueKind == JsonValueKind.Object ? color : root;
            return new TruthClip(Text(path, root, "file", "file"), Integer(path, size, "width", "width"), shots);
        }

        /// <summary>The laser's colour, from the channel to which the dots' light was added most.</summary>
        private static string? ColorOf(JsonElement root)
        {
            if (!root.TryGetProperty("dot_model", out JsonElement model) || model.ValueKind != JsonValueKind.Object ||
                !model.TryGetProperty("additive_peak_rgb", out JsonElement rgb) || rgb.ValueKind != JsonValueKind.Array || rgb.GetArrayLength() != 3 ||
                rgb.EnumerateArray().Any(n => n.ValueKind != JsonValueKind.Number))
                return null;
            return rgb[1].GetDouble() >= rgb[0].GetDouble() ? "green" : "red";
        }

        private static string Id(JsonElement shot, int index) =>
            !shot.TryGetProperty("id", out JsonElement id) ? index.ToString(System.Globalization.CultureInfo.InvariantCulture)
            : id.ValueKind == JsonValueKind.String ? id.GetString()! : id.GetRawText();

        private static JsonElement.ArrayEnumerator Items(string path, JsonElement list, string where) =>
            list.ValueKind == JsonValueKind.Array ? list.EnumerateArray() : throw new InputException(path, where + " is no list", Remedy);

        private static JsonElement Object(string path, JsonElement value, string where) =>
            value.ValueKind == JsonValueKind.Object ? value : throw new InputException(path, where + " is no object", Remedy);

        private static JsonElement Member(string path, JsonElement parent, string where, string name) =>
            Object(path, parent, where).TryGetProperty(name, out JsonElement value) ? value : throw new InputException(path, where + " is missing", Remedy);

        private static string Text(string path, JsonElement parent, string where, string name)
        {
            JsonElement value = Member(path, parent, where, name);
            return value.ValueKind == JsonValueKind.String ? value.GetString()! : throw new InputException(path, where + " is no text", Remedy);
        }

        private static int Integer(string path, JsonElement parent, string where, string name)
        {
            JsonElement value = Member(path, parent, where, name);
            return value.ValueKind == JsonValueKind.Number && value.TryGetInt32(out int number) ? number : throw new InputException(path, where + " is no whole number", Remedy);
        }

        private static double Number(string path, JsonElement parent, string where, string name)
        {
            JsonElement value = Member(path, parent, where, name);
            return value.ValueKind == JsonValueKind.Number ? value.GetDouble() : throw new InputException(path, where + " is no number", Remedy);
        }
    }
}
