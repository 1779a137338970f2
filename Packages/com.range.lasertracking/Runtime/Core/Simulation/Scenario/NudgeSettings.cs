using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>A bump after which camera 0's picture stays displaced.</summary>
    public sealed class NudgeSettings
    {
        /// <summary>Seconds after the beginning.</summary>
        public double TimeS { get; set; }

        /// <summary>Displacement of the whole picture, px.</summary>
        public Vector2D ShiftPx { get; set; }

        internal void Visit(ScenarioVisitor v)
        {
            TimeS = v.Number("time_s", TimeS, 0, 36000);
            ShiftPx = v.Point("shift_px", ShiftPx, 500) ?? default;
        }
    }
}
