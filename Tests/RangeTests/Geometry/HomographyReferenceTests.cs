using System.Collections.Generic;
using System.IO;
using System.Linq;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    [Category("Reference")]
    public sealed class HomographyReferenceTests
    {
        [Test]
        public void HomographyEstimator_FourPoints_AgreesWithTheReference()
        {
            foreach (JToken test in Cases("homography_4pt.json"))
            {
                Assert.That(HomographyEstimator.TryFit(Points(test["src"]!), Points(test["dst"]!), out Homography h, out string reason), Is.True, test["id"] + ": " + reason);
                AssertMaps(h, test, "test_dst", 1e-6);
            }
        }

        [Test]
        public void HomographyEstimator_ManyPoints_AgreesWithTheReferenceDlt()
        {
            foreach (JToken test in Cases("homography_ls.json"))
            {
                Assert.That(HomographyEstimator.TryFit(Points(test["src"]!), Points(test["dst"]!), out Homography h, out string reason), Is.True, test["id"] + ": " + reason);
                AssertMaps(h, test, "test_dst_normalised_dlt", 1e-6);
            }
        }

        [Test]
        public void HomographyEstimator_DegenerateInput_IsRefusedWithAReason()
        {
            foreach (JToken test in Cases("homography_degenerate.json"))
            {
                Assert.That(HomographyEstimator.TryFit(Points(test["src"]!), Points(test["dst"]!), out _, out string reason), Is.False, (string?)test["id"]);
                Assert.That(reason, Is.Not.Empty, (string?)test["id"]);
            }
        }

        private static IEnumerable<JToken> Cases(string file) =>
            JObject.Parse(File.ReadAllText(TestFiles.Reference("homography", file)))["cases"]!;

        private static Vector2D[] Points(JToken list) => list.Select(p => new Vector2D(Number(p[0]!), Number(p[1]!))).ToArray();

        private static double Number(JToken token) => token.Type == JTokenType.Null ? double.NaN : (double)token;

        private static void AssertMaps(Homography h, JToken test, string expectedName, double tolerancePx)
        {
            Vector2D[] from = Points(test["test_src"]!), expected = Points(test[expectedName]!);
            for (int i = 0; i < from.Length; i++)
                Assert.That((h.Map(from[i]) - expected[i]).Length, Is.LessThanOrEqualTo(tolerancePx), test["id"] + " point " + i);
        }
    }
}
