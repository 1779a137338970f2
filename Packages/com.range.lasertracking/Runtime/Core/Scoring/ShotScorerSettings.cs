using System;

namespace LaserTracking.Scoring
{
    /// <summary>How far and from where shots reach into the scene. The defaults are the published system's. Immutable.</summary>
    public sealed class ShotScorerSettings
    {
        /// <param name="aim">From where the ray through the dot comes.</param>
        /// <param name="startBehindScreenM">The ray begins this far behind its meeting with the screen; at least 0.</param>
        /// <param name="maxDistanceM">Reach from there; above 0.</param>
        /// <param name="passStepM">
        /// A ray that meets a target's collider beside its outline goes on this far behind the point; above 0, more than the raycaster's
        /// precision (1 mm suits single precision at 100 m) and less than targets stand apart.
        /// </param>
        /// <param name="maxPasses">How many colliders may be met beside an outline before the shot is given up; at least 1.</param>
        public ShotScorerSettings(AimRay aim = AimRay.Viewpoint, double startBehindScreenM = 0.01, double maxDistanceM = 100, double passStepM = 0.001,
            int maxPasses = 16)
        {
            if (!(startBehindScreenM >= 0) || !(maxDistanceM > 0) || !(passStepM > 0))
                throw new ArgumentException("startBehindScreenM is at least 0, maxDistanceM and passStepM are above 0");
            if (maxPasses < 1)
                throw new ArgumentException("maxPasses is at least 1");
            Aim = aim;
            StartBehindScreenM = startBehindScreenM;
            MaxDistanceM = maxDistanceM;
            PassStepM = passStepM;
            MaxPasses = maxPasses;
        }

        public AimRay Aim { get; }

        public double StartBehindScreenM { get; }

        public double MaxDistanceM { get; }

        public double PassStepM { get; }

        public int MaxPasses { get; }
    }
}
