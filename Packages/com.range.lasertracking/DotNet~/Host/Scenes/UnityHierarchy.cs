using System.Collections.Generic;

namespace LaserTracking.Host.Scenes
{
    /// <summary>All GameObjects of a scene in hierarchy order, checked for agreement between the two ends of every link.</summary>
    internal sealed class UnityHierarchy
    {
        // Unity itself warns long before; a damaged file must not exhaust the stack.
        private const int DeepestLevel = 256;

        private readonly string _file;
        private readonly UnityProject _project;
        private readonly Dictionary<long, UnityDocument> _documents = new();
        private readonly Dictionary<long, UnityFields> _fields = new();
        private readonly List<UnityGameObject> _objects = new();
        private readonly HashSet<long> _placed = new();

        private UnityHierarchy(string file, UnityProject project)
        {
            _file = file;
            _project = project;
        }

        public IReadOnlyList<UnityGameObject> Objects => _objects;

        /// <summary>Throws <see cref="InputException"/> for whatever would make the headless scene differ from Unity's.</summary>
        public static UnityHierarchy Read(string file, UnityProject project)
        {
            var hierarchy = new UnityHierarchy(file, project);
            UnityFields? roots = null;
            foreach (UnityDocument document in UnityDocument.ReadAll(file))
            {
                if (document.ClassId == UnityClass.PrefabInstance || document.IsStripped)
                    throw new InputException(file, $"line {document.Line}: a prefab instance", "unpack it in Unity (Prefab, Unpack Completely) and save the scene");
                if (UnityClass.IsHarmless(document.ClassId))
                {
                    hierarchy._documents.Add(document.FileId, document);
                    continue;
                }

                if (!UnityClass.IsRead(document.ClassId))
                {
                    throw new InputException(file, $"line {document.Line}: unknown class {document.ClassId} ({document.TypeName})",
                        "remove that component, or keep it in a scene that is not replayed headlessly");
                }

                UnityFields fields = UnityFields.Parse(document);
                if (document.ClassId == UnityClass.SceneRoots)
                    roots = fields;
                hierarchy._documents.Add(document.FileId, document);
                hierarchy._fields.Add(document.FileId, fields);
            }

            foreach (long root in hierarchy.Roots(roots))
                hierarchy.Place(root, null);
            hierarchy.ExpectEverythingPlaced();
            return hierarchy;
        }

        private IEnumerable<long> Roots(UnityFields? sceneRoots)
        {
            var listed = new List<long>();
            if (sceneRoots != null)
            {
                foreach (UnityReference reference in sceneRoots.References("m_Roots"))
                    listed.Add(reference.FileId);
                return listed;
            }

            // Before 2022.3 the order stood in each Transform.
            var ordered = new List<(int Order, long Id)>();
            foreach ((long id, UnityFields fields) in _fields)
            {
                if (_documents[id].ClassId != UnityClass.Transform || !fields.Reference("m_Father").IsNull)
                    continue;
                if (!fields.Has("m_RootOrder"))
                    throw new InputException(_file, "lists no root objects: its end is missing", "restore it from version control");
                ordered.Add((fields.Integer("m_RootOrder"), id));
            }

            // Stable: objects of equal order stay as the file has them.
            int[] keys = ordered.ConvertAll(entry => entry.Order).ToArray();
            foreach (int index in StableOrder(keys))
                listed.Add(ordered[index].Id);
            return listed;
        }

        private static int[] StableOrder(int[] keys)
        {
            var indices = new int[keys.Length];
            for (int i = 0; i < indices.Length; i++)
                indices[i] = i;
            System.Array.Sort(indices, (a, b) => keys[a] != keys[b] ? keys[a].CompareTo(keys[b]) : a.CompareTo(b));
            return indices;
        }

