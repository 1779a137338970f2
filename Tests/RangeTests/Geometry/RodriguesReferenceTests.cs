using System;
using System.IO;
using System.Linq;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    [Category("Reference")]
    public sealed class RodriguesReferenceTests
    {
        private const double Tolerance = 1e-12;

        // Where the reference's own way back from the matrix lost digits (near no turn and near half a turn).
        private const double OwnBackTolerance = 1e-7;

        [Test]
        public void Rodrigues_VectorsAndMatrices_AgreeWithTheReference()
        {
            double worst = 0, worstBack = 0, worstOwnBack = 0;
            int cases = 0;
            foreach (JToken test in JObject.Parse(File.ReadAllText(TestFiles.Reference("camera_models", "rodrigues.json")))["cases"]!)
            {
                double[] expected = test["R"]!.SelectMany(row => row).Select(v => (double)v).ToArray(), matrix = new double[9];
                Rodrigues.ToMatrix(Vector(test["rvec"]!), matrix);
                worst = Math.Max(worst, matrix.Zip(expected, (a, b) => Math.Abs(a - b)).Max());

                Assert.That(Rotation3D.TryFromMatrix(expected, out Rotation3D rotation), Is.True);
                worst = Math.Max(worst, rotation.ToMatrix().Zip(expected, (a, b) => Math.Abs(a - b)).Max());
                worstBack = Math.Max(worstBack, Apart(rotation.ToVector(), Vector(test["rvec"]!)));
                worstOwnBack = Math.Max(worstOwnBack, Apart(rotation.ToVector(), Vector(test["rvec_back"]!)));
                cases++;
            }

            TestContext.Out.WriteLine(FormattableString.Invariant($"rodrigues.json: {cases} cases, worst {worst:G2} (matrix), {worstBack:G2} rad (vector), {worstOwnBack:G2} rad (vector from the reference's way back)"));
            Assert.That(worst, Is.LessThanOrEqualTo(Tolerance));
            Assert.That(worstBack, Is.LessThanOrEqualTo(Tolerance));
            Assert.That(worstOwnBack, Is.LessThanOrEqualTo(OwnBackTolerance));
        }

        /// <summary>Vectors that differ by a whole turn about their axis are one rotation.</summary>
        private static double Apart(Vector3D a, Vector3D b)
        {
            Vector3D turn = b.Normalized * (2 * Math.PI);
            return Math.Min((a - b).Length, Math.Min((a - b + turn).Length, (a - b - turn).Length));
        }

        private static Vector3D Vector(JToken v) => new((double)v[0]!, (double)v[1]!, (double)v[2]!);
    }
}
