using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// Shape and value of one type of target: zones in the target's plane (metres, x right, y up, origin at its centre), the most
    /// valuable first. Immutable; shared by all targets of the type.
    /// </summary>
    public sealed class TargetDefinition
    {
        private readonly TargetZone[] _zones;

        public TargetDefinition(string name, TargetKind kind, Vector2D sizeM, TargetZone[] zones)
        {
            if (zones.Length == 0)
                throw new ArgumentException("target " + name + " needs at least one zone");
            if (!(sizeM.X > 0 && sizeM.Y > 0))
                throw new ArgumentException("target " + name + ": width and height must be above zero");
            Name = name;
            Kind = kind;
            SizeM = sizeM;
            _zones = (TargetZone[])zones.Clone();
        }

        public string Name { get; }

        public TargetKind Kind { get; }

        /// <summary>Width and height of the box that holds all zones.</summary>
        public Vector2D SizeM { get; }

        /// <summary>In order of precedence: the first zone that holds a point counts.</summary>
        public IReadOnlyList<TargetZone> Zones => _zones;

        /// <summary>Index of the first zone that holds the point, or -1: beside the outline.</summary>
        public int ZoneAt(Vector2D pointM)
        {
            for (int i = 0; i < _zones.Length; i++)
            {
                if (_zones[i].Contains(pointM))
                    return i;
            }

            return -1;
        }
    }
}
