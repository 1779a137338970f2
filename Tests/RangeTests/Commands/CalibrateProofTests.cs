using System;
using System.Globalization;
using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>Points measured by hand: what proves them, and what is said when nothing does.</summary>
    public sealed class CalibrateProofTests
    {
        private static readonly string[] Corners = { "150,82", "1138,104", "1110,640", "182,622" };

        [Test]
        public void Points_WithoutCheckPoints_AreProvenByEachOther()
        {
            using var folder = new TemporaryFolder();
            (int code, JObject printed, string error) = Calibrate(folder, Grid(4, 3), 0.2);
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(((string?)printed["proof"], (int)printed["verify"]!["n"]!, ((JArray)printed["regions"]!).Count), Is.EqualTo(("cross-validation", 12, 9)));
            Assert.That((double)printed["verify"]!["max_px"]!, Is.GreaterThan((double)printed["rms_px"]!));
            Assert.That(error, Does.Contain("leaving each of the 12 points out in turn"));
            Assert.That((string?)JObject.Parse(File.ReadAllText(folder.File("screen.json")))["proof"], Is.EqualTo("cross-validation"));
            Assert.That(RangeCalibrationFile.Read(folder.File("screen.json")).IsUnverified, Is.False);
        }

        [Test]
        public void Points_OneOfThemWrong_AreRefusedWithPartAndPoint()
        {
            using var folder = new TemporaryFolder();
            (int code, _, string error) = Calibrate(folder, Grid(4, 3), 0.2, shift: (2, new Vector2D(0, 25)));
            Assert.That(code, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("top right: the held-out error reaches").And.Contain("point 3 alone does not fit the others").And.Contain("nothing was written"));
            Assert.That(File.Exists(folder.File("screen.json")), Is.False);
        }

        [Test]
        public void Points_OfALensThatIsNotGiven_AreRefusedAndSaySo()
        {
            using var folder = new TemporaryFolder();
            var barrel = new LensCamera(new PinholeCamera(1280, 1280, 639.5, 359.5, 1280, 720), new BrownDistortion(new[] { -0.25, 0.05, 0 }, 0, 0));
            (int code, _, string error) = Calibrate(folder, Grid(5, 4), 0.2, lens: barrel);
            Assert.That(code, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("lens bends the picture: give it with --camera"));
        }

        [Test]
        public void Points_Scattered_AreRefused()
        {
            using var folder = new TemporaryFolder();
            (int code, _, string error) = Calibrate(folder, Grid(4, 3), 12);
            Assert.That(code, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("over the limit of 5 mm: the points scatter"));
        }

        [TestCase(4)]
        [TestCase(5)]
        public void Points_TooFewToCheckEachOther_AreWrittenAsUnverified(int count)
        {
            using var folder = new TemporaryFolder();
            (int code, JObject printed, string error) = Calibrate(folder, new[] { new Vector2D(0, 0), new Vector2D(3, 0), new Vector2D(3, 2), new Vector2D(0, 2), new Vector2D(1.4, 0.9) }[..count], 0);
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(error, Does.Contain("UNVERIFIED"));
            Assert.That((string?)printed["proof"], Is.EqualTo("none"));
            Assert.That(RangeCalibrationFile.Read(folder.File("screen.json")).IsUnverified, Is.True);
        }

        [Test]
        public void Points_OfWhichOneAloneHoldsTheFit_AreUnverified()
        {
            using var folder = new TemporaryFolder();
            Vector2D[] places = { new Vector2D(0, 1), new Vector2D(0.7, 1), new Vector2D(1.5, 1), new Vector2D(2.2, 1), new Vector2D(3, 1), new Vector2D(0, 2), new Vector2D(3, 2) };
            (int code, _, string error) = Calibrate(folder, places, 0);
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(error, Does.Contain("UNVERIFIED: without one of the points"));
        }

        [Test]
        public void Verify_OfFourCorners_DemandsCheckShotsThatAreNotTheCorners()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("screen.json"), points = folder.File("points.json");
            Assert.That(CommandLine.Run(["calibrate", "screen", "--size", "3x2", "--out", file, "--corners", .. Corners]).ExitCode, Is.EqualTo(ExitCodes.Done));
            CommandLine.AssertRefused("this calibration is unverified", "calibrate", "verify", file);
            File.WriteAllText(points, "{\"image_px\":[[150,82],[1138,104],[1110,640],[182,622]],\"screen_m\":[[0,0],[3,0],[3,2],[0,2]]}");
            CommandLine.AssertRefused("the points that the calibration was fitted to", "calibrate", "verify", file, "--points", points);
            ScreenGeometry screen = RangeCalibrationFile.Read(file).Screen;
            Vector2D[] places = { new(1.5, 1), new(0.3, 1.8), new(2.8, 0.2), new(2.7, 1.7) };
            Vector2D[] shots = places.Select(place => screen.ToImagePx(place) + new Vector2D(0.4, 0)).ToArray();
            for (int few = 1; few < 4; few++)
            {
                File.WriteAllText(points, Json(shots[..few], places[..few]));
                (int failed, _, string said) = CommandLine.Run("calibrate", "verify", file, "--points", points);
                Assert.That((failed, said), Is.EqualTo((ExitCodes.CheckFailed, said)), "a few shots prove a few places only");
                Assert.That(said, Does.Contain("fire at least 4 check shots in 4 parts"));
            }

            File.WriteAllText(points, Json(shots, places));
            (int code, string output, string error) = CommandLine.Run("calibrate", "verify", file, "--points", points);
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            Assert.That((double)JObject.Parse(output)["verify"]!["max_mm"]!, Is.InRange(0.5, 3));
            Assert.That(error, Does.Contain("nothing is proven in these parts of the screen: top left"));
        }

        [TestCase("[[1,2],[3,4]]", "but a list and not one object")]
        [TestCase("7", "but a single value")]
        [TestCase("{} {}", "not JSON at line 1")]
        public void Points_JsonOfAnotherShape_AreCalledWhatTheyAre(string content, string words)
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("points.json"), content);
            CommandLine.AssertRefused(words, "calibrate", "screen", "--size", "3x2", "--points", folder.File("points.json"), "--out", folder.File("screen.json"));
        }

        [TestCase("some.jpg")]
        [TestCase("some.png")]
        public void Image_ThatIsAText_IsCalledOne(string name)
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File(name), "no picture at all\n");
            CommandLine.AssertRefused("this is a text, not a picture", "calibrate", "screen", "--size", "3x2", "--image", folder.File(name), "--out", folder.File("screen.json"));
        }

        private static Vector2D[] Grid(int columns, int rows) =>
            Enumerable.Range(0, columns * rows).Select(i => new Vector2D((0.1 + 0.8 * (i % columns) / (columns - 1)) * 3, (0.1 + 0.8 * (i / columns) / (rows - 1)) * 2)).ToArray();

        private static (int Code, JObject Printed, string Error) Calibrate(TemporaryFolder folder, Vector2D[] placesM, double noisePx, (int Index, Vector2D Px)? shift = null, LensCamera? lens = null)
        {
            var random = new Random(4);
            Assert.That(HomographyEstimator.TryFit(ScreenGeometry.CornersOf(new Vector2D(3, 2)), new[] { new Vector2D(150, 82), new Vector2D(1138, 104), new Vector2D(1110, 640), new Vector2D(182, 622) }, out Homography toImage, out _), Is.True);
            Vector2D[] px = placesM.Select(place =>
            {
                Vector2D at = toImage.Map(place);
                lens?.TryDistort(at, out at);
                return at + new Vector2D(random.NextDouble() - 0.5, random.NextDouble() - 0.5) * (2 * noisePx);
            }).ToArray();
            if (shift is { } wrong)
                px[wrong.Index] += wrong.Px;
            string points = folder.File("points.json");
            File.WriteAllText(points, Json(px, placesM));
            (int code, string output, string error) = CommandLine.Run("calibrate", "screen", "--size", "3x2", "--points", points, "--out", folder.File("screen.json"));
            return (code, JObject.Parse(output), error);
        }

        private static string Json(Vector2D[] px, Vector2D[] m)
        {
            string List(Vector2D[] points) => "[" + string.Join(",", points.Select(p => string.Format(CultureInfo.InvariantCulture, "[{0:R},{1:R}]", p.X, p.Y))) + "]";
            return "{\"image_px\":" + List(px) + ",\"screen_m\":" + List(m) + "}";
        }
    }
}
