using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>The sample calibrations in the repository are what the commands make today.</summary>
    public sealed class SampleCalibrationTests
    {
        private static string Folder => Path.Combine(TestFiles.Repository, "Calibration");

        [Test]
        public void Simulate_SampleSession_IsTheOneInTheRepository()
        {
            using var folder = new TemporaryFolder();
            string corners = folder.File("corners.json");
            CommandLine.Run("calibrate", "simulate", "--seed", "1", "--views", "20", "--noise", "0.2", "--out", corners);
            JToken[] made = Numbers(corners), kept = Numbers(Path.Combine(Folder, "corners.json"));
            Assert.That(made, Has.Length.EqualTo(kept.Length));
            for (int i = 0; i < made.Length; i++)
                Assert.That((double)made[i], Is.EqualTo((double)kept[i]).Within(0.0011));
        }

        [Test]
        public void Stereo_SampleSession_GivesTheSampleCalibration()
        {
            using var folder = new TemporaryFolder();
            string result = folder.File("stereo.json");
            Assert.That(CommandLine.Run("calibrate", "stereo", "--corners", Path.Combine(Folder, "corners.json"), "--out", result).ExitCode, Is.EqualTo(ExitCodes.Done));
            StereoRig made = StereoRigJson.ReadFile(result), kept = StereoRigJson.ReadFile(Path.Combine(Folder, "history", "2026-05-11-stereo.json"));
            Assert.That((made.LeftToRight.Position - kept.LeftToRight.Position).Length, Is.LessThan(1e-4));
            Assert.That(made.Left.Pinhole.FocalXPx, Is.EqualTo(kept.Left.Pinhole.FocalXPx).Within(1e-4));
        }

        [Test]
        public void History_OfTheRepository_NamesTheBest()
        {
            (int exitCode, string output, string error) = CommandLine.Run("calibrate", "history", Path.Combine(Folder, "history"));
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(error, Is.Empty);
            Assert.That(output, Does.Contain("best: 2026-05-11-stereo.json").And.Contain("best: 2026-05-11-camera.json"));
        }

        private static JToken[] Numbers(string path) => JObject.Parse(File.ReadAllText(path)).Descendants().Where(token => token.Type is JTokenType.Float or JTokenType.Integer).ToArray();
    }
}
