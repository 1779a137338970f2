using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace LaserTracking.Unity
{
    /// <summary>One serialised object: its class, its id in the file and its fields by name.</summary>
    internal sealed class UnityYamlObject
    {
        private readonly YamlMappingNode _fields;

        public UnityYamlObject(int classId, long fileId, YamlMappingNode fields)
        {
            ClassId = classId;
            FileId = fileId;
            _fields = fields;
        }

        public int ClassId { get; }

        public long FileId { get; }

        public YamlMappingNode AllFields => _fields;

        public static float Number(YamlNode node) => float.Parse(((YamlScalarNode)node).Value!, CultureInfo.InvariantCulture);

        public static Vector3 Vector(YamlNode node) => new Vector3(Number(node["x"]), Number(node["y"]), Number(node["z"]));

        /// <summary>"{fileID, guid, type}": the id, and the GUID or null for the same file.</summary>
        public static (long FileId, string? Guid) Reference(YamlNode node)
        {
            var map = (YamlMappingNode)node;
            long id = long.Parse(((YamlScalarNode)map["fileID"]).Value!, CultureInfo.InvariantCulture);
            return (id, map.Children.TryGetValue("guid", out YamlNode? guid) ? ((YamlScalarNode)guid).Value : null);
        }

        public YamlNode Field(string name) => _fields[name];

        public string Text(string name) => ((YamlScalarNode)_fields[name]).Value!;

        public float Number(string name) => Number(_fields[name]);

        public int Integer(string name) => int.Parse(Text(name), CultureInfo.InvariantCulture);

        public bool Flag(string name) => Integer(name) != 0;

        public Vector3 Vector(string name) => Vector(_fields[name]);

        public Quaternion Rotation(string name) =>
            new Quaternion(Number(_fields[name]["x"]), Number(_fields[name]["y"]), Number(_fields[name]["z"]), Number(_fields[name]["w"]));

        public long Id(string name) => Reference(_fields[name]).FileId;

        public IEnumerable<YamlNode> List(string name) => (YamlSequenceNode)_fields[name];
    }
}
