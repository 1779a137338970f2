using System;
using System.IO;
using LaserTracking.Host;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>The command on real pictures and their stored corners, beside OpenCV's calibration of the same pairs.</summary>
    [Category("Reference")]
    public sealed class CalibrateStereoReferenceTests
    {
        [Test]
        public void Stereo_RealPictures_AreFittedAsWellAsTheReference()
        {
            JObject found = Calibrate("--left", Data("left*.jpg"), "--right", Data("right*.jpg"));
            double reference = Reference();
            TestContext.Out.WriteLine(FormattableString.Invariant($"from pictures: rms {(double)found["rms_px"]!:F4} px, reference {reference:F4} px, held out {(double)found["held_out"]!["rms_px"]!:F4} px"));
            Assert.That(found["per_view_rms_px"]!, Has.Count.EqualTo(13));
            Assert.That((double)found["rms_px"]!, Is.LessThanOrEqualTo(1.05 * reference));
            Assert.That((double)found["T"]![0]!, Is.EqualTo(-3.328).Within(0.01));
        }

        [Test]
        public void Stereo_StoredCorners_HaveTheErrorOfTheReference()
        {
            JObject found = Calibrate("--corners", Data("corners_win5.json"));
            Assert.That((double)found["rms_px"]!, Is.EqualTo(Reference()).Within(1e-3));
            Assert.That(found["left"]!["image_size"]!.ToString(Newtonsoft.Json.Formatting.None), Is.EqualTo("[640,480]"));
        }

        [Test]
        public void Board_WrongSize_SaysWhatWasFound() =>
            CommandLine.AssertRefused("9×6 corners found, 8×6 asked for", "calibrate", "board", "--images", Data("left*.jpg"), "--board", "8x6");

        private static string Data(string name) => Path.Combine(TestFiles.Reference("stereo", "opencv_9x6"), name);

        private static double Reference() => (double)JObject.Parse(File.ReadAllText(Data("reference_win5.json")))["stereo"]!["brown5"]!["fix_intrinsic"]!["rms"]!;

        private static JObject Calibrate(params string[] input)
        {
            using var folder = new TemporaryFolder();
            string result = folder.File("stereo.json");
            (int exitCode, _, string error) = CommandLine.Run(["calibrate", "stereo", .. input, "--board", "9x6", "--square", "1", "--out", result]);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done), error);
            return JObject.Parse(File.ReadAllText(result));
        }
    }
}
