using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host;
using LaserTracking.Host.Sources;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class CalibrateMappingCommandTests
    {
        [Test]
        [Category("Reference")]
        public void Mapping_RealPair_IsProvenWithinHalfAPixel()
        {
            using var folder = new TemporaryFolder();
            string corners = TestFiles.Reference("stereo", "azure_kinect_charuco", "reference.json"), file = folder.File("mapping.json");
            (int code, string output, string error) = CommandLine.Run("calibrate", "mapping", "--corners", corners, "--out", file);
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            JObject printed = JObject.Parse(output);
            Assert.That((double)printed["held_out"]!["rms_px_1920"]!, Is.LessThanOrEqualTo(0.5));
            Assert.That((double)printed["lenses_ignored_rms_px_1920"]!, Is.GreaterThan(5));
            Assert.That((string?)JObject.Parse(File.ReadAllText(file))["kind"], Is.EqualTo("mapping"));
            (code, _, error) = CommandLine.Run("calibrate", "mapping", "--corners", corners, "--out", folder.File("other.json"), "--limit", "0.1");
            Assert.That(code, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("over the limit of 0.1 px"));
            Assert.That(File.Exists(folder.File("other.json")), Is.False);
        }

        [Test]
        public void Mapping_ReadAgain_MapsAsItWasFitted()
        {
            using var folder = new TemporaryFolder();
            string file = Write(folder, out InfraredMapping fitted);
            InfraredMapping read = InfraredMappings.Read(file);
            for (int i = 0; i < 5; i++)
            {
                var px = new Vector2D(100 + (80 * i), 80 + (70 * i));
                Assert.That(fitted.TryMap(px, out Vector2D expected) && read.TryMap(px, out Vector2D found) && (found - expected).Length < 1e-6, "one place");
            }

            Assert.That(read.IsFor(512, 512, 1280, 720) && !read.IsFor(640, 576, 1280, 720));
            string text = File.ReadAllText(file);
            foreach ((string from, string to, string words) in new[] { ("\"v\": 1", "\"v\": 9", "newer release"), ("\"kind\": \"mapping\"", "\"kind\": \"screen\"", "field kind"), ("H_rays", "H", "H_rays"), ("\"color\"", "\"colour\"", "color") })
            {
                File.WriteAllText(folder.File("broken.json"), text.Replace(from, to));
                Assert.That(() => InfraredMappings.Read(folder.File("broken.json")), Throws.TypeOf<InputException>().With.Message.Contains(words), from);
            }

            CommandLine.AssertRefused("only the detector dual", "replay", folder.File("recording.mkv"), "--mapping", file);
        }

        [Test]
        public void Mapping_InfraredLargerThanColour_AsksWhetherTheyAreExchanged()
        {
            using var folder = new TemporaryFolder();
            Write(folder, out _);
            JObject corners = JObject.Parse(File.ReadAllText(folder.File("corners.json")));
            (corners["infrared"], corners["color"]) = (corners["color"]!.DeepClone(), corners["infrared"]!.DeepClone());
            File.WriteAllText(folder.File("corners.json"), corners.ToString());
            (int code, _, string error) = CommandLine.Run("calibrate", "mapping", "--corners", folder.File("corners.json"), "--out", folder.File("other.json"), "--limit", "5");
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(error, Does.Contain("infrared is the larger picture (1280x720, color 512x512): are the two exchanged?"));
        }

        [TestCase("mirrored", "infrared picture is mirrored")]
        [TestCase("outside", "field infrared.px, point 3 lies at -7,90, outside the image of 512x512")]
        [TestCase("id", "field infrared.ids, element 2, is no whole number")]
        [TestCase("order", "the points cross")]
        public void Mapping_ImpossiblePoints_AreRefused(string what, string words)
        {
            using var folder = new TemporaryFolder();
            Write(folder, out _);
            JObject corners = JObject.Parse(File.ReadAllText(folder.File("corners.json"))), infrared = (JObject)corners["infrared"]!;
            var px = (JArray)infrared["px"]!;
            if (what == "mirrored")
                infrared["px"] = new JArray(px.Select(point => new JArray(511 - (double)point[0]!, (double)point[1]!)));
            else if (what == "order")
                infrared["px"] = new JArray(px.Skip(11).Concat(px.Take(11).Reverse()));
            else if (what == "outside")
                px[2] = new JArray(-7, 90);
            else
                infrared["ids"] = new JArray(Enumerable.Range(0, 30).Select(i => i == 1 ? 99999999999999L : i));
            File.WriteAllText(folder.File("corners.json"), corners.ToString());
            CommandLine.AssertRefused(words, "calibrate", "mapping", "--corners", folder.File("corners.json"), "--out", folder.File("other.json"));
            Assert.That(File.Exists(folder.File("other.json")), Is.False);
        }

        /// <summary>A file of 'calibrate mapping' for two made-up cameras.</summary>
        private static string Write(TemporaryFolder folder, out InfraredMapping fitted)
        {
            var infrared = new LensCamera(new PinholeCamera(250, 250, 256, 255, 512, 512), BrownDistortion.None);
            var color = new LensCamera(new PinholeCamera(610, 611, 640, 361, 1280, 720), BrownDistortion.None);
            fitted = InfraredMapping.OfCameras(infrared, color, new Pose(new Vector3D(-32, -2, 4), Rotation3D.Identity), 2600);
            var corners = new JObject { ["infrared"] = LensCameraJson.Format(infrared), ["color"] = LensCameraJson.Format(color) };
            JArray from = new(), to = new();
            for (int i = 0; i < 30; i++)
            {
                var px = new Vector2D(130 + (45 * (i % 6)), 140 + (55 * (i / 6)));
                Assert.That(fitted.TryMap(px, out Vector2D at));
                from.Add(new JArray(px.X, px.Y));
                to.Add(new JArray(at.X, at.Y));
            }

            corners["infrared"]!["px"] = from;
            corners["color"]!["px"] = to;
            File.WriteAllText(folder.File("corners.json"), corners.ToString());
            string file = folder.File("mapping.json");
            (int code, _, string error) = CommandLine.Run("calibrate", "mapping", "--corners", folder.File("corners.json"), "--out", file);
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            return file;
        }

        [TestCase("{}", "field infrared is missing")]
        [TestCase("[]", "but a list")]
        [TestCase("{\"ir\":{\"px\":[[1,2]]}}", "infrared.image_size")]
        [TestCase("{\"v\":2}", "newer release")]
        public void Mapping_BrokenFile_IsRefused(string content, string words)
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("corners.json"), content);
            CommandLine.AssertRefused(words, "calibrate", "mapping", "--corners", folder.File("corners.json"), "--out", folder.File("mapping.json"));
        }
    }
}
