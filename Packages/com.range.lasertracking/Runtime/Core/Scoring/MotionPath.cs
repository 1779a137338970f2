using System;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// A target's displacement as a pure function of time, so that its place at a shot's photon time can be computed afterwards.
    /// The same function moves the object in Unity and in the headless scene.
    /// </summary>
    public readonly struct MotionPath
    {
        /// <param name="kind">Shape of the path.</param>
        /// <param name="travelM">Extent in metres, in the axes of the target's parent.</param>
        /// <param name="periodS">Seconds until it repeats; above zero unless the kind is None.</param>
        /// <param name="phaseS">Seconds added to the time.</param>
        public MotionPath(MotionKind kind, Vector3D travelM, double periodS, double phaseS)
        {
            if (kind != MotionKind.None && !(periodS > 0 && !double.IsInfinity(periodS)))
                throw new ArgumentException("a motion's period must be above zero seconds");
            Kind = kind;
            TravelM = travelM;
            PeriodS = periodS;
            PhaseS = phaseS;
        }

        public MotionKind Kind { get; }

        public Vector3D TravelM { get; }

        public double PeriodS { get; }

        public double PhaseS { get; }

        /// <summary>Displacement from rest in metres at a time in seconds on the scene's clock.</summary>
        public Vector3D OffsetAt(double timeS)
        {
            if (Kind == MotionKind.None)
                return default;
            double cycles = (timeS + PhaseS) / PeriodS;
            double part = cycles - Math.Floor(cycles);
            switch (Kind)
            {
                case MotionKind.PingPong:
                    return TravelM * (part < 0.5 ? 2 * part : 2 - 2 * part);
                case MotionKind.Sine:
                    return TravelM * Math.Sin(2 * Math.PI * part);
                default:
                    return new Vector3D(TravelM.X * Math.Cos(2 * Math.PI * part), TravelM.Y * Math.Sin(2 * Math.PI * part), 0);
            }
        }
    }
}