        private void Place(long transformId, UnityGameObject? parent, int level = 0)
        {
            if (level > DeepestLevel)
                throw parent!.Fields.Problem($"lies more than {DeepestLevel} levels deep", "flatten the hierarchy");
            UnityFields transform = Find(transformId, UnityClass.Transform, parent == null ? "SceneRoots" : parent.Fields.Label);
            if (!_placed.Add(transformId))
                throw transform.Problem("is listed as a child twice");
            long father = transform.Reference("m_Father").FileId;
            if (parent == null ? father != 0 : !_placed.Contains(father) || _fields[father] != parent.Transform)
                throw transform.Problem("m_Father and the parent's list of children disagree");
            long ownerId = transform.Reference("m_GameObject").FileId;
            UnityFields fields = Find(ownerId, UnityClass.GameObject, transform.Label);
            if (!_placed.Add(ownerId))
                throw fields.Problem("has two Transforms");

            var placed = new UnityGameObject(fields, transform, transformId, parent);
            _objects.Add(placed);
            foreach (UnityReference component in fields.References("m_Component", "component"))
                Attach(placed, component.FileId, ownerId);
            foreach (UnityReference child in transform.References("m_Children"))
                Place(child.FileId, placed, level + 1);
        }

        private void Attach(UnityGameObject owner, long componentId, long ownerId)
        {
            if (!_documents.TryGetValue(componentId, out UnityDocument? document))
                throw owner.Fields.Problem($"its component {componentId} is not in the file");
            if (!_fields.TryGetValue(componentId, out UnityFields? fields))
                return;
            if (fields.Reference("m_GameObject").FileId != ownerId)
                throw owner.Fields.Problem($"its component {componentId} ({document.TypeName}) belongs to another object");
            if (document.ClassId == UnityClass.Transform)
            {
                if (fields != owner.Transform)
                    throw owner.Fields.Problem("has two Transforms");
                return;
            }

            if (!_placed.Add(componentId))
                throw owner.Fields.Problem($"lists its component {componentId} twice");
            fields.Named($"object \"{owner.Path}\", {document.TypeName}");
            string script = document.ClassId == UnityClass.MonoBehaviour ? Script(fields, owner) : "";
            owner.Components.Add(new UnityComponent(document.ClassId, componentId, script, fields));
        }

        /// <summary>The product class of a MonoBehaviour; empty for a script of the project; refuses one that nobody knows.</summary>
        private string Script(UnityFields fields, UnityGameObject owner)
        {
            string guid = fields.Reference("m_Script").Guid;
            if (ProductScripts.ClassByGuid.TryGetValue(guid, out string? name))
            {
                fields.Named($"object \"{owner.Path}\", {name}");
                if (name == ProductScripts.TargetDefinitionAsset)
                    throw fields.Problem("is an asset, not a component");
                fields.ExpectExactly(ProductScripts.FieldsByClass[name], ProductScripts.OptionalFields(name));
                return name;
            }

            if (guid == ProductScripts.UnitysOwn || ProductScripts.ShowingByGuid.ContainsKey(guid))
                return "";
            if (!_project.TryFind(guid, out string relative, out _))
                throw fields.Problem($"unknown component class: no script has the guid \"{guid}\"", "remove the component or bring its script and .meta into the project");
            return relative.StartsWith(ProductScripts.PackageFolder, System.StringComparison.Ordinal) ? "" : relative;
        }

        private UnityFields Find(long id, int classId, string from)
        {
            if (!_fields.TryGetValue(id, out UnityFields? fields) || _documents[id].ClassId != classId)
                throw new InputException(_file, $"{from}: the object {id} it refers to is not in the file", "save the scene again in Unity");
            return fields;
        }

        private void ExpectEverythingPlaced()
        {
            foreach ((long id, UnityFields fields) in _fields)
            {
                if (_documents[id].ClassId != UnityClass.SceneRoots && !_placed.Contains(id))
                    throw fields.Problem("nothing in the hierarchy refers to it", "save the scene again in Unity");
            }
        }
    }
}
