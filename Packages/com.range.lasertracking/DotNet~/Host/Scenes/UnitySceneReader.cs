using System;
using System.Collections.Generic;
using System.IO;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Host.Scenes
{
    /// <summary>
    /// Reads a Unity scene (.unity, text format) and the target definitions it refers to into the model that the headless raycaster
    /// works on. Whatever it cannot take over exactly is refused with one line, never skipped.
    /// </summary>
    internal sealed class UnitySceneReader
    {
        private readonly string _file;
        private readonly UnityHierarchy _hierarchy;
        private readonly SceneObjectReader _objects;

        private UnitySceneReader(string file, UnityProject project)
        {
            _file = file;
            _hierarchy = UnityHierarchy.Read(file, project);
            _objects = new SceneObjectReader(_hierarchy, new TargetDefinitionReader(project));
        }

        /// <param name="file">Path of the .unity file; assets are found in the project around it.</param>
        /// <exception cref="InputException">The scene cannot be taken over: what, where, what to do.</exception>
        public static SceneModel Read(string file) => new UnitySceneReader(file, UnityProject.Around(file)).Read();

        private SceneModel Read()
        {
            UnityFields? range = null;
            foreach (UnityGameObject owner in _hierarchy.Objects)
            {
                UnityFields? rig = owner.IsActive ? owner.Enabled(ProductScripts.LaserRange)?.Fields : null;
                if (rig != null)
                    range = range == null ? rig : throw rig.Problem("is the second active LaserRange of the scene", "disable one");
            }

            if (range == null)
                throw new InputException(_file, "has no active LaserRange component", "add one to the scene (it names the screen, the viewpoint and the layers)");
            UnityGameObject screen = Owner(range, "_screen", ProductScripts.ScreenSurface, out UnityFields surface);
            UnityGameObject eye = Owner(range, "_viewpoint", "", out _);
            Vector2D size = surface.Vector2("_sizeM");
            if (!(size.X > 0 && size.Y > 0))
                throw surface.Problem("field _sizeM is not above zero in both directions");
            if (surface.Has("_fillsCamera") && surface.Flag("_fillsCamera"))
                throw surface.Problem("the screen follows the camera, which nobody moves here", "switch Fills Camera off and put the screen where the picture is");
            if (SceneObjectReader.MoverOf(screen) != null || SceneObjectReader.MoverOf(eye) != null)
                throw range.Problem("the screen or the viewpoint moves", "remove TargetMotion from them and from what is above them");
            if (!(screen.Pose.InverseTransformPoint(eye.Pose.Position).Z < -1e-3))
                throw range.Problem("the viewpoint is not in front of the screen", "move it to the side of the screen's negative z axis");
            if (range.Has("_aim") && range.Integer("_aim") != 0)
                throw range.Problem("its shots are aimed from the muzzle, here they are cast from the viewpoint", "set Aim to Viewpoint");
            return new SceneModel(Path.GetFileNameWithoutExtension(_file), screen.Pose, size, eye.Pose.Position, range.Layers("_hitLayers"), _objects.ReadAll());
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
    }
}
