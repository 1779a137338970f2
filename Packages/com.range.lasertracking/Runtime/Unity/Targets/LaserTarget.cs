using System;
using LaserTracking.Scoring;
using LaserTracking.Session;
using UnityEngine;
using UnityEngine.Events;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Makes an object with a collider (its own or a child's) a target. Zones lie in the object's plane z = 0, in metres,
    /// whatever its scale.
    /// </summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("Laser Tracking/Laser Target")]
    public sealed class LaserTarget : MonoBehaviour
    {
        [SerializeField]
        private TargetDefinitionAsset? _definition;

        [SerializeField]
        [Tooltip("Called for every shot that meets this target.")]
        private UnityEvent<ShotEvent> _hit = new UnityEvent<ShotEvent>();

        private TargetDefinition? _coreDefinition;
        private bool _isDefinitionRead;

        /// <summary>Raised on the main thread for every shot that meets this target.</summary>
        public event Action<ShotEvent>? Hit;

        /// <summary>What a hit is worth; null (said once in the Console) when there is no usable definition.</summary>
        public TargetDefinition? Definition
        {
            get
            {
                if (!_isDefinitionRead)
                {
                    _isDefinitionRead = true;
                    _coreDefinition = ReadDefinition();
                }

                return _coreDefinition;
            }
        }

        /// <summary>Tells the listeners. Called by the <see cref="LaserRange"/>.</summary>
        public void ReportHit(in ShotEvent shot)
        {
            ShotEmitter.Raise(this, Hit, _hit, shot);
        }

        private void Start()
        {
            if (GetComponentInChildren<Collider>() == null)
                ShotEmitters.Report(this, "LaserTarget " + name + " has no collider on its object or below, so nothing can hit it; add one", false);
        }

        private TargetDefinition? ReadDefinition()
        {
            if (_definition == null)
            {
                ShotEmitters.Report(this, "LaserTarget " + name + " has no definition: hits on it score nothing; drag a target definition in", false);
                return null;
            }

            try
            {
                return _definition.ToDefinition();
            }
            catch (InputException problem)
            {
                ShotEmitters.Report(this, problem.Message, true);
                return null;
            }
        }
    }
}
