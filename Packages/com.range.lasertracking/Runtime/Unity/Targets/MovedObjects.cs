using System.Collections.Generic;
using LaserTracking.Scoring;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>Objects of a described scene that something else than a path moves, by their numbers in it. Main thread only.</summary>
    internal sealed class MovedObjects
    {
        public static readonly MovedObjects None = new MovedObjects();

        private readonly List<(int Index, Transform Object, TargetMotion Motion)> _objects = new List<(int, Transform, TargetMotion)>();

        public int Count => _objects.Count;

        public void Add(int index, Transform moved, TargetMotion motion) => _objects.Add((index, moved, motion));

        /// <summary>Notes where they are now.</summary>
        /// <param name="log">Of the scene that they belong to.</param>
        /// <param name="unityTimeS">Unity's time, seconds.</param>
        public void Log(ScenePoseLog log, double unityTimeS)
        {
            foreach ((int index, Transform moved, TargetMotion motion) in _objects)
            {
                if (moved != null && motion != null)
                    log.Add(index, unityTimeS + motion.ClockOffsetS, moved.WorldPose());
            }
        }
    }
}
