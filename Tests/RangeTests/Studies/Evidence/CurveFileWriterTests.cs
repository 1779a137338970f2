using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using LaserTracking.Detection;
using LaserTracking.Host.Studies.Evidence;
using NUnit.Framework;

namespace LaserTracking.Studies.Evidence
{
    public sealed class CurveFileWriterTests
    {
        [Test]
        public void CurveFileWriter_TheCommittedCurves_GiveTheCommittedFile()
        {
            string file = Path.Combine(TestFiles.Repository, "Packages", "com.range.lasertracking", "Runtime", "Core", "Detection", "Evidence", "DotEvidenceCurves.cs");
            string committed = File.ReadAllText(file).ReplaceLineEndings("\n");
            MatchCollection curves = Regex.Matches(committed, @"new EvidenceCurve\(""(?<what>[^""]+)"", RejectionReason\.(?<reason>\w+),\s+(new\[\] \{ (?<edges>[^}]*) \}|new float\[0\]),\s+new\[\] \{ (?<values>[^}]*) \}\)");
            Assert.That(curves, Has.Count.EqualTo(Enum.GetValues<DotFeature>().Length));
            double baseLogOdds = double.Parse(Regex.Match(committed, @"Base = (-?[\d.]+);").Groups[1].Value, CultureInfo.InvariantCulture);
            var model = new BoostedCurves(baseLogOdds, curves.Select(c => Numbers(c, "edges").Select(v => (float)v).ToArray()).ToArray(), curves.Select(c => Numbers(c, "values")).ToArray());
            (string, RejectionReason)[] names = curves.Select(c => (c.Groups["what"].Value, Enum.Parse<RejectionReason>(c.Groups["reason"].Value))).ToArray();
            Assert.That(CurveFileWriter.Write(model, names), Is.EqualTo(committed));
        }

        [Test]
        public void CurveFileWriter_EqualNeighbours_AreOneStep()
        {
            var model = new BoostedCurves(-1, new[] { new[] { 1f, 2f, 3f }, new[] { 5f } }, new[] { new[] { 0.5, 0.5, -0.25, -0.25 }, new[] { -0.0001, -0.0001 } });
            string text = CurveFileWriter.Write(model, new[] { ("size", RejectionReason.TooLarge), ("nothing", RejectionReason.TooFaint) });
            Assert.That(text, Does.Contain("Base = -1.0000;"));
            Assert.That(text, Does.Contain("new EvidenceCurve(\"size\", RejectionReason.TooLarge,\n                new[] { 2f },\n                new[] { 0.5f, -0.25f }),"));
            Assert.That(text, Does.Contain("new EvidenceCurve(\"nothing\", RejectionReason.TooFaint, new float[0], new[] { 0f }),"));
            Assert.Throws<ArgumentException>(() => CurveFileWriter.Write(model, new[] { ("size", RejectionReason.TooLarge) }));
        }

        private static double[] Numbers(Match curve, string group) => curve.Groups[group].Value.Split(", ", StringSplitOptions.RemoveEmptyEntries)
            .Select(n => double.Parse(n.TrimEnd('f'), CultureInfo.InvariantCulture)).ToArray();
    }
}
