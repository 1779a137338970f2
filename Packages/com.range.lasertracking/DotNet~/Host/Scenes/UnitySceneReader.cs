using System;
using System.Collections.Generic;
using System.IO;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Host.Scenes;

/// <summary>
/// Reads a Unity scene (.unity, text format) and the target definitions it refers to into the model that the headless raycaster
/// works on. Whatever it cannot take over exactly is refused with one line, never skipped.
/// </summary>
internal sealed class UnitySceneReader
{
    private readonly string _file;
    private readonly UnityHierarchy _hierarchy;
    private readonly TargetDefinitionReader _definitions;

    private UnitySceneReader(string file, UnityProject project)
    {
        _file = file;
        _hierarchy = UnityHierarchy.Read(file, project);
        _definitions = new TargetDefinitionReader(project);
    }

    /// <param name="file">Path of the .unity file; assets are found in the project around it.</param>
    /// <exception cref="InputException">The scene cannot be taken over: what, where, what to do.</exception>
    public static SceneModel Read(string file) => new UnitySceneReader(file, UnityProject.Around(file)).Read();

    private SceneModel Read()
    {
        var objects = new List<SceneObject>();
        var names = new HashSet<string>(StringComparer.Ordinal);
        UnityComponent? range = null;
        foreach (UnityGameObject owner in _hierarchy.Objects)
        {
            if (!owner.IsActive)
                continue;
            UnityComponent? rig = owner.Enabled(ProductScripts.LaserRange);
            if (rig != null)
                range = range == null ? rig : throw rig.Fields.Problem("is the second active LaserRange of the scene", "disable one");
            if (TryReadObject(owner, names, out SceneObject? read))
                objects.Add(read!);
        }

        if (range == null)
            throw new InputException(_file, "has no active LaserRange component", "add one to the scene (it names the screen, the viewpoint and the layers)");
        return ReadModel(range.Fields, objects.ToArray());
    }

    private SceneModel ReadModel(UnityFields range, SceneObject[] objects)
    {
        UnityGameObject screen = Owner(range, "_screen", ProductScripts.ScreenSurface, out UnityFields surface);
        UnityGameObject eye = Owner(range, "_viewpoint", "", out _);
        Vector2D size = surface.Vector2("_sizeM");
        if (!(size.X > 0 && size.Y > 0))
            throw surface.Problem("field _sizeM is not above zero in both directions");
        if (!IsUnit(screen.Scale) || screen.IsSheared)
            throw screen.Fields.Problem("the screen is scaled, so its size in metres is in doubt", "give it and all above it the scale 1 1 1 and set _sizeM");
        if (MotionAbove(screen, out _) != null || MotionAbove(eye, out _) != null)
            throw range.Problem("the screen or the viewpoint moves", "remove TargetMotion from them and from what is above them");
        if (!(screen.Pose.InverseTransformPoint(eye.Pose.Position).Z < -1e-3))
            throw range.Problem("the viewpoint is not in front of the screen", "move it to the side of the screen's negative z axis");
        return new SceneModel(Path.GetFileNameWithoutExtension(_file), screen.Pose, size, eye.Pose.Position, range.Layers("_hitLayers"), objects);
    }

    private bool TryReadObject(UnityGameObject owner, HashSet<string> names, out SceneObject? read)
    {
        read = null;
        var colliders = new List<SceneCollider>();
        foreach (UnityComponent component in owner.Components)
        {
            if (UnityClass.IsCollider(component.ClassId) && ColliderReader.TryRead(component, owner, out SceneCollider collider))
                colliders.Add(collider);
        }

        UnityComponent? target = owner.Enabled(ProductScripts.LaserTarget);
        if (colliders.Count == 0)
        {
            if (target != null)
                throw target.Fields.Problem("has no enabled collider on its own object, so nothing can hit it", "add one or disable the target");
            return false;
        }

        ExpectNoOwnScripts(owner);
        if (target == null)
            ExpectNoTargetAbove(owner);
        else if (!names.Add(owner.Name))
            throw owner.Fields.Problem("a second target of that name", "give every target a name of its own");
        MotionPath motion = ReadMotion(owner, out Rotation3D parentRotation);
        TargetDefinition? definition = target == null ? null : _definitions.Read(target.Fields, "_definition");
        read = new SceneObject(owner.Name, owner.Layer, owner.Pose, owner.Scale, parentRotation, motion, colliders.ToArray(), definition);
        return true;
    }

