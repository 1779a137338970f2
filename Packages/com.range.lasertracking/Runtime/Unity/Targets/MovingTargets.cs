using System.Collections.Generic;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// The enabled target motions of all loaded scenes. Static because a ray meets the colliders of every scene, whoever loaded
    /// it; emptied when play begins, since editors may keep statics from the last run. Parents come before their children: a
    /// world pose set first would be moved on by the parent.
    /// </summary>
    internal static class MovingTargets
    {
        private static readonly List<TargetMotion> Enabled = new List<TargetMotion>();

        public static int Count => Enabled.Count;

        public static TargetMotion At(int index) => Enabled[index];

        public static void Add(TargetMotion motion)
        {
            int depth = Depth(motion), index = Enabled.Count;
            while (index > 0 && Depth(Enabled[index - 1]) > depth)
                index--;
            Enabled.Insert(index, motion);
        }

        public static void Remove(TargetMotion motion) => Enabled.Remove(motion);

        private static int Depth(TargetMotion motion)
        {
            int depth = 0;
            for (Transform? above = motion.transform.parent; above != null; above = above.parent)
                depth++;
            return depth;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Clear() => Enabled.Clear();
    }
}
