using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using UnityEngine;
using Pose = LaserTracking.Geometry.Pose;

namespace LaserTracking.Unity
{
    /// <summary>Objects of a described scene that something else than a path moves, by their numbers in it, and what shots go through. Main thread only.</summary>
    internal sealed class MovedObjects
    {
        public static readonly MovedObjects None = new MovedObjects();

        private readonly List<(int Index, Transform Object, TargetMotion Motion)> _objects = new List<(int, Transform, TargetMotion)>();
        private ScreenSurface? _screen;
        private Transform? _viewpoint;

        public int Count => _objects.Count;

        /// <summary>What shots go through, which may move too.</summary>
        public void SetView(ScreenSurface screen, Transform viewpoint)
        {
            _screen = screen;
            _viewpoint = viewpoint;
        }

        public void Add(int index, Transform moved, TargetMotion motion) => _objects.Add((index, moved, motion));

        /// <summary>Notes where they are now.</summary>
        /// <param name="log">Of the scene that they belong to.</param>
        /// <param name="unityTimeS">Unity's time, seconds.</param>
        /// <param name="clockOffsetS">Of the range that is recorded: to be added for the scene's clock.</param>
        public void Log(ScenePoseLog log, double unityTimeS, double clockOffsetS)
        {
            if (_screen != null && _viewpoint != null)
            {
                log.Add(ScenePoseLog.Surface, unityTimeS + clockOffsetS, _screen.Pose);
                log.Add(ScenePoseLog.Viewpoint, unityTimeS + clockOffsetS, new Pose(_viewpoint.position.ToCore(), Rotation3D.Identity));
            }

            foreach ((int index, Transform moved, TargetMotion motion) in _objects)
            {
                if (moved != null && motion != null)
                    log.Add(index, unityTimeS + motion.ClockOffsetS, moved.WorldPose());
            }
        }
    }
}
