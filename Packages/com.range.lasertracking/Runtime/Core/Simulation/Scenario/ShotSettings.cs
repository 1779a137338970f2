using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>One pulse of light. Above 300 ms it is a dot that is held on.</summary>
    public sealed class ShotSettings
    {
        /// <summary>When the light begins, seconds after the beginning.</summary>
        public double TimeS { get; set; }

        /// <summary>Number of the shooter, from 1.</summary>
        public int Shooter { get; set; } = 1;

        /// <summary>How long the light is on, ms.</summary>
        public double PulseMs { get; set; } = 40;

        /// <summary>Name of the target aimed at, or empty when <see cref="ScreenM"/> is given.</summary>
        public string Target { get; set; } = "";

        /// <summary>Point aimed at in the target's plane, m from its centre, x right, y up.</summary>
        public Vector2D OffsetM { get; set; }

        /// <summary>Point of the screen aimed at, m, without aim error.</summary>
        public Vector2D? ScreenM { get; set; }

        /// <summary>Deliberate movement of the dot over the screen while the light is on, m/s: makes streaks.</summary>
        public Vector2D SweepMPerS { get; set; }

        internal double EndS => TimeS + PulseMs / 1000;

        internal void Visit(ScenarioVisitor v)
        {
            TimeS = v.Number("time_s", TimeS, 0, 36000);
            Shooter = v.Integer("shooter", Shooter, 1, 1000);
            PulseMs = v.Number("pulse_ms", PulseMs, 0.1, 3.6e7);
            Target = v.Text("target", Target);
            OffsetM = v.Point("offset_m", OffsetM, 10) ?? default;
            ScreenM = v.Point("screen_m", ScreenM, 100);
            SweepMPerS = v.Point("sweep_m_per_s", SweepMPerS, 100) ?? default;
            if (Target.Length == 0 && ScreenM == null)
                v.Refuse("target", "is missing", "give the name of a target, or screen_m");
            if (Target.Length > 0 && ScreenM != null)
                v.Refuse("screen_m", "stands beside a target", "give only one of them");
        }
    }
}
