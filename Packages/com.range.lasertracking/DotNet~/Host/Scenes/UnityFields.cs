using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using LaserTracking.Geometry;
using YamlDotNet.Core;
using YamlDotNet.RepresentationModel;

namespace LaserTracking.Host.Scenes
{
    /// <summary>
    /// The fields of one serialised object, read by name and type. Whatever is missing or malformed is refused with the file, the
    /// object, the field and a remedy: a default taken in silence would make the headless scene differ from Unity's.
    /// </summary>
    internal sealed class UnityFields
    {
        private const string Remedy = "correct the field or save the file again in Unity";
        private readonly YamlMappingNode _node;

        private UnityFields(string file, string label, YamlMappingNode node)
        {
            File = file;
            Label = label;
            _node = node;
        }

        public string File { get; }

        /// <summary>The object for people: what it is, its name and its line.</summary>
        public string Label { get; private set; }

        public IEnumerable<string> Names
        {
            get
            {
                foreach (YamlNode key in _node.Children.Keys)
                    yield return (key as YamlScalarNode)?.Value ?? "";
            }
        }

        public static UnityFields Parse(UnityDocument document)
        {
            string label = $"{document.TypeName} at line {document.Line}";
            try
            {
                var stream = new YamlStream();
                stream.Load(new ShallowYamlParser(new StringReader(string.Join('\n', document.Body))));
                if (stream.Documents.Count == 1 && stream.Documents[0].RootNode is YamlMappingNode { Children.Count: 1 } root
                    && root.Children[0].Value is YamlMappingNode fields)
                    return new UnityFields(document.File, label, fields);
            }
            catch (YamlException e)
            {
                throw new InputException(document.File, $"{label}: broken YAML in line {document.Line + e.Start.Line}", Remedy);
            }

            throw new InputException(document.File, $"{label}: not one mapping of fields", Remedy);
        }

        /// <summary>Sets what messages call the object, once its name is known.</summary>
        public UnityFields Named(string label)
        {
            Label = label;
            return this;
        }

        public InputException Problem(string what, string remedy = Remedy) => new(File, $"{Label}: {what}", remedy);

        /// <summary>Refuses fields that are not in the list, and fields of the list that are not there.</summary>
        public void ExpectExactly(IReadOnlyCollection<string> expected, IReadOnlyCollection<string> tolerated)
        {
            foreach (string name in Names)
            {
                if (!Contains(expected, name) && !Contains(tolerated, name))
                    throw Problem($"unknown field {name}", "correct its name (" + string.Join(", ", expected) + ")");
            }

            foreach (string name in expected)
                Required(name);
        }

        public bool Has(string field) => _node.Children.ContainsKey(new YamlScalarNode(field));

        public string Text(string field) => Scalar(Required(field), field);

        public double Number(string field) => Number(Required(field), field);

        public int Integer(string field) => Integer(Required(field), field);

        public bool Flag(string field)
        {
            int value = Integer(field);
            return value is 0 or 1 ? value == 1 : throw Problem($"field {field} is {value} in place of 0 or 1");
        }

        /// <summary>An enumeration stored as its number.</summary>
        public T Choice<T>(string field)
            where T : struct, Enum
        {
            int value = Integer(field);
            if (!Enum.IsDefined(typeof(T), value))
                throw Problem($"field {field} is {value}, which no {typeof(T).Name} has", "use one of " + string.Join(", ", Choices<T>()));
            return (T)(object)value;
        }

        public Vector2D Vector2(string field) => Vector2(Required(field), field);

        public Vector3D Vector3(string field)
        {
            YamlMappingNode node = Mapping(Required(field), field, "x", "y", "z");
            return new Vector3D(Part(node, field, "x"), Part(node, field, "y"), Part(node, field, "z"));
        }

        public Rotation3D Rotation(string field)
        {
            YamlMappingNode node = Mapping(Required(field), field, "x", "y", "z", "w");
            double x = Part(node, field, "x"), y = Part(node, field, "y"), z = Part(node, field, "z"), w = Part(node, field, "w");
            if (Math.Abs(Math.Sqrt(x * x + y * y + z * z + w * w) - 1) > 0.01)
                throw Problem($"field {field} is not a unit quaternion");
            return new Rotation3D(x, y, z, w);
        }

