using System;
using System.Globalization;
using LaserTracking.Detection;

namespace LaserTracking.Host.Explanations
{
    /// <summary>A test as people read it: "ring: level", "0.31", "≤", "0.25".</summary>
    internal readonly record struct TestRow(bool IsPassed, bool DecidesRejection, string What, string Value, string Sign, string Limit)
    {
        public static TestRow Of(in TestOutcome test)
        {
            bool isCondition = double.IsNaN(test.Limit);
            string value = isCondition ? (test.Value > 0 ? "yes" : "no") : Number(test.Value);
            string sign = isCondition ? string.Empty : test.IsMinimum ? "≥" : "≤";
            return new TestRow(test.IsPassed, test.Reason != RejectionReason.None, test.What, value, sign, isCondition ? string.Empty : Number(test.Limit));
        }

        /// <summary>Three digits that matter are enough to see by how much.</summary>
        private static string Number(double value)
        {
            double size = Math.Abs(value);
            return value.ToString(size >= 100 ? "0" : size >= 10 ? "0.#" : size >= 1 ? "0.##" : "0.###", CultureInfo.InvariantCulture);
        }
    }
}
