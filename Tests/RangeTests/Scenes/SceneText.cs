using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;

namespace LaserTracking.Scenes
{
    /// <summary>Writes small scenes in Unity's format, with no more fields than Unity always writes.</summary>
    internal sealed class SceneText
    {
        public const string RangeGuid = "b33198d265cad9bf2143c3cead4383f8";
        public const string SurfaceGuid = "626b6a64b9c32c7604acc4dfcae72615";
        public const string TargetGuid = "c3e9f9eb2bfb6c8c8c75d334ce0696af";
        public const string MotionGuid = "ce71f8e935d783cc490767973868b6e6";

        private readonly List<Node> _nodes = new();

        /// <summary>Starts with a rig: the published screen at the origin and an eye 5 m in front.</summary>
        public SceneText()
        {
            int rig = Add("Rig");
            int screen = Add("Screen", rig);
            int eye = Add("Eye", rig, "{x: 0, y: 0, z: -5}");
            int surface = Script(screen, SurfaceGuid, "  _sizeM: {x: 3.73, y: 2.26}\n  _calibration: {fileID: 0}\n");
            Script(rig, RangeGuid, $"  _screen: {{fileID: {surface}}}\n  _viewpoint: {{fileID: {_nodes[eye].Transform}}}\n"
                + "  _hitLayers:\n    serializedVersion: 2\n    m_Bits: 4294967295\n  _source: {fileID: 0}\n");
        }

        /// <summary>False writes the roots as editors before 2022.3 did.</summary>
        public bool WithSceneRoots { get; set; } = true;

        public int Add(string name, int parent = -1, string position = "{x: 0, y: 0, z: 0}", string rotation = "{x: 0, y: 0, z: 0, w: 1}",
            string scale = "{x: 1, y: 1, z: 1}", bool active = true)
        {
            _nodes.Add(new Node(name, parent, position, rotation, scale, active, 100 * (_nodes.Count + 1)));
            return _nodes.Count - 1;
        }

        public int Box(int node, bool enabled = true, bool trigger = false, string size = "{x: 1, y: 1, z: 1}") => Component(node, 65, "BoxCollider",
            $"  m_IsTrigger: {(trigger ? 1 : 0)}\n  m_Enabled: {(enabled ? 1 : 0)}\n  m_NewerField: 3\n  m_Size: {size}\n  m_Center: {{x: 0, y: 0, z: 0}}\n");

        public int Script(int node, string guid, string fields, bool enabled = true) => Component(node, 114, "MonoBehaviour",
            $"  m_Enabled: {(enabled ? 1 : 0)}\n  m_Script: {{fileID: 11500000, guid: {guid}, type: 3}}\n{fields}");

        public int Motion(int node, string travel, bool enabled = true) =>
            Script(node, MotionGuid, $"  _kind: 1\n  _travelM: {travel}\n  _periodS: 4\n  _phaseS: 0.5\n", enabled);

        public override string ToString()
        {
            var text = new StringBuilder("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!29 &1\nOcclusionCullingSettings:\n  anything: [goes\n");
            for (int i = 0; i < _nodes.Count; i++)
            {
                Node node = _nodes[i];
                text.Append(CultureInfo.InvariantCulture, $"--- !u!1 &{node.Id}\nGameObject:\n  m_Component:\n  - component: {{fileID: {node.Transform}}}\n");
                foreach ((int id, _) in node.Components)
                    text.Append(CultureInfo.InvariantCulture, $"  - component: {{fileID: {id}}}\n");
                text.Append(CultureInfo.InvariantCulture, $"  m_Layer: 3\n  m_Name: {node.Name}\n  m_IsActive: {(node.Active ? 1 : 0)}\n");
                string father = node.Parent < 0 ? "0" : _nodes[node.Parent].Transform.ToString(CultureInfo.InvariantCulture);
                text.Append(CultureInfo.InvariantCulture, $"--- !u!4 &{node.Transform}\nTransform:\n  m_GameObject: {{fileID: {node.Id}}}\n");
                text.Append($"  m_LocalRotation: {node.Rotation}\n  m_LocalPosition: {node.Position}\n  m_LocalScale: {node.Scale}\n");
                int[] children = Enumerable.Range(0, _nodes.Count).Where(child => _nodes[child].Parent == i).ToArray();
                text.Append(children.Length == 0 ? "  m_Children: []\n" : "  m_Children:\n");
                foreach (int child in children)
                    text.Append(CultureInfo.InvariantCulture, $"  - {{fileID: {_nodes[child].Transform}}}\n");
                text.Append($"  m_Father: {{fileID: {father}}}\n");
                if (!WithSceneRoots)
                    text.Append(CultureInfo.InvariantCulture, $"  m_RootOrder: {_nodes.Count - i}\n");
                foreach ((_, string document) in node.Components)
                    text.Append(document);
            }

            if (WithSceneRoots)
            {
                text.Append("--- !u!1660057539 &9223372036854775807\nSceneRoots:\n  m_Roots:\n");
                foreach (Node node in _nodes.Where(node => node.Parent < 0))
                    text.Append(CultureInfo.InvariantCulture, $"  - {{fileID: {node.Transform}}}\n");
            }

            return text.ToString();
        }

        private int Component(int node, int classId, string type, string fields)
        {
            Node owner = _nodes[node];
            int id = owner.Id + 2 + owner.Components.Count;
            owner.Components.Add((id, $"--- !u!{classId} &{id}\n{type}:\n  m_GameObject: {{fileID: {owner.Id}}}\n{fields}"));
            return id;
        }

        private sealed record Node(string Name, int Parent, string Position, string Rotation, string Scale, bool Active, int Id)
        {
            public int Transform => Id + 1;

            public List<(int Id, string Document)> Components { get; } = new();
        }
    }
}
