using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace LaserTracking.Unity
{
    /// <summary>The lists of Unity's public signatures: one line a type or member, "type | signature | tags".</summary>
    internal sealed class SignatureList
    {
        private static readonly Regex TypeLine =
            new Regex(@"^(\[.*\] )?((static|sealed|abstract|readonly|ref|record) )*(class|struct|interface|enum)$");

        private readonly Dictionary<string, string> _tags = new Dictionary<string, string>();
        private readonly Dictionary<string, string> _kinds = new Dictionary<string, string>();
        private readonly Dictionary<string, string[]> _bases = new Dictionary<string, string[]>();

        public SignatureList(params string[] files)
        {
            foreach (string line in files.SelectMany(File.ReadLines))
            {
                string[] fields = line.Split(" | ");
                string[] head = fields[0].Split(" where ")[0].Split(" : ");
                string name = head[0];
                string tags = string.Join(", ", fields.Skip(2));
                if (head.Length == 1 && !IsTypeLine(fields[1]))
                {
                    _tags[name + " | " + fields[1]] = tags;
                    continue;
                }

                _tags[name] = tags;
                _kinds[name] = fields[1];
                _bases[name] = head.Length == 1 ? new string[0] : head[1].Split(", ");
            }
        }

        /// <summary>Tags of a type ("Namespace.Type") or member ("Namespace.Type | signature"); false when it is not listed.</summary>
        public bool TryGetTags(string entry, out string tags) => _tags.TryGetValue(entry, out tags!);

        public string KindOf(string type) => _kinds[type];

        public IReadOnlyList<string> BasesOf(string type) => _bases[type];

        private static bool IsTypeLine(string text) => TypeLine.IsMatch(text);
    }
}
