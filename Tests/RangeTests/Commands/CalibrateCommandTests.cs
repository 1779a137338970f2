using System.IO;
using LaserTracking.Host;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class CalibrateCommandTests
    {
        private static readonly string[] Corners = { "150,82", "1138,104", "1110,640", "182,622" };

        private const string FourPoints = "\"image_px\":[[150,82],[1138,104],[1110,640],[182,622]],\"screen_m\":[[0,0],[3,0],[3,2],[0,2]]";

        [TestCase("3 corners given", "1,1", "2,2", "3,3")]
        [TestCase("corners 1 and 2 lie in one place", "1,1", "1,1", "1,1", "1,1")]
        [TestCase("lie on one line", "0,0", "1,1", "2,2", "3,3")]
        [TestCase("lie on one line", "0,0", "100,0", "50,50", "100,100")]
        [TestCase("the corners cross", "0,0", "100,100", "100,0", "0,100")]
        [TestCase("\"NaN,0\" is not two numbers", "NaN,0", "1,1", "2,2", "3,3")]
        [TestCase("\"1e400,0\" is not two numbers", "1e400,0", "1,1", "2,2", "3,3")]
        [TestCase("outside the image of 1280x720", "2000,0", "3000,0", "3000,900", "2000,900")]
        public void Screen_ImpossibleCorners_AreRefused(string words, params string[] corners)
        {
            using var folder = new TemporaryFolder();
            string result = folder.File("screen.json");
            CommandLine.AssertRefused(words, ["calibrate", "screen", "--size", "3.73x2.26", "--out", result, "--corners", .. corners]);
            Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
        }

        [TestCase("--size: \"0x0\"", "--size", "0x0")]
        [TestCase("--size: \"3,73x2,26\"", "--size", "3,73x2,26")]
        [TestCase("--size: \"1e-9x1\"", "--size", "1e-9x1")]
        [TestCase("--image-size: \"0x0\"", "--size", "3x2", "--image-size", "0x0")]
        [TestCase("--image-size: \"1e3x3.7\"", "--size", "3x2", "--image-size", "1e3x3.7")]
        [TestCase("--limit: \"a\"", "--size", "3x2", "--limit", "a")]
        [TestCase("--limit: must be", "--size", "3x2", "--limit", "NaN")]
        public void Screen_ImpossibleOption_IsRefused(string words, params string[] options)
        {
            using var folder = new TemporaryFolder();
            CommandLine.AssertRefused(words, ["calibrate", "screen", "--out", folder.File("screen.json"), "--corners", .. Corners, .. options]);
            Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
        }

        [TestCase("{", "not JSON at line 1")]
        [TestCase("{}", "field image_px is missing")]
        [TestCase("{\"image_px\":[[1,2],[3,NaN]],\"screen_m\":[[1,2],[3,4]]}", "field image_px, point 2")]
        [TestCase("{\"image_px\":[[1,2]],\"screen_m\":[[1,2]]}", "at least four")]
        [TestCase("{\"image_px\":[[1,2]],\"screen_m\":[[1,2],[3,4]]}", "differ in length")]
        [TestCase("{\"image_px\":[[1,2]],\"screen_m\":[[1,2]],\"image_size\":[\"a\",\"b\"]}", "field image_size")]
        [TestCase("{\"image_px\":[[1,2]],\"screen_m\":[[1,2]],\"verify\":7}", "field verify")]
        public void Screen_BrokenPoints_AreRefused(string content, string words)
        {
            using var folder = new TemporaryFolder();
            string points = folder.File("points.json");
            File.WriteAllText(points, content);
            CommandLine.AssertRefused(words, "calibrate", "screen", "--size", "3x2", "--points", points, "--out", folder.File("screen.json"));
            CommandLine.AssertRefused("this file is also read", "calibrate", "screen", "--size", "3x2", "--points", points, "--out", points);
            Assert.That(Directory.GetFiles(folder.Path), Is.EqualTo(new[] { points }));
        }

        [TestCase("\"v\":2,", "newer release (version 2")]
        [TestCase("\"v\":\"2\",", "field v is no version number")]
        [TestCase("\"image_size\":[1000,700],", "field image_px, point 2 lies at 1138,104, outside the image of 1000x700")]
        [TestCase("\"verify\":{\"image_px\":[[5,5],[-7,10]],\"screen_m\":[[0,0],[1,1]]},\"image_size\":[1280,720],", "field verify.image_px, point 2 lies at -7,10")]
        public void Screen_PointsOfNewerVersionOrOutsideTheImage_AreRefused(string fields, string words)
        {
            using var folder = new TemporaryFolder();
            string points = folder.File("points.json");
            File.WriteAllText(points, "{" + fields + FourPoints + "}");
            CommandLine.AssertRefused(words, "calibrate", "screen", "--size", "3x2", "--points", points, "--out", folder.File("screen.json"));
            Assert.That(Directory.GetFiles(folder.Path), Is.EqualTo(new[] { points }));
        }

        [Test]
        public void Screen_ResultInPlaceOfAPictureOfTheFolder_OrOfTheMap_IsRefused()
        {
            using var folder = new TemporaryFolder();
            string picture = folder.File("a-1.png");
            File.WriteAllText(picture, "kept");
            CommandLine.AssertRefused("this file is also read", "calibrate", "screen", "--size", "3x2", "--image", folder.Path, "--out", picture);
            CommandLine.AssertRefused("--map: is the name of the calibration too", "calibrate", "screen", "--size", "3x2", "--image", folder.Path, "--out", "o.json", "--map", "o.json");
            Assert.That(File.ReadAllText(picture), Is.EqualTo("kept"));
        }

        [Test]
        public void Screen_CornerOutsideTheImage_IsSaid()
        {
            using var folder = new TemporaryFolder();
            (int code, _, string error) = CommandLine.Run("calibrate", "screen", "--size", "3x2", "--out", folder.File("screen.json"), "--corners", "-50,82", "1138,104", "1110,640", "182,622");
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(error, Does.Contain("point 1 lies at -50,82, outside the image of 1280x720"));
        }

        [Test]
        public void Screen_MirroredOrder_IsRefusedUnlessTheCameraStandsBehindTheScreen()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("screen.json");
            string[] usual = ["calibrate", "screen", "--size", "3x2", "--out", file, "--corners", .. Corners], mirrored = [.. usual[..^4], Corners[1], Corners[0], Corners[3], Corners[2]];
            CommandLine.AssertRefused("the picture is mirrored", mirrored);
            CommandLine.AssertRefused("is not mirrored", [.. usual, "--mirrored"]);
            Assert.That(File.Exists(file), Is.False);
            Assert.That(CommandLine.Run([.. mirrored, "--mirrored"]).ExitCode, Is.EqualTo(ExitCodes.Done));
        }

        [Test]
        public void Screen_PointsInMillimetres_OrOfAnotherScreen_AreRefused()
        {
            using var folder = new TemporaryFolder();
            string points = folder.File("points.json"), file = folder.File("screen.json");
            File.WriteAllText(points, "{" + FourPoints.Replace("[3,0],[3,2],[0,2]", "[3000,0],[3000,2000],[0,2000]") + "}");
            CommandLine.AssertRefused("point 2 lies at 3000,0, far outside the screen of 3x2 m", "calibrate", "screen", "--size", "3x2", "--points", points, "--out", file);
            CommandLine.Run(["calibrate", "screen", "--size", "3x2", "--out", file, "--corners", .. Corners]);
            CommandLine.AssertRefused("far outside the screen", "calibrate", "verify", file, "--points", points);
        }

        [Test]
        public void Verify_PointOutsideTheImage_IsSaid_AndNoPointsAreRefused()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("screen.json"), points = folder.File("points.json");
            CommandLine.Run(["calibrate", "screen", "--size", "3x2", "--out", file, "--corners", .. Corners]);
            File.WriteAllText(points, "{\"image_px\":[[150,82],[5000,9]],\"screen_m\":[[0,0],[1,1]]}");
            (int code, _, string error) = CommandLine.Run("calibrate", "verify", file, "--points", points);
            Assert.That(code, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("point 2 lies at 5000,9, outside the image of 1280x720"));
            File.WriteAllText(points, "{\"image_px\":[],\"screen_m\":[]}");
            CommandLine.AssertRefused("holds no point", "calibrate", "verify", file, "--points", points);
        }

        [Test]
        public void Screen_UnwritableResult_IsRefusedBeforeAnythingIsPrinted()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("file");
            File.WriteAllText(file, "kept");
            CommandLine.AssertRefused("is a file, not a folder", ["calibrate", "screen", "--size", "3x2", "--out", Path.Combine(file, "screen.json"), "--corners", .. Corners]);
            CommandLine.AssertRefused("this is no name for a file", ["calibrate", "screen", "--size", "3x2", "--out", folder.Path, "--corners", .. Corners]);
            Assert.That(File.ReadAllText(file), Is.EqualTo("kept"));
            Assert.That(File.Exists(folder.Path + ".part"), Is.False);
        }

        [Test]
        public void Screen_LinkAsResult_StaysALink()
        {
            using var folder = new TemporaryFolder();
            string real = folder.File("real.json"), link = folder.File("link.json");
            File.WriteAllText(real, "old");
            File.CreateSymbolicLink(link, real);
            Assert.That(CommandLine.Run(["calibrate", "screen", "--size", "3x2", "--out", link, "--replace", "--corners", .. Corners]).ExitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(new FileInfo(link).LinkTarget, Is.EqualTo(real));
            Assert.That(File.ReadAllText(real), Does.Contain("\"kind\": \"screen\""));
        }

        [TestCase("\"screen_m\": [", "\"screen_m\": [NaN,", "screen_m must be 2 numbers")]
        [TestCase("\"kind\": \"screen\"", "\"kind\": \"stereo\"", "field kind is \"stereo\"")]
        [TestCase("\"H\": [", "\"H\": [[0,0,0],", "field H must be 3 rows")]
        public void Verify_ChangedCalibration_IsRefused(string old, string changed, string words)
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("screen.json"), points = folder.File("points.json");
            CommandLine.Run(["calibrate", "screen", "--size", "3x2", "--out", file, "--corners", .. Corners]);
            File.WriteAllText(points, "{\"image_px\":[[1,2]],\"screen_m\":[[1,2]]}");
            string text = File.ReadAllText(file);
            Assert.That(text, Does.Contain(old));
            File.WriteAllText(file, text.Replace(old, changed));
            CommandLine.AssertRefused(words, "calibrate", "verify", file, "--points", points);
        }

        [Test]
        public void Verify_ScreenThatReachesBeyondTheHorizon_IsRefused()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("screen.json"), points = folder.File("points.json");
            File.WriteAllText(points, "{\"image_px\":[[1,2]],\"screen_m\":[[1,2]]}");
            File.WriteAllText(file, "{\"v\":1,\"kind\":\"screen\",\"image_size\":[1280,720],\"screen_m\":[3,2],\"H\":[[1,0,0],[0,1,0],[1,0,-1.5]]}");
            CommandLine.AssertRefused("field H gives no screen", "calibrate", "verify", file, "--points", points);
        }
    }
}
