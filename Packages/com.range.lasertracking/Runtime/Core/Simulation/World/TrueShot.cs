using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Simulation
{
    /// <summary>One pulse of light as it really was.</summary>
    public sealed class TrueShot
    {
        /// <summary>Counts from 1 in order of time.</summary>
        public int Id { get; internal set; }

        /// <summary>When the light began, on camera 0's clock.</summary>
        public long TimeUs { get; internal set; }

        /// <summary>When the light began, true µs since the beginning: the scene's clock.</summary>
        public long SceneTimeUs { get; internal set; }

        /// <summary>How long it was on.</summary>
        public double PulseUs { get; internal set; }

        /// <summary>Number of the shooter, from 1.</summary>
        public int Shooter { get; internal set; }

        public HandSide Hand { get; internal set; }

        public LaserColor Color { get; internal set; }

        /// <summary>Where the light began.</summary>
        public Vector2D ScreenM { get; internal set; }

        /// <summary>The same in camera 0's picture (bumps included), whether or not a frame saw it.</summary>
        public Vector2D FirstLightPx { get; internal set; }

        /// <summary>First delivered colour frame with its light, or -1: it fell between the exposures.</summary>
        public int FirstFrame { get; internal set; } = -1;

        /// <summary>Last delivered colour frame with its light, or -1.</summary>
        public int LastFrame { get; internal set; } = -1;

        /// <summary>In screen space, when the light began.</summary>
        public Vector3D MuzzleM { get; internal set; }

        /// <summary>Unit vector muzzle → dot when the light began.</summary>
        public Vector3D Direction { get; internal set; }

        /// <summary>Name of the target that was aimed at, or empty.</summary>
        public string AimedAt { get; internal set; } = "";

        /// <summary>Target behind the point of light as seen from the scene's viewpoint, at the photon time; empty for none.</summary>
        public string Target { get; internal set; } = "";

        /// <summary>Zone of that target; empty for none.</summary>
        public string Zone { get; internal set; } = "";

        /// <summary>Points of that zone.</summary>
        public int Points { get; internal set; }

        /// <summary>Target that the picture on the screen showed there, which is the scene as it was drawn a moment before.</summary>
        public string ShownTarget { get; internal set; } = "";

        public string ShownZone { get; internal set; } = "";
    }
}
