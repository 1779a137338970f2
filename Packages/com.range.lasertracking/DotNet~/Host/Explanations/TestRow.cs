using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using LaserTracking.Detection;

namespace LaserTracking.Host.Explanations
{
    /// <summary>
    /// A test as people read it: "ok", "ring: level", "0.31", "≤", "0.25"; or evidence: "+0.27", "rise through noise, logarithm", "4.39".
    /// </summary>
    internal readonly record struct TestRow(TestSection Section, bool IsPassed, string Mark, string What, string Value, string Sign, string Limit)
    {
        public static TestRow Of(in TestOutcome test)
        {
            if (test.IsEvidence)
                return OfEvidence(test);
            bool isCondition = double.IsNaN(test.Limit);
            string value = isCondition ? (test.Value > 0 ? "yes" : "no") : Number(test.Value);
            string sign = isCondition ? string.Empty : test.IsMinimum ? "≥" : "≤";
            TestSection section = test.Reason != RejectionReason.None ? TestSection.Tests : TestSection.OneFrame;
            return new TestRow(section, test.IsPassed, test.IsPassed ? "ok" : "FAIL", test.What, value, sign, isCondition ? string.Empty : Number(test.Limit));
        }

        /// <summary>In order; each section's rows stand together.</summary>
        public static IReadOnlyList<TestRow> Of(IReadOnlyList<TestOutcome> tests) => tests.Select(t => Of(t)).ToArray();

        /// <summary>The line above a section's first row; null: none.</summary>
        public static string? Heading(TestSection section) => section switch
        {
            TestSection.Evidence => "for or against a laser dot, log-odds",
            TestSection.OneFrame => "does this frame alone suffice?",
            _ => null,
        };

        /// <summary>Three digits that matter are enough to see by how much.</summary>
        public static string Number(double value)
        {
            double size = Math.Abs(value);
            return value.ToString(size >= 100 ? "0" : size >= 10 ? "0.#" : size >= 1 ? "0.##" : "0.###", CultureInfo.InvariantCulture);
        }

        private static TestRow OfEvidence(in TestOutcome test)
        {
            string says = test.LogOdds.ToString("+0.00;-0.00;+0.00", CultureInfo.InvariantCulture);
            bool isSum = !double.IsNaN(test.Limit);

            // The sum and what it began with are log-odds themselves.
            string value = test.Reason == RejectionReason.None ? string.Empty : Number(test.Value);
            return new TestRow(TestSection.Evidence, test.IsPassed, says, test.What, value, isSum ? "≥" : string.Empty, isSum ? Number(test.Limit) : string.Empty);
        }
    }
}
