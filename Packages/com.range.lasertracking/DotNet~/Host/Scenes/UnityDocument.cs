using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text.RegularExpressions;

namespace LaserTracking.Host.Scenes
{
    /// <summary>One "--- !u!CLASS &amp;ID" document of a file in Unity's text format, not yet parsed.</summary>
    internal sealed partial class UnityDocument
    {
        private UnityDocument(string file, int classId, long fileId, int line, bool stripped, string[] body)
        {
            File = file;
            ClassId = classId;
            FileId = fileId;
            Line = line;
            IsStripped = stripped;
            Body = body;
            int colon = body.Length > 0 ? body[0].IndexOf(':') : -1;
            TypeName = colon > 0 ? body[0][..colon].Trim() : "";
        }

        public string File { get; }

        /// <summary>Unity's number for the class: 1 GameObject, 4 Transform, 114 MonoBehaviour…</summary>
        public int ClassId { get; }

        /// <summary>Unique in its file.</summary>
        public long FileId { get; }

        /// <summary>1-based line of the head.</summary>
        public int Line { get; }

        /// <summary>A placeholder for an object inside a prefab instance.</summary>
        public bool IsStripped { get; }

        public string TypeName { get; }

        public string[] Body { get; }

        /// <summary>Splits a file at its document heads. Throws <see cref="InputException"/> when it is not Unity's text format.</summary>
        public static List<UnityDocument> ReadAll(string path)
        {
            string[] lines = ReadLines(path);
            if (lines.Length == 0 || lines[0].Length == 0 && lines.Length == 1)
                throw new InputException(path, "the file is empty", "restore it from version control");
            if (!lines[0].StartsWith("%YAML", StringComparison.Ordinal))
            {
                bool pointer = lines[0].StartsWith("version https://git-lfs", StringComparison.Ordinal);
                throw new InputException(path, pointer ? "line 1: a git LFS pointer, not the file itself" : "line 1: not a scene or asset in Unity's text format",
                    pointer ? "run git lfs pull" : "give a .unity file saved with Asset Serialization = Force Text");
            }

            var documents = new List<UnityDocument>();
            var seen = new HashSet<long>();
            int head = Array.FindIndex(lines, IsHead);
            if (head < 0)
                throw new InputException(path, "holds no object at all", "save the scene again in Unity");
            while (head < lines.Length)
            {
                int next = head + 1;
                while (next < lines.Length && !IsHead(lines[next]))
                    next++;
                Match match = Head().Match(lines[head]);
                if (!match.Success || !int.TryParse(match.Groups[1].ValueSpan, NumberStyles.None, CultureInfo.InvariantCulture, out int classId)
                    || !long.TryParse(match.Groups[2].ValueSpan, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long fileId))
                    throw new InputException(path, $"line {head + 1}: not a document head of the form \"--- !u!CLASS &ID\"", "save the scene again in Unity");
                if (!seen.Add(fileId))
                    throw new InputException(path, $"line {head + 1}: the id {fileId} is used twice", "save the scene again in Unity");
                documents.Add(new UnityDocument(path, classId, fileId, head + 1, match.Groups[3].Success, lines[(head + 1)..next]));
                head = next;
            }

            return documents;
        }

        private static string[] ReadLines(string path)
        {
            if (Directory.Exists(path))
                throw new InputException(path, "is a folder", "give a file that ends in .unity");
            if (!System.IO.File.Exists(path))
                throw new InputException(path, "there is no such file", "check the path");
            try
            {
                return System.IO.File.ReadAllLines(path);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                throw new InputException(path, "cannot be read", "check its permissions");
            }
        }

        private static bool IsHead(string line) => line.StartsWith("---", StringComparison.Ordinal);

        [GeneratedRegex(@"^--- !u!(\d+) &(-?\d+)( stripped)?\s*$")]
        private static partial Regex Head();
    }
}
