using System;
using System.IO;
using System.Linq;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;
using LaserTracking.Host;
using LaserTracking.Host.HandModels;
using LaserTracking.Imaging;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>range hands and range models, with the models' folder somewhere else.</summary>
    [NonParallelizable]
    public sealed class HandModelCommandTests
    {
        private const string FolderVariable = "RANGE_MODELS";

        private TemporaryFolder _folder = null!;
        private string? _before;

        [SetUp]
        public void SetUp()
        {
            _folder = new TemporaryFolder();
            _before = Environment.GetEnvironmentVariable(FolderVariable);
            Environment.SetEnvironmentVariable(FolderVariable, _folder.Path);
        }

        [TearDown]
        public void TearDown()
        {
            Environment.SetEnvironmentVariable(FolderVariable, _before);
            _folder.Dispose();
        }

        [Test]
        public void Hands_NoModel_IsRefusedWithTheCommandThatFetchesIt() =>
            Assert.That(CommandLine.AssertRefused("hand_landmark_lite.tflite: ", "hands", "a.png"), Does.Contain("./range models"));

        [Test]
        public void Hands_ModelCutShort_IsRefused()
        {
            File.WriteAllBytes(HandModelStore.PathOf(HandModelFile.Full), new byte[1000]);
            CommandLine.AssertRefused("has 1000 bytes", "hands", "a.png", "--model", "full");
        }

        [Test]
        public void Hands_OtherFileOfTheSameSize_IsRefused()
        {
            File.WriteAllBytes(HandModelStore.PathOf(HandModelFile.Lite), new byte[HandModelFile.Lite.SizeBytes]);
            CommandLine.AssertRefused("is not the lite hand model", "hands", "a.png");
        }

        [TestCase("1,2,3", "is not CX,CY,SIDE,ROTATION_RAD")]
        [TestCase("1,2,3,x", "ROTATION_RAD")]
        [TestCase("1,2,0,0", "not above 0")]
        [TestCase("NaN,2,9,0", "CX")]
        [TestCase("1,2,1e300,0", "SIDE")]
        public void Hands_RegionThatIsNone_IsRefused(string roi, string words) => CommandLine.AssertRefused(words, "hands", "a.png", "--roi", roi);

        [Test]
        public void Hands_UnknownModel_IsRefused() => CommandLine.AssertRefused("known are lite, full", "hands", "a.png", "--model", "huge");

        [Test]
        public void Models_List_FetchesNothingAndSaysWhatIsMissing()
        {
            (int exitCode, string output, string error) = CommandLine.Run("models", "--list");
            Assert.That(exitCode, Is.Zero, error);
            Assert.That(output, Does.Contain("missing").And.Contain(HandModelFile.Lite.Sha256).And.Contain(HandModelFile.Full.Sha256).And.Contain("Apache-2.0"));
            Assert.That(Directory.GetFileSystemEntries(_folder.Path), Is.Empty);
        }

        [Test]
        public void TryOpen_NoModel_SaysInOneLineThatDepthAloneIsUsed()
        {
            TextWriter error = Console.Error;
            using var lines = new StringWriter();
            Console.SetError(lines);
            try
            {
                Assert.That(HandModelStore.TryOpen("lite", out string problem), Is.Null);
                Assert.That(lines.ToString().TrimEnd(), Is.EqualTo("range: " + problem).And.EndsWith("hands are found by depth alone"));
                Assert.That(HandModelStore.TryOpen(null, out problem), Is.Null);
                Assert.That(problem, Is.Empty);
            }
            finally
            {
                Console.SetError(error);
            }
        }

        [Test]
        public void Replay_HandModelWithoutASecondCamera_IsRefused()
        {
            string input = _folder.File("a.mp4");
            File.WriteAllBytes(input, new byte[10]);
            CommandLine.AssertRefused("add --hand FILE", "replay", input, "--hand-model", "lite");
        }

        [Test]
        [Category("Reference")]
        public void Hands_DrawnHand_PrintsWhatTheOriginalRuntimeAnswersAndWhereToLookNext()
        {
            Environment.SetEnvironmentVariable(FolderVariable, _before);
            HandModelForTests.Open("lite").Dispose();
            if (Prerequisites.Locate("ffmpeg") == null)
                Assert.Ignore("ffmpeg is not installed");
            JObject input = HandModelPictures.All(TestFiles.Reference("hands", "inputs.json")).First(item => (string?)item["id"] == "hand_open");
            JToken expected = JObject.Parse(File.ReadAllText(TestFiles.Reference("hands", "reference_lite.json")))["results"]!.First(result => (string?)result["id"] == "hand_open");
            string file = _folder.File("hand.ppm");
            using (Image picture = HandModelPictures.Draw(input))
                WritePpm(picture, file);
            JObject first = Run(file, "112,112,224,0");
            Assert.That((double)first["presence"]!, Is.EqualTo((double)expected["presence"]!).Within(1e-5));
            Assert.That((double)first["handedness"]!, Is.EqualTo((double)expected["handedness"]!).Within(3e-5));
            for (int i = 0; i < HandLandmarks.Count; i++)
                Assert.That((double)first["landmarks_px"]![i]![0]!, Is.EqualTo((double)expected["landmarks"]![3 * i]!).Within(2e-3));
            JToken next = first["next_roi"]!;
            JObject second = Run(file, FormattableString.Invariant($"{(double)next["cx"]!:R},{(double)next["cy"]!:R},{(double)next["side"]!:R},{(double)next["rotation_rad"]!:R}"));
            for (int i = 0; i < HandLandmarks.Count; i++)
                Assert.That((double)second["landmarks_px"]![i]![1]!, Is.EqualTo((double)expected["second_pass"]!["picture_px"]![3 * i + 1]!).Within(5e-3));
        }

        private static JObject Run(string file, string roi)
        {
            (int exitCode, string output, string error) = CommandLine.Run("hands", file, "--roi", roi);
            Assert.That(exitCode, Is.Zero, error);
            return JObject.Parse(output);
        }

        private static void WritePpm(Image picture, string path)
        {
            using FileStream file = File.Create(path);
            file.Write(System.Text.Encoding.ASCII.GetBytes(FormattableString.Invariant($"P6\n{picture.Width} {picture.Height}\n255\n")));
            for (int i = 0; i < picture.Width * picture.Height; i++)
                file.Write(new[] { picture.Bytes[4 * i + 2], picture.Bytes[4 * i + 1], picture.Bytes[4 * i] });
        }
    }
}
