using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// Casts rays into the scene as it stood at a given time: analytically, headless, or with Unity's physics. Answers as
    /// Physics.Raycast does: nearest first, a collider that holds the origin is not hit, layers and triggers are honoured.
    /// </summary>
    public interface IRaycaster
    {
        /// <param name="ray">Scene space, metres.</param>
        /// <param name="maxDistanceM">Hits beyond do not count.</param>
        /// <param name="sceneTimeS">Moment on the scene's clock for which the objects' poses are taken.</param>
        /// <param name="hit">The nearest hit, when there is one.</param>
        bool TryRaycast(in Ray3D ray, double maxDistanceM, double sceneTimeS, out RaycastHit hit);

        /// <summary>Name and definition of the object a hit names; definition null for scenery. Valid while the scene lives.</summary>
        bool TryGetTarget(int objectIndex, out string name, out TargetDefinition? definition);
    }
}
