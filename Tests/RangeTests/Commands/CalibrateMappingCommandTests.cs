using System.IO;
using LaserTracking.Host;
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
