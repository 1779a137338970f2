using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace LaserTracking.Repository
{
    /// <summary>One "--- !u!class &amp;id" document of a Unity file, as lines: enough to check how it is written and what it refers to.</summary>
    internal sealed class YamlDocument
    {
        private static readonly Regex Head = new Regex(@"^--- !u!(\d+) &(-?\d+)$");

        // {fileID: n} or {fileID: n, guid: g, type: t}; also split over the end of a list entry.
        private static readonly Regex Reference = new Regex(@"\{fileID: (-?\d+)(?:, guid: ([0-9a-f]{32}), type: (\d))?\}");

        private YamlDocument(string file, int classId, long fileId, string[] lines)
        {
            File = file;
            ClassId = classId;
            FileId = fileId;
            Lines = lines;
        }

        public string File { get; }

        public int ClassId { get; }

        public long FileId { get; }

        /// <summary>Without the head; the first is the class name.</summary>
        public IReadOnlyList<string> Lines { get; }

        /// <summary>Everything it refers to: the id, and the GUID of the other file or "".</summary>
        public IEnumerable<(long FileId, string Guid)> References =>
            Lines.SelectMany(line => Reference.Matches(line)).Select(match => (long.Parse(match.Groups[1].Value), match.Groups[2].Value));

        /// <summary>Documents of a file; lines that are no head before the first one are left to the caller.</summary>
        public static List<YamlDocument> Read(string file)
        {
            var documents = new List<YamlDocument>();
            string[] lines = RepositoryFiles.Read(file).TrimEnd('\n').Split('\n');
            for (int i = 0; i < lines.Length; i++)
            {
                Match head = Head.Match(lines[i]);
                if (head.Success)
                    documents.Add(new YamlDocument(file, int.Parse(head.Groups[1].Value), long.Parse(head.Groups[2].Value), lines.Skip(i + 1).TakeWhile(line => !line.StartsWith("--- ")).ToArray()));
            }

            return documents;
        }

        /// <summary>The references in the value of a key: on its line, or in the list below it.</summary>
        public IEnumerable<long> Ids(string key)
        {
            int at = Lines.ToList().FindIndex(line => line.StartsWith("  " + key + ":"));
            if (at < 0)
                return Enumerable.Empty<long>();
            return new[] { Lines[at] }.Concat(Lines.Skip(at + 1).TakeWhile(line => line.StartsWith("  - "))).SelectMany(line => Reference.Matches(line)).Select(match => long.Parse(match.Groups[1].Value));
        }

        /// <summary>GUID of the script, or "" when it has none.</summary>
        public string ScriptGuid => Lines.Where(line => line.StartsWith("  m_Script: ")).Select(line => Reference.Match(line).Groups[2].Value).FirstOrDefault() ?? "";

        public override string ToString() => File + " &" + FileId;
    }
}
