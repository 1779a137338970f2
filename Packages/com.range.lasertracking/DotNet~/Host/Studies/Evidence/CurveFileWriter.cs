using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using LaserTracking.Detection;

namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>Writes curves as the C# file that the detector is built with.</summary>
    internal static class CurveFileWriter
    {
        /// <param name="curves">What was learned.</param>
        /// <param name="names">What each feature is called and is a reason for.</param>
        public static string Write(BoostedCurves curves, IReadOnlyList<(string What, RejectionReason Reason)> names)
        {
            if (names.Count != curves.Edges.Length)
                throw new ArgumentException("every curve needs a name", nameof(names));
            var text = new StringBuilder();
            text.Append("""
                namespace LaserTracking.Detection
                {
                    /// <summary>
                    /// The curves of <see cref="DotEvidence"/>, in the order of <see cref="DotFeature"/>. Written by the training that
                    /// Documentation~/detector.md describes; not to be edited by hand.
                    /// </summary>
                    internal static class DotEvidenceCurves
                    {
                        /// <summary>Log-odds before anything is measured: candidates are many, dots are few.</summary>
                        public const double Base =
                """.ReplaceLineEndings("\n"));
            text.Append(CultureInfo.InvariantCulture, $" {curves.Base:F4};\n\n        public static readonly EvidenceCurve[] All =\n        {{\n");
            for (int feature = 0; feature < names.Count; feature++)
                Append(text, names[feature].What, names[feature].Reason, curves.Edges[feature], curves.Values[feature]);
            return text.Append("        };\n    }\n}\n").ToString();
        }

        private static void Append(StringBuilder text, string what, RejectionReason reason, float[] edges, double[] values)
        {
            string head = $"            new EvidenceCurve(\"{what}\", RejectionReason.{reason},", levels = string.Join(", ", values.Select(Value));
            text.Append(head).Append(edges.Length == 0
                ? $" new float[0], new[] {{ {levels} }}),\n"
                : $"\n                new[] {{ {string.Join(", ", edges.Select(Edge))} }},\n                new[] {{ {levels} }}),\n");
        }

        private static string Edge(float edge) => edge.ToString("G4", CultureInfo.InvariantCulture).Replace('E', 'e') + "f";

        private static string Value(double value)
        {
            double rounded = Math.Round(value, 3);
            return (rounded == 0 ? 0 : rounded).ToString("0.###", CultureInfo.InvariantCulture) + "f";
        }
    }
}
