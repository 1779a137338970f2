using LaserTracking.Session;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>A shot as something to draw: its way through the scene as it stood when the light left. World space, metres.</summary>
    public struct ShotTrace
    {
        public ShotEvent Shot;

        /// <summary>The muzzle where it is known, else the eye from which the picture is drawn.</summary>
        public Vector3 From;

        /// <summary>The dot on the screen.</summary>
        public Vector3 OnScreen;

        /// <summary>Where it ends: on a target, on scenery, or in the distance.</summary>
        public Vector3 End;

        /// <summary>What it ended on: the target, or the scenery's object; null in the distance.</summary>
        public Transform? Met;

        /// <summary>The end in the axes of what was met (its position and rotation, not its scale), so that it can move on with it.</summary>
        public Vector3 LocalEnd;

        /// <summary>The surface's normal there, in the same axes.</summary>
        public Vector3 LocalNormal;

        /// <summary>The target that was hit; null for a miss.</summary>
        public LaserTarget? Target;
    }
}
