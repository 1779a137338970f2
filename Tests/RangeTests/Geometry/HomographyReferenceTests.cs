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
            var deviation = new Deviation("homography_4pt.json");
            foreach (JToken test in Cases("homography_4pt.json"))
            {
                Assert.That(HomographyEstimator.TryFit(Points(test["src"]!), Points(test["dst"]!), out Homography h, out string reason), Is.True, test["id"] + ": " + reason);
                Assert.That(HomographyFit.TryFit(Points(test["src"]!), Points(test["dst"]!), 1, out HomographyFit? fit, out reason), Is.True, test["id"] + ": " + reason);
                deviation.Add(Worst(h, test, "test_dst"));
                deviation.Add(Worst(fit!.Homography, test, "test_dst"));
            }

            deviation.AssertWithin(1e-6, "px");
        }

        [Test]
        public void HomographyEstimator_ManyPoints_AgreesWithTheReferenceDlt()
        {
            var deviation = new Deviation("homography_ls.json, direct linear transform");
            foreach (JToken test in Cases("homography_ls.json"))
            {
                Assert.That(HomographyEstimator.TryFit(Points(test["src"]!), Points(test["dst"]!), out Homography h, out string reason), Is.True, test["id"] + ": " + reason);
                deviation.Add(Worst(h, test, "test_dst_normalised_dlt"));
            }

            deviation.AssertWithin(1e-6, "px");
        }

        [Test]
        public void HomographyFit_ManyPoints_ReachesTheReferenceOptimum()
        {
            Deviation points = new("homography_ls.json, refined"), rms = new("homography_ls.json, RMS above the optimum");
            foreach (JToken test in Cases("homography_ls.json"))
            {
                Assert.That(HomographyFit.TryFit(Points(test["src"]!), Points(test["dst"]!), 1, out HomographyFit? fit, out string reason), Is.True, test["id"] + ": " + reason);
                points.Add(Worst(fit!.Homography, test, "test_dst_optimum"));
                rms.Add(fit.Rms - (double)test["rms_dst_px"]!["optimum"]!);
            }

            points.AssertWithin(1e-3, "px");
            rms.AssertWithin(1e-6, "px");
        }

        [Test]
        public void HomographyEstimator_DegenerateInput_IsRefusedWithAReason()
        {
            foreach (JToken test in Cases("homography_degenerate.json"))
            {
                Assert.That(HomographyEstimator.TryFit(Points(test["src"]!), Points(test["dst"]!), out _, out string reason), Is.False, (string?)test["id"]);
                Assert.That(HomographyFit.TryFit(Points(test["src"]!), Points(test["dst"]!), 1, out _, out _), Is.False, (string?)test["id"]);
                Assert.That(reason, Is.Not.Empty, (string?)test["id"]);
            }
        }

        private static IEnumerable<JToken> Cases(string file) =>
            JObject.Parse(File.ReadAllText(TestFiles.Reference("homography", file)))["cases"]!;

        private static Vector2D[] Points(JToken list) => list.Select(p => new Vector2D(Number(p[0]!), Number(p[1]!))).ToArray();

        private static double Number(JToken token) => token.Type == JTokenType.Null ? double.NaN : (double)token;

        private static double Worst(Homography h, JToken test, string expectedName)
        {
            Vector2D[] from = Points(test["test_src"]!), expected = Points(test[expectedName]!);
            return from.Select((p, i) => (h.Map(p) - expected[i]).Length).Max();
        }
    }
}
