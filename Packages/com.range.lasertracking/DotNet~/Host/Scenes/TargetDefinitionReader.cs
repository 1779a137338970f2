using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Host.Scenes
{
    /// <summary>Reads target definitions (Assets/Targets/*.asset) that a scene refers to, each once.</summary>
    internal sealed class TargetDefinitionReader
    {
        private readonly UnityProject _project;
        private readonly Dictionary<string, TargetDefinition> _byGuid = new();

        public TargetDefinitionReader(UnityProject project) => _project = project;

        /// <param name="owner">The component that refers to the asset.</param>
        /// <param name="field">The field that does.</param>
        public TargetDefinition Read(UnityFields owner, string field)
        {
            UnityReference reference = owner.Reference(field);
            if (reference.IsNull)
                throw owner.Problem($"field {field} is empty", "assign a target definition (Assets/Targets)");
            if (_byGuid.TryGetValue(reference.Guid, out TargetDefinition? known))
                return known;
            if (!_project.TryFind(reference.Guid, out _, out string path))
                throw owner.Problem($"field {field}: no asset of the project has the guid \"{reference.Guid}\"", "bring the asset and its .meta back or assign another");
            return _byGuid[reference.Guid] = ReadFile(path, reference.FileId);
        }

        public static TargetDefinition ReadFile(string path, long fileId = 11400000)
        {
            UnityDocument? document = UnityDocument.ReadAll(path).Find(candidate => candidate.FileId == fileId);
            if (document == null || document.ClassId != UnityClass.MonoBehaviour)
                throw new InputException(path, "holds no target definition", "create one in Unity (Create, Laser Tracking, Target Definition)");
            UnityFields fields = UnityFields.Parse(document);
            fields.Named($"target definition \"{fields.Text("m_Name")}\"");
            string guid = fields.Reference("m_Script").Guid;
            if (!ProductScripts.ClassByGuid.TryGetValue(guid, out string? name) || name != ProductScripts.TargetDefinitionAsset)
                throw fields.Problem($"its script (guid \"{guid}\") is not TargetDefinitionAsset", "assign a target definition");
            fields.ExpectExactly(ProductScripts.FieldsByClass[name], ProductScripts.OptionalFields(name));

            var zones = new List<TargetZone>();
            foreach (UnityFields zone in fields.Items("_zones"))
                zones.Add(ReadZone(zone));
            return Checked(fields, () => new TargetDefinition(fields.Text("m_Name"), fields.Choice<TargetKind>("_kind"), fields.Vector2("_sizeM"), zones.ToArray()));
        }

        private static TargetZone ReadZone(UnityFields zone)
        {
            zone.ExpectExactly(ProductScripts.ZoneFields, Array.Empty<string>());
            return Checked(zone, () => new TargetZone(zone.Text("name"), zone.Integer("points"), zone.Choice<ZoneShape>("shape"), zone.Vector2("centerM"),
                zone.Vector2("sizeM"), zone.Points("cornersM")));
        }

        private static T Checked<T>(UnityFields fields, Func<T> create)
        {
            try
            {
                return create();
            }
            catch (ArgumentException e)
            {
                throw fields.Problem(e.Message);
            }
        }
    }
}
