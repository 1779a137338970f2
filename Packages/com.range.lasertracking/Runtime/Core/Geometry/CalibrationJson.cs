using System;
using System.Globalization;
using System.IO;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// What all calibration files share: reading, version, kind, and numbers with messages that name the field. Throws
    /// <see cref="InputException"/> only.
    /// </summary>
    public static class CalibrationJson
    {
        /// <summary>The version that this program writes, and the newest that it reads.</summary>
        public const int Version = 1;

        internal const string Remedy = "calibrate again, or correct the field";

        /// <summary>The file's JSON object.</summary>
        public static JObject ReadFile(string path)
        {
            if (Directory.Exists(path))
                throw new InputException(path, "this is a folder, not a calibration file", "name the .json file");
            if (!File.Exists(path))
                throw new InputException(path, "no such file", "'./range calibrate' makes one");
            try
            {
                return Parse(File.ReadAllText(path), path);
            }
            catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException)
            {
                throw new InputException(path, "cannot be read (" + problem.Message.TrimEnd('.') + ")", "check its permissions");
            }
        }

        /// <param name="json">Content of the file.</param>
        /// <param name="name">As the user named it, for messages.</param>
        public static JObject Parse(string json, string name)
        {
            try
            {
                using var reader = new JsonTextReader(new StringReader(json));
                JToken root = JToken.Load(reader, new JsonLoadSettings());

                // Whatever stands behind it is refused by the reader.
                while (reader.Read())
                {
                }

                if (root is JObject found)
                    return found;
                string what = root.Type == JTokenType.Array ? "a list" : "a single value";
                throw new InputException(name, "this is JSON, but " + what + " and not one object with named fields", "write it as {\"field\": …}, as the help of the command says");
            }
            catch (JsonReaderException problem)
            {
                throw new InputException(name, FormattableString.Invariant($"not JSON at line {problem.LineNumber}, column {problem.LinePosition}"), Remedy);
            }
        }

        /// <summary>Refuses another kind, and what <see cref="CheckVersion"/> refuses.</summary>
        /// <param name="root">The file's content.</param>
        /// <param name="name">As the user named it, for messages.</param>
        /// <param name="kind">What is wanted: "screen", "camera", ….</param>
        /// <param name="maker">The command that makes such files.</param>
        public static void CheckKind(JObject root, string name, string kind, string maker)
        {
            CheckVersion(root, name);
            string found = (string?)(root["kind"] as JValue) ?? "none";
            if (found != kind)
                throw new InputException(name, "field kind is \"" + found + "\", this needs a calibration of kind \"" + kind + "\"", "name a file that " + maker + " made");
        }

        /// <summary>Refuses files of a newer version: what they say may mean something else. No version is version 1.</summary>
        /// <param name="root">The file's content.</param>
        /// <param name="name">As the user named it, for messages.</param>
        public static void CheckVersion(JObject root, string name)
        {
            JToken? version = root["v"];
            if (version != null && (version.Type != JTokenType.Integer || !((double)version >= 1)))
                throw new InputException(name, "field v is no version number", Remedy);
            if (version != null && (double)version > Version)
                throw new InputException(name, FormattableString.Invariant($"written by a newer release (version {version}, this one reads up to {Version})"), "update the program, or calibrate again with this one");
        }

        /// <summary>A list of so many finite numbers.</summary>
        public static double[] Numbers(JToken? token, int count, string name, string field)
        {
            if (!(token is JArray list) || list.Count != count)
                throw new InputException(name, FormattableString.Invariant($"field {field} must be {count} numbers"), Remedy);
            var result = new double[count];
            for (int i = 0; i < count; i++)
            {
                bool isNumber = list[i].Type == JTokenType.Float || list[i].Type == JTokenType.Integer;
                result[i] = isNumber ? Convert.ToDouble(((JValue)list[i]).Value, CultureInfo.InvariantCulture) : double.NaN;
                if (double.IsNaN(result[i]) || double.IsInfinity(result[i]))
                    throw new InputException(name, FormattableString.Invariant($"field {field}, element {i + 1}, is not a finite number"), Remedy);
            }

            return result;
        }

        /// <summary>A square matrix, row by row.</summary>
        public static double[] Matrix(JToken? token, int side, string name, string field)
        {
            if (!(token is JArray rows) || rows.Count != side)
                throw new InputException(name, FormattableString.Invariant($"field {field} must be {side} rows of {side} numbers"), Remedy);
            var result = new double[side * side];
            for (int row = 0; row < side; row++)
                Numbers(rows[row], side, name, field).CopyTo(result, row * side);
            return result;
        }

        /// <summary>Width and height in pixels.</summary>
        public static int[] ImageSize(JToken? token, string name, string field)
        {
            double[] size = Numbers(token, 2, name, field);
            if (!(size[0] >= 1 && size[1] >= 1 && size[0] <= 65536 && size[1] <= 65536))
                throw new InputException(name, "field " + field + " must be a width and a height in pixels", Remedy);
            return new[] { (int)size[0], (int)size[1] };
        }

        /// <summary>A square matrix as a list of rows.</summary>
        public static JArray Rows(double[] matrix, int side)
        {
            var rows = new JArray();
            for (int i = 0; i < side; i++)
                rows.Add(new JArray(matrix.AsSpan(i * side, side).ToArray()));
            return rows;
        }
    }
}
