using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>Something in the scene that a ray can meet; a target when it has a definition. Scene space (Unity's), metres.</summary>
    public sealed class SceneObject
    {
        private readonly SceneCollider[] _colliders;
        private readonly PoseTrack? _recorded;

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
            ParentRotation = parentRotation;
            Motion = motion;
            _colliders = (SceneCollider[])colliders.Clone();
            Target = target;
        }

        private SceneObject(SceneObject other, PoseTrack recorded)
            : this(other.Name, other.Layer, other.RestPose, other.Scale, other.ParentRotation, other.Motion, other._colliders, other.Target)
        {
            _recorded = recorded;
        }

        public string Name { get; }

        public int Layer { get; }

        public Pose RestPose { get; }

        public Vector3D Scale { get; }

        public MotionPath Motion { get; }

        /// <summary>Turns the motion's displacement into the world's axes.</summary>
        public Rotation3D ParentRotation { get; }

        public IReadOnlyList<SceneCollider> Colliders => _colliders;

        public TargetDefinition? Target { get; }

        /// <summary>World pose at a time in seconds on the scene's clock. No allocation.</summary>
        public Pose PoseAt(double timeS) =>
            _recorded?.PoseAt(timeS) ?? new Pose(RestPose.Position + ParentRotation * Motion.OffsetAt(timeS), RestPose.Rotation);

        /// <summary>The same object where it was recorded to be, whatever moved it.</summary>
        public SceneObject MovedBy(PoseTrack recorded) => new SceneObject(this, recorded);
    }
}
