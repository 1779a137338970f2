using System;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>Shape and value of one type of target, shared by all targets of that type.</summary>
    [CreateAssetMenu(fileName = "Target", menuName = "Laser Tracking/Target Definition")]
    public sealed class TargetDefinitionAsset : ScriptableObject
    {
        [SerializeField]
        private TargetKind _kind;

        [SerializeField]
        [Tooltip("Width and height in metres of the box that holds all zones.")]
        private Vector2 _sizeM = new Vector2(0.5f, 0.5f);

        [SerializeField]
        [Tooltip("In order of precedence: the first zone that holds a point counts.")]
        private TargetZoneData[] _zones = Array.Empty<TargetZoneData>();

        /// <exception cref="InputException">The values describe no target; the message names the asset.</exception>
        public TargetDefinition ToDefinition()
        {
            try
            {
                return new TargetDefinition(name, _kind, _sizeM.ToCore(), Array.ConvertAll(_zones, zone => zone.ToZone()));
            }
            catch (ArgumentException problem)
            {
                throw new InputException("target definition " + name, problem.Message, "correct the asset's zones in the Inspector");
            }
        }
    }
}
