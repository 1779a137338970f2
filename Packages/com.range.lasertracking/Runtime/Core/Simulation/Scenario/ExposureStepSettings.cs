using System;

namespace LaserTracking.Simulation
{
    /// <summary>Camera 0 changes its exposure by itself and keeps it: at once, or settling as automatic exposure does.</summary>
    public sealed class ExposureStepSettings
    {
        /// <summary>Seconds after the beginning.</summary>
        public double TimeS { get; set; }

        /// <summary>Factor on the light of every frame from then on. Exposure times stay as they are.</summary>
        public double Factor { get; set; } = 1;

        /// <summary>Time in which all but a third of the change has happened, s; 0: at once.</summary>
        public double SettleS { get; set; }

        /// <summary>Factor on the light at a time.</summary>
        internal double At(double timeS)
        {
            if (timeS < TimeS)
                return 1;
            return SettleS > 0 ? 1 + (Factor - 1) * (1 - Math.Exp(-(timeS - TimeS) / SettleS)) : Factor;
        }

        internal void Visit(ScenarioVisitor v)
        {
            TimeS = v.Number("time_s", TimeS, 0, 36000);
            Factor = v.Number("factor", Factor, 0.05, 20);
            SettleS = v.Number("settle_s", SettleS, 0, 3600);
        }
    }
}
