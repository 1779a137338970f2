using System.Collections.Generic;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// The enabled target motions of all loaded scenes. Static because a ray meets the colliders of every scene, whoever loaded
    /// it; emptied when play begins, since editors may keep statics from the last run.
    /// </summary>
    internal static class MovingTargets
    {
        private static readonly List<TargetMotion> Enabled = new List<TargetMotion>();

        public static int Count => Enabled.Count;

        public static TargetMotion At(int index) => Enabled[index];

        public static void Add(TargetMotion motion) => Enabled.Add(motion);

        public static void Remove(TargetMotion motion) => Enabled.Remove(motion);

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Clear() => Enabled.Clear();
    }
}
