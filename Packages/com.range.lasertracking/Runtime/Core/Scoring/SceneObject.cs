using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>Something in the scene that a ray can meet; a target when it has a definition. Scene space (Unity's), metres.</summary>
    public sealed class SceneObject
    {
        private readonly SceneCollider[] _colliders;
        private readonly Rotation3D _parentRotation;

        /// <param name="name">Unique among the scene's targets.</param>
        /// <param name="layer">0…31, as in Unity.</param>
        /// <param name="restPose">World pose at zero displacement.</param>
        /// <param name="scale">World scale, component by component.</param>
        /// <param name="parentRotation">Turns the motion's displacement from the parent's axes into the world's.</param>
        /// <param name="motion">Displacement as a function of time.</param>
        /// <param name="colliders">Enabled colliders, in component order.</param>
        /// <param name="target">What a hit is worth, or null for scenery.</param>
        public SceneObject(string name, int layer, Pose restPose, Vector3D scale, Rotation3D parentRotation, MotionPath motion,
            SceneCollider[] colliders, TargetDefinition? target)
        {
            if (layer < 0 || layer > 31)
                throw new ArgumentException("object " + name + ": layers run from 0 to 31");
            Name = name;
            Layer = layer;
            RestPose = restPose;
            Scale = scale;
            _parentRotation = parentRotation;
            Motion = motion;
            _colliders = (SceneCollider[])colliders.Clone();
            Target = target;
        }

        public string Name { get; }

        public int Layer { get; }

        public Pose RestPose { get; }

        public Vector3D Scale { get; }

        public MotionPath Motion { get; }

        public IReadOnlyList<SceneCollider> Colliders => _colliders;

        public TargetDefinition? Target { get; }

        /// <summary>World pose at a time in seconds on the scene's clock. No allocation.</summary>
        public Pose PoseAt(double timeS) =>
            new Pose(RestPose.Position + _parentRotation * Motion.OffsetAt(timeS), RestPose.Rotation);
    }
}
