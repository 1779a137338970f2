using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using YamlDotNet.RepresentationModel;

namespace LaserTracking.Unity
{
    /// <summary>A scene or asset file, cut at its document heads, which no YAML reader understands.</summary>
    internal sealed class UnityYamlFile
    {
        private static readonly Regex Head = new Regex(@"^--- !u!(\d+) &(-?\d+)$");

        public UnityYamlFile(string path)
        {
            Path = path;
            string[] lines = File.ReadAllLines(path);
            for (int i = 0; i < lines.Length; i++)
            {
                Match head = Head.Match(lines[i]);
                if (!head.Success)
                    continue;
                var stream = new YamlStream();
                stream.Load(new StringReader(string.Join("\n", lines.Skip(i + 1).TakeWhile(line => !line.StartsWith("--- ", StringComparison.Ordinal)))));
                var body = (YamlMappingNode)((YamlMappingNode)stream.Documents[0].RootNode).Children.Single().Value;
                Documents.Add(new UnityYamlObject(int.Parse(head.Groups[1].Value), long.Parse(head.Groups[2].Value), body));
            }
        }

        public string Path { get; }

        public List<UnityYamlObject> Documents { get; } = new List<UnityYamlObject>();
    }
}
