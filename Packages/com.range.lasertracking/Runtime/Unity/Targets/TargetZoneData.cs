using System;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>A <see cref="TargetZone"/> as Unity stores it: the field names are those in the .asset files, never rename one.</summary>
    [Serializable]
    public sealed class TargetZoneData
    {
        [Tooltip("As shown to trainers: A, 10, head.")]
        public string name = "";

        [Tooltip("Score of a hit; negative for a penalty.")]
        public int points;

        public ZoneShape shape;

        [Tooltip("Centre of ellipse or rectangle in metres, x right, y up, from the target's centre.")]
        public Vector2 centerM;

        [Tooltip("Full width and height of ellipse or rectangle in metres.")]
        public Vector2 sizeM;

        [Tooltip("Corners of a polygon in order, in metres.")]
        public Vector2[] cornersM = Array.Empty<Vector2>();

        /// <exception cref="ArgumentException">The values describe no zone.</exception>
        public TargetZone ToZone() =>
            new TargetZone(name, points, shape, centerM.ToCore(), sizeM.ToCore(), Array.ConvertAll(cornersM, UnityConversions.ToCore));
    }
}
