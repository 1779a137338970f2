using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    /// <summary>Collects deviations from a reference file, prints cases, worst and tolerance, and holds the worst against it.</summary>
    internal sealed class Deviation(string what)
    {
        private int _cases;
        private double _worst = double.NegativeInfinity;

        public void Add(double deviation)
        {
            _cases++;
            _worst = double.IsNaN(deviation) ? double.PositiveInfinity : Math.Max(_worst, deviation);
        }

        /// <summary>Fails over the tolerance, and when nothing was compared.</summary>
        public void AssertWithin(double tolerance, string unit)
        {
            TestContext.Out.WriteLine(FormattableString.Invariant($"{what}: {_cases} compared, worst {_worst:G3} {unit}, tolerance {tolerance:G3} {unit}"));
            Assert.That(_cases, Is.GreaterThan(0), what);
            Assert.That(_worst, Is.LessThanOrEqualTo(tolerance), what);
        }
    }
}