        public UnityReference Reference(string field) => Reference(Required(field), field);

        /// <summary>A list of references; null where the field is absent.</summary>
        public List<UnityReference> References(string field, string? inner = null)
        {
            var list = new List<UnityReference>();
            foreach (YamlNode item in Sequence(field))
            {
                YamlNode node = item;
                if (inner != null && !(item is YamlMappingNode mapping && mapping.Children.TryGetValue(new YamlScalarNode(inner), out node!)))
                    throw Problem($"field {field}: an entry without {inner}");
                list.Add(Reference(node, field));
            }

            return list;
        }

        public List<UnityFields> Items(string field)
        {
            var list = new List<UnityFields>();
            foreach (YamlNode item in Sequence(field))
            {
                if (item is not YamlMappingNode mapping)
                    throw Problem($"field {field}: entry {list.Count} is not a mapping");
                list.Add(new UnityFields(File, $"{Label}, {field} entry {list.Count}", mapping));
            }

            return list;
        }

        public Vector2D[] Points(string field)
        {
            var list = new List<Vector2D>();
            foreach (YamlNode item in Sequence(field))
                list.Add(Vector2(item, field));
            return list.ToArray();
        }

        /// <summary>A LayerMask.</summary>
        public int Layers(string field)
        {
            YamlMappingNode node = Mapping(Required(field), field, "m_Bits");
            string text = Scalar(node.Children[new YamlScalarNode("m_Bits")], field);
            return uint.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out uint bits)
                ? unchecked((int)bits) : throw Problem($"field {field}.m_Bits is \"{text}\" in place of a whole number");
        }

        private static string[] Choices<T>()
            where T : struct, Enum =>
            Array.ConvertAll(Enum.GetValues<T>(), value => FormattableString.Invariant($"{(int)(object)value} ({value})"));

        private static bool Contains(IReadOnlyCollection<string> names, string name)
        {
            foreach (string candidate in names)
            {
                if (candidate == name)
                    return true;
            }

            return false;
        }

        private YamlNode Required(string field) =>
            _node.Children.TryGetValue(new YamlScalarNode(field), out YamlNode? node) ? node : throw Problem($"field {field} is missing");

        private IEnumerable<YamlNode> Sequence(string field) =>
            Required(field) as YamlSequenceNode ?? throw Problem($"field {field} is not a list");

        private YamlMappingNode Mapping(YamlNode node, string field, params string[] parts)
        {
            if (node is YamlMappingNode mapping && Array.TrueForAll(parts, part => mapping.Children.ContainsKey(new YamlScalarNode(part))))
                return mapping;
            throw Problem($"field {field} is not {{{string.Join(", ", parts)}}}");
        }

        private Vector2D Vector2(YamlNode node, string field)
        {
            YamlMappingNode mapping = Mapping(node, field, "x", "y");
            return new Vector2D(Part(mapping, field, "x"), Part(mapping, field, "y"));
        }

        private double Part(YamlMappingNode node, string field, string part) => Number(node.Children[new YamlScalarNode(part)], field + "." + part);

        private string Scalar(YamlNode node, string field) =>
            (node as YamlScalarNode)?.Value ?? throw Problem($"field {field} is not a single value");

        private double Number(YamlNode node, string field)
        {
            string text = Scalar(node, field);
            if (!double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) || !double.IsFinite(value))
                throw Problem($"field {field} is \"{text}\" in place of a finite number");
            return value;
        }

        private int Integer(YamlNode node, string field)
        {
            string text = Scalar(node, field);
            return int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value)
                ? value : throw Problem($"field {field} is \"{text}\" in place of a whole number");
        }

        private UnityReference Reference(YamlNode node, string field)
        {
            YamlMappingNode mapping = Mapping(node, field, "fileID");
            string text = Scalar(mapping.Children[new YamlScalarNode("fileID")], field);
            if (!long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long fileId))
                throw Problem($"field {field}: the fileID \"{text}\" is not a number");
            string guid = mapping.Children.TryGetValue(new YamlScalarNode("guid"), out YamlNode? g) ? Scalar(g, field) : "";
            return new UnityReference(fileId, guid);
        }
    }
}