    /// <summary>The motion of the object or of what carries it, in metres of the world along the axes of the mover's parent.</summary>
    private static MotionPath ReadMotion(UnityGameObject owner, out Rotation3D parentRotation)
    {
        parentRotation = Rotation3D.Identity;
        UnityFields? fields = MotionAbove(owner, out UnityGameObject? mover);
        if (fields == null)
            return default;
        Vector3D travel = fields.Vector3("_travelM");
        if (mover!.Parent != null)
        {
            if (mover.Parent.IsSheared)
                throw fields.Problem("moves below a sheared parent", "give the parents the scale 1 1 1");
            parentRotation = mover.Parent.Pose.Rotation;
            travel = Vector3D.Scale(mover.Parent.Scale, travel);
        }

        var kind = fields.Choice<MotionKind>("_kind");
        double period = fields.Number("_periodS");
        if (kind != MotionKind.None && !(period > 0))
            throw fields.Problem("field _periodS is not above zero");
        return new MotionPath(kind, travel, period, fields.Number("_phaseS"));
    }

    private static UnityFields? MotionAbove(UnityGameObject owner, out UnityGameObject? mover)
    {
        UnityFields? found = null;
        mover = null;
        for (UnityGameObject? candidate = owner; candidate != null; candidate = candidate.Parent)
        {
            UnityFields? fields = candidate.Enabled(ProductScripts.TargetMotion)?.Fields;
            if (fields == null || fields.Choice<MotionKind>("_kind") == MotionKind.None)
                continue;
            if (found != null)
                throw found.Problem($"moves inside \"{candidate.Path}\", which moves too", "let only one of them move");
            found = fields;
            mover = candidate;
        }

        return found;
    }

    private static void ExpectNoTargetAbove(UnityGameObject owner)
    {
        for (UnityGameObject? candidate = owner.Parent; candidate != null; candidate = candidate.Parent)
        {
            if (candidate.Enabled(ProductScripts.LaserTarget) != null)
                throw owner.Fields.Problem($"has a collider below the target \"{candidate.Path}\"", "move the collider to the target's own object or remove it");
        }
    }

    private static void ExpectNoOwnScripts(UnityGameObject owner)
    {
        for (UnityGameObject? candidate = owner; candidate != null; candidate = candidate.Parent)
        {
            foreach (UnityComponent component in candidate.Components)
            {
                if (component.Script.EndsWith(".cs", StringComparison.Ordinal) && component.Fields.Flag("m_Enabled"))
                    throw component.Fields.Problem($"the script {component.Script} may move what shots can hit, and is not run headlessly", "use TargetMotion or take it off this object");
            }
        }
    }

    private UnityGameObject Owner(UnityFields range, string field, string script, out UnityFields fields)
    {
        UnityReference reference = range.Reference(field);
        foreach (UnityGameObject candidate in _hierarchy.Objects)
        {
            UnityComponent? component = script.Length == 0 ? null : candidate.Enabled(script);
            bool found = script.Length == 0 ? candidate.TransformId == reference.FileId : component?.FileId == reference.FileId;
            if (!found)
                continue;
            if (!candidate.IsActive)
                throw range.Problem($"field {field} refers to an inactive object", "activate it");
            fields = component?.Fields ?? candidate.Transform;
            return candidate;
        }

        throw range.Problem(reference.IsNull ? $"field {field} is empty" : $"field {field} refers to nothing enabled in the scene",
            script.Length == 0 ? "assign a Transform" : "assign a " + script);
    }

    private static bool IsUnit(Vector3D scale) => (scale - new Vector3D(1, 1, 1)).Length < 1e-4;
}
