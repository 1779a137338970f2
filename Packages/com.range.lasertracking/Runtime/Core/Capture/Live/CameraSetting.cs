using System;
using System.Globalization;

namespace LaserTracking.Capture.Live
{
    /// <summary>One property of a camera that is to be locked at a value. Immutable.</summary>
    public sealed class CameraSetting
    {
        /// <param name="id">The vendor's number of the property.</param>
        /// <param name="name">For people: "exposure".</param>
        /// <param name="unit">For people: "µs"; may be empty.</param>
        /// <param name="asked">Wanted, in that unit.</param>
        /// <param name="tolerance">A value this near to the asked one is as good.</param>
        /// <param name="nearest">Next to the asked one that the camera has, where it has steps; as good as asked.</param>
        /// <param name="remedy">What to do when the camera will not: without a full stop.</param>
        public CameraSetting(int id, string name, string unit, double asked, double tolerance, double? nearest, string remedy)
        {
            Id = id;
            Name = name;
            Unit = unit;
            Asked = asked;
            Tolerance = tolerance;
            Nearest = nearest ?? asked;
            Remedy = remedy;
        }

        public int Id { get; }

        public string Name { get; }

        public string Unit { get; }

        public double Asked { get; }

        public double Tolerance { get; }

        public double Nearest { get; }

        public string Remedy { get; }

        /// <summary>Whether a value that the camera has is the one that was asked for, as well as it can be.</summary>
        public bool IsMetBy(double value) => Math.Abs(value - Asked) <= Tolerance || Math.Abs(value - Nearest) <= Tolerance;

        /// <summary>"2500 µs".</summary>
        public string Text(double value) => value.ToString("0.##", CultureInfo.InvariantCulture) + (Unit.Length == 0 ? "" : " " + Unit);
    }
}
