using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;
using UnityEngine.UIElements;
using UnityStandIn;
using YamlDotNet.RepresentationModel;
using Object = UnityEngine.Object;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Loads a scene file into the stand-in as Unity would: objects, transforms, colliders, the package's components with their
    /// serialised fields. What only draws is left out; anything unknown is an error.
    /// </summary>
    internal sealed class SceneLoader
    {
        private const int GameObjectClass = 1;
        private const int TransformClass = 4;
        private const int ScriptClass = 114;

        // AudioListener, Light, MeshFilter; settings and roots of the scene.
        private static readonly int[] NotModelled = { 81, 108, 33, 29, 104, 157, 196, 1660057539 };
        private const string UnitysScripts = "0000000000000000e000000000000000";
        private static readonly string[] UnitysOwn = { "m_ObjectHideFlags", "m_CorrespondingSourceObject", "m_PrefabInstance", "m_PrefabAsset", "m_GameObject", "m_Enabled", "m_EditorHideFlags", "m_Script", "m_Name", "m_EditorClassIdentifier" };

        private readonly UnityYamlFile _file;
        private readonly Dictionary<long, UnityYamlObject> _byId;
        private readonly Dictionary<long, Object> _made = new Dictionary<long, Object>();
        private readonly Dictionary<string, ScriptableObject> _assets = new Dictionary<string, ScriptableObject>();
        private readonly Dictionary<string, string> _pathOfGuid;
        private readonly SerializedValues _values;

        private SceneLoader(string path)
        {
            _file = new UnityYamlFile(path);
            _byId = _file.Documents.ToDictionary(document => document.FileId);
            _pathOfGuid = new[] { "Assets", "Packages" }.SelectMany(folder => Directory.GetFiles(Path.Combine(TestFiles.Repository, folder), "*.meta", SearchOption.AllDirectories))
                .ToDictionary(meta => File.ReadLines(meta).ElementAt(1).Substring("guid: ".Length), meta => meta.Substring(0, meta.Length - ".meta".Length));
            _values = new SerializedValues(Resolve);
        }

        /// <summary>Everything awake and enabled when it returns.</summary>
        public static void Load(string path) => new SceneLoader(path).Load();

        private void Load()
        {
            foreach (UnityYamlObject document in OfClass(GameObjectClass))
                MakeObject(document);
            foreach (UnityYamlObject document in OfClass(TransformClass))
                Place(document);
            // References may point anywhere, so fields come when everything exists; Awake when all fields are there.
            foreach (UnityYamlObject document in OfClass(ScriptClass))
            {
                _values.Apply(_made[document.FileId], document.AllFields, name => UnitysOwn.Contains(name));
                ((Behaviour)_made[document.FileId]).enabled = document.Flag("m_Enabled");
            }

            foreach (UnityYamlObject document in OfClass(GameObjectClass))
                ((GameObject)_made[document.FileId]).SetActive(document.Flag("m_IsActive"));
        }

        private IEnumerable<UnityYamlObject> OfClass(int classId) => _file.Documents.Where(document => document.ClassId == classId);

        private void MakeObject(UnityYamlObject document)
        {
            var made = new GameObject(document.Text("m_Name"));
            made.SetActive(false);
            made.layer = document.Integer("m_Layer");
            made.tag = document.Text("m_TagString");
            _made.Add(document.FileId, made);
            foreach (YamlNode entry in document.List("m_Component"))
            {
                UnityYamlObject component = _byId[UnityYamlObject.Reference(entry["component"]).FileId];
                if (component.ClassId == TransformClass)
                    _made.Add(component.FileId, made.transform);
                else if (component.ClassId == ScriptClass)
                    _made.Add(component.FileId, made.AddComponent(ScriptType(component)));
                else if (component.ClassId == 20)
                    made.AddComponent<Camera>().fieldOfView = component.Number("field of view");
                else if (component.ClassId == 23)
                    made.AddComponent<MeshRenderer>();
                else if (!NotModelled.Contains(component.ClassId))
                    _made.Add(component.FileId, AddCollider(made, component));
            }
        }

        private void Place(UnityYamlObject document)
        {
            var transform = (Transform)_made[document.FileId];
            transform.localPosition = document.Vector("m_LocalPosition");
            transform.localRotation = document.Rotation("m_LocalRotation");
            transform.localScale = document.Vector("m_LocalScale");
            foreach (YamlNode child in document.List("m_Children"))
                ((Transform)_made[UnityYamlObject.Reference(child).FileId]).SetParent(transform, false);
        }

        private static Collider AddCollider(GameObject owner, UnityYamlObject document)
        {
            Collider added;
            switch (document.ClassId)
            {
                case 65:
                    BoxCollider box = owner.AddComponent<BoxCollider>();
                    box.size = document.Vector("m_Size");
                    box.center = document.Vector("m_Center");
                    added = box;
                    break;
                case 135:
                    SphereCollider sphere = owner.AddComponent<SphereCollider>();
                    sphere.radius = document.Number("m_Radius");
                    sphere.center = document.Vector("m_Center");
                    added = sphere;
                    break;
                case 136:
                    CapsuleCollider capsule = owner.AddComponent<CapsuleCollider>();
                    capsule.radius = document.Number("m_Radius");
                    capsule.height = document.Number("m_Height");
                    capsule.direction = document.Integer("m_Direction");
                    capsule.center = document.Vector("m_Center");
                    added = capsule;
                    break;
                case 64:
                    MeshCollider mesh = owner.AddComponent<MeshCollider>();
                    mesh.sharedMesh = BuiltInMesh(document.Id("m_Mesh"));
                    added = mesh;
                    break;
                default:
                    throw new NotSupportedException("class " + document.ClassId + " &" + document.FileId);
            }

            added.isTrigger = document.Flag("m_IsTrigger");
            added.enabled = document.Flag("m_Enabled");
            return added;
        }

        private static Mesh BuiltInMesh(long id)
        {
            if (id != 10210)
                throw new NotSupportedException("built-in mesh " + id);
            GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            Mesh mesh = quad.GetComponent<MeshFilter>().sharedMesh;
            Object.DestroyImmediate(quad);
            return mesh;
        }

        private Object? Resolve(long id, string? guid, Type type)
        {
            if (guid == null)
                return _made[id];
            if (!_assets.TryGetValue(guid, out ScriptableObject? asset))
            {
                string path = _pathOfGuid[guid];
                if (type == typeof(TextAsset))
                    return new TextAsset(File.ReadAllText(path));
                if (path.EndsWith(".mat", StringComparison.Ordinal))
                    return new Material(null) { name = Path.GetFileNameWithoutExtension(path) };
                if (path.EndsWith(".tss", StringComparison.Ordinal))
                    return null;
                UnityYamlObject document = new UnityYamlFile(path).Documents.Single();
                asset = ScriptableObject.CreateInstance(ScriptType(document));
                asset.name = document.Text("m_Name");
                _assets.Add(guid, asset);
                _values.Apply(asset, document.AllFields, name => UnitysOwn.Contains(name));
            }

            return asset;
        }

        private Type ScriptType(UnityYamlObject document)
        {
            (long id, string? guid) = UnityYamlObject.Reference(document.Field("m_Script"));
            if (guid == UnitysScripts)
                return id == 19101 ? typeof(PanelSettings) : id == 19102 ? typeof(UIDocument) : throw new NotSupportedException("built-in script " + id);
            string name = Path.GetFileNameWithoutExtension(_pathOfGuid[guid!]);
            return typeof(LaserRange).Assembly.GetTypes().Single(type => type.Name == name);
        }
    }
}
