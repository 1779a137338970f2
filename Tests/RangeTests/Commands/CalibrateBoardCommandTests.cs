using System;
using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host;
using LaserTracking.Imaging;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class CalibrateBoardCommandTests
    {
        [Test]
        public void Stereo_SimulatedCorners_WritesAFileThatReadsBack()
        {
            using var folder = new TemporaryFolder();
            string corners = Simulate(folder), result = folder.File("stereo.json"), pictures = folder.File("pictures");
            (int exitCode, string output, string error) = CommandLine.Run("calibrate", "stereo", "--corners", corners, "--out", result, "--pictures", pictures);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(error, Is.Empty);
            JObject root = JObject.Parse(File.ReadAllText(result));
            StereoRig rig = StereoRigJson.ReadFile(result);
            Assert.That(rig.LeftToRight.Position.Length, Is.EqualTo((double)root["baseline"]!).Within(1e-9));
            Assert.That((double)root["triangulation"]!["edge_ratio_mean"]!, Is.EqualTo(1).Within(1e-3));
            Assert.That(root["dist"] ?? root["left"]!["dist"]!, Has.Count.EqualTo(8));
            Assert.That(root["per_view_rms_px"]!, Has.Count.EqualTo(8));
            Assert.That((double)root["held_out"]!["rms_px"]!, Is.GreaterThan((double)root["rms_px"]!).And.LessThan(0.5));
            Assert.That((string?)root["board"]!["inner_corners"]!.ToString(Newtonsoft.Json.Formatting.None), Is.EqualTo("[8,6]"));
            Assert.That(JObject.Parse(output)["kind"]!.ToString(), Is.EqualTo("stereo"));
            Assert.That(Directory.GetFiles(pictures), Has.Length.EqualTo(16));
        }

        [Test]
        public void Board_SimulatedCorners_WritesACameraThatReadsBack()
        {
            using var folder = new TemporaryFolder();
            string corners = Simulate(folder), result = folder.File("camera.json");
            Assert.That(CommandLine.Run("calibrate", "board", "--corners", corners, "--side", "right", "--out", result, "--model", "radial2").ExitCode, Is.EqualTo(ExitCodes.Done));
            LensCamera camera = LensCameraJson.ReadFile(result);
            Assert.That(camera.Pinhole.FocalXPx, Is.InRange(570, 650));
            Assert.That(camera.Distortion.ToOpenCv().Skip(2), Is.All.Zero);
        }

        [Test]
        public void Board_PicturesOfOneNameFromTwoFolders_AreAllDrawnWithThoseLeftOut()
        {
            using var folder = new TemporaryFolder();
            string pictures = folder.File("pictures"), result = folder.File("camera.json");
            foreach (string part in new[] { "a", "b" })
            {
                Directory.CreateDirectory(folder.File(part));
                for (int i = 0; i < 3; i++)
                    Paint(Path.Combine(folder.File(part), $"view{i}.jpg"), 320, 240, part == "a" ? i : i + 3);
            }

            // A picture without a board.
            Paint(Path.Combine(folder.File("b"), "none.jpg"), 320, 240, 200);
            (int exitCode, _, string error) = CommandLine.Run("calibrate", "board", "--images", folder.File("a"), folder.File("b"), "--board", "7x5", "--square", "30", "--out", result, "--model", "radial2", "--pictures", pictures);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(Directory.GetFiles(pictures).Select(Path.GetFileName), Is.EquivalentTo(new[] { "a-view0.png", "a-view1.png", "a-view2.png", "b-view0.png", "b-view1.png", "b-view2.png", "b-none.png" }));
            Assert.That(error, Does.Contain("b/none.jpg: left out"));
        }

        [Test]
        public void Board_OneViewWithACornerOutsideThePicture_GoesOnWithoutIt()
        {
            using var folder = new TemporaryFolder();
            string corners = Simulate(folder), result = folder.File("camera.json");
            JObject root = JObject.Parse(File.ReadAllText(corners));
            root["pairs"]![2]!["left_px"]![5] = new JArray(99999, 3);
            File.WriteAllText(corners, root.ToString());
            (int exitCode, _, string error) = CommandLine.Run("calibrate", "board", "--corners", corners, "--out", result, "--model", "radial2", "--pictures", folder.File("pictures"));
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(error, Does.Contain("left out: point 6 lies at 99999,3, outside the image"));
            Assert.That(((JArray)JObject.Parse(File.ReadAllText(result))["views"]!).Count, Is.EqualTo(7));
            Assert.That(Directory.GetFiles(folder.File("pictures")), Has.Length.EqualTo(8));
        }

        [Test]
        public void Board_Pictures_FindsItsOwnBoards()
        {
            using var folder = new TemporaryFolder();
            for (int i = 0; i < 4; i++)
                Paint(folder.File($"view{i}.jpg"), 320, 240, i);
            string pattern = Path.Combine(folder.Path, "view*.jpg"), result = folder.File("camera.json");
            CommandLine.AssertRefused("corners found, 9×6 asked for", "calibrate", "board", "--images", pattern, "--board", "9x6", "--out", result);
            (int exitCode, _, string error) = CommandLine.Run("calibrate", "board", "--images", pattern, "--board", "7x5", "--square", "30", "--out", result, "--model", "radial2");
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done), error);
            Assert.That((double)JObject.Parse(File.ReadAllText(result))["rms_px"]!, Is.LessThan(0.2));
            Paint(folder.File("view9.jpg"), 160, 120, 0);
            CommandLine.AssertRefused("view9.jpg: is 160×120, view0.jpg is 320×240", "calibrate", "board", "--images", pattern, "--board", "7x5", "--out", result);
        }

        [Test]
        public void Board_OneBlurredPictureAmongSeveral_IsNamedAndLeftOut()
        {
            using var folder = new TemporaryFolder();
            for (int i = 0; i < 6; i++)
                Paint(folder.File($"view{i}.jpg"), 320, 240, i, i == 4 ? 7 : 1);
            string result = folder.File("camera.json");
            string[] line = ["calibrate", "board", "--images", folder.Path, "--board", "7x5", "--square", "30", "--model", "radial2", "--out", result, "--replace"];
            (int exitCode, _, string error) = CommandLine.Run(line);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(error, Does.Match("^range: view4.jpg: left out: blurred: its edges are [0-9.]+ px wide[^\n]*\n$"));
            Assert.That(JObject.Parse(File.ReadAllText(result))["per_view_rms_px"]!, Has.Count.EqualTo(5));
            Assert.That(CommandLine.Run([.. line, "--keep-all"]).Error, Is.Empty);
        }

        [TestCase("{", "not JSON")]
        [TestCase("{\"v\":2,\"images\":[]}", "newer release (version 2")]
        [TestCase("{\"images\":[]}", "neither images nor pairs")]
        [TestCase("{\"images\":[{\"px\":[[1,2],[3,NaN]]}]}", "point 2, element 2, is not a finite number")]
        [TestCase("{\"images\":[{\"px\":[[1,2],[3,4],[5,7]],\"ids\":[0,1,10]}]}", "3 points; a view of a board needs at least 4")]
        [TestCase("{\"images\":[{\"px\":[[1,2],[3,4],[5,7]],\"ids\":[0,1,48]}]}", "48 is no point of the board")]
        [TestCase("{\"images\":[{\"px\":[[1,2],[3,4],[5,7]]}]}", "has 3 corners, the board has 48")]
        [TestCase("{\"v\":\"2\",\"images\":[{}]}", "field v is no version number")]
        [TestCase("{\"image_size\":[640,480],\"images\":[{\"image\":\"a\",\"px\":[[1,2],[3,4],[700,7],[8,9]],\"ids\":[0,1,9,8]}]}", "a: point 3 lies at 700,7, outside the image of 640x480")]
        [TestCase("{\"images\":[7]}", "view 1 is no object")]
        [TestCase("{\"images\":[{}]}", "field px of view 1 is missing")]
        [TestCase("{\"object_points\":[[0,0,1]],\"images\":[{\"px\":[[0,0]]}]}", "not lie in the board's plane")]
        public void Board_BrokenCorners_AreRefused(string content, string words)
        {
            using var folder = new TemporaryFolder();
            string corners = folder.File("corners.json");
            File.WriteAllText(corners, content);
            CommandLine.AssertRefused(words, "calibrate", "board", "--corners", corners, "--out", folder.File("camera.json"));
            Assert.That(Directory.GetFiles(folder.Path), Is.EqualTo(new[] { corners }));
        }

        [Test]
        public void Board_WrongSizeOfStoredBoard_SaysWhatItLooksLike()
        {
            using var folder = new TemporaryFolder();
            string corners = folder.File("corners.json");
            string px = string.Join(",", Enumerable.Range(0, 54).Select(i => FormattableString.Invariant($"[{100 + 30 * (i % 9)},{100 + 30 * (i / 9)}]")));
            File.WriteAllText(corners, "{\"images\":[{\"image\":\"a\",\"px\":[" + px + "]}]}");
            CommandLine.AssertRefused("a has 54 corners, the board has 48: it looks like 9×6", "calibrate", "board", "--corners", corners);
        }

        [TestCase("no pictures given")]
        [TestCase("means no picture", "--images", "nothing*.png")]
        [TestCase("--board: \"8\"", "--images", "x", "--board", "8")]
        [TestCase("--square: must be above 0", "--images", "x", "--square", "-1")]
        [TestCase("--square: 1E+308 mm is no square", "--images", "x", "--square", "1e308")]
        [TestCase("no lens model \"fisheye\"", "--images", "x", "--model", "fisheye")]
        [TestCase("--history: the calibration has no date", "--images", "x", "--history", "h")]
        [TestCase("--date: \"22.11.2026\"", "--images", "x", "--date", "22.11.2026")]
        [TestCase("--side: there is no side", "--corners", "x", "--side", "top")]
        public void Board_ImpossibleOptions_AreRefused(string words, params string[] options) => CommandLine.AssertRefused(words, ["calibrate", "board", .. options]);

        [Test]
        public void Stereo_OneViewGivenAgainAndAgain_IsParallel_AndOneCameraGivenTwice_StandsInOnePlace()
        {
            using var folder = new TemporaryFolder();
            JObject whole = JObject.Parse(File.ReadAllText(Simulate(folder)));
            string corners = folder.File("changed.json"), result = folder.File("stereo.json");
            var pairs = (JArray)whole["pairs"]!;
            JToken[] seen = pairs.ToArray();
            whole["pairs"] = new JArray(Enumerable.Repeat(seen[3], 12));
            File.WriteAllText(corners, whole.ToString());
            Assert.That(CommandLine.AssertRefused("not determined: fx", "calibrate", "stereo", "--corners", corners, "--out", result), Does.Contain("all parallel"));
            foreach (JToken pair in seen)
                pair["right_px"] = pair["left_px"]!.DeepClone();
            whole["pairs"] = new JArray(seen.Cast<object>().ToArray());
            File.WriteAllText(corners, whole.ToString());
            CommandLine.AssertRefused("both cameras stand in one place", "calibrate", "stereo", "--corners", corners, "--out", result);
            Assert.That(File.Exists(result), Is.False);
        }

        [TestCase("swapped", "left and right are swapped")]
        [TestCase("left mirrored", "appear mirrored to the left camera only")]
        [TestCase("other moments", "the pairs do not agree")]
        public void Stereo_WrongGeometry_IsRefusedInOneLine(string what, string words)
        {
            using var folder = new TemporaryFolder();
            JObject whole = JObject.Parse(File.ReadAllText(Simulate(folder)));
            string corners = folder.File("changed.json"), result = folder.File("stereo.json");
            JToken[] pairs = whole["pairs"]!.ToArray(), rights = pairs.Select(pair => pair["right_px"]!.DeepClone()).ToArray();
            for (int i = 0; i < pairs.Length; i++)
            {
                JToken left = pairs[i]["left_px"]!.DeepClone();
                pairs[i]["left_px"] = what == "swapped" ? rights[i] : what == "left mirrored" ? Mirrored(left) : left;
                pairs[i]["right_px"] = what == "swapped" ? left : what == "other moments" ? rights[(i + 1) % pairs.Length].DeepClone() : rights[i];
            }

            File.WriteAllText(corners, whole.ToString());
            CommandLine.AssertRefused(words, "calibrate", "stereo", "--corners", corners, "--out", result);
            Assert.That(File.Exists(result), Is.False);
        }

        /// <summary>The corners of an 8×6 board with every row from its other end.</summary>
        private static JArray Mirrored(JToken px) => new(px.Chunk(8).SelectMany(row => row.Reverse()));

        [Test]
        public void Board_ResultInPlaceOfAPicture_IsRefused()
        {
            using var folder = new TemporaryFolder();
            string picture = folder.File("a.png");
            File.WriteAllText(picture, "kept");
            CommandLine.AssertRefused("this file is also read", "calibrate", "board", "--images", picture, "--out", picture, "--replace");
            CommandLine.AssertRefused("this file is also read", "calibrate", "stereo", "--left", picture, "--right", picture, "--out", picture, "--replace");
            Assert.That(File.ReadAllText(picture), Is.EqualTo("kept"));
        }

        [Test]
        public void Stereo_DamagedCorners_AreRefusedInOneLineOrUsed()
        {
            using var folder = new TemporaryFolder();
            string whole = File.ReadAllText(Simulate(folder)), corners = folder.File("damaged.json"), result = folder.File("stereo.json");
            var random = new Random(5);
            string[] pieces = { "null", "NaN", "1e308", "-1e308", "[]", "{}", "\"x\"", "]", ",", "1e-300", "true", "99999999999999999999" };
            int used = 0;
            for (int i = 0; i < 40; i++)
            {
                int at = random.Next(whole.Length), length = random.Next(4) == 0 ? random.Next(400) : random.Next(8);
                File.WriteAllText(corners, whole[..at] + pieces[random.Next(pieces.Length)] + whole[Math.Min(whole.Length, at + length)..]);
                (int exitCode, string output, string error) = CommandLine.Run("calibrate", "stereo", "--corners", corners, "--out", result, "--replace");
                Assert.That(exitCode, Is.EqualTo(ExitCodes.Done).Or.EqualTo(ExitCodes.BadInput), error);
                Assert.That(error, Does.Not.Contain("internal error"));
                if (exitCode == ExitCodes.BadInput)
                    Assert.That(error.TrimEnd(), Does.Match("^range: [^\n]+: [^\n]+; [^\n]+$"));
                used += exitCode == ExitCodes.Done ? 1 : 0;
            }

            Assert.That(used, Is.LessThan(40));
        }

        [Test]
        public void Stereo_UnequalNumbersOfPictures_AreRefused()
        {
            using var folder = new TemporaryFolder();
            foreach (string name in new[] { "l1.jpg", "l2.jpg", "r1.jpg" })
                Paint(folder.File(name), 64, 48, 0);
            CommandLine.AssertRefused("2 pictures of the left camera, 1 of the right", "calibrate", "stereo", "--left", folder.File("l*.jpg"), "--right", folder.File("r*.jpg"));
        }

        private static string Simulate(TemporaryFolder folder)
        {
            string corners = folder.File("corners.json");
            Assert.That(CommandLine.Run("calibrate", "simulate", "--views", "8", "--seed", "3", "--out", corners).ExitCode, Is.EqualTo(ExitCodes.Done));
            return corners;
        }

        /// <summary>A board of 8×6 squares seen by a camera without lens, each pixel the mean of 16 samples over a square of some pixels.</summary>
        private static void Paint(string path, int width, int height, int number, double blurPx = 1)
        {
            double focal = 0.9 * width;
            Rotation3D turn = Rotation3D.AboutAxis(new Vector3D(Math.Cos(1.6 * number), Math.Sin(1.6 * number), 0), 0.45);
            var middle = new Vector3D(120, 90, 0);
            var position = new Vector3D(8 * number - 12, 5 * number - 8, 420) - turn * middle;
            Vector3D x = turn * new Vector3D(1, 0, 0), y = turn * new Vector3D(0, 1, 0);
            double[] m = { focal * x.X + width / 2.0 * x.Z, focal * y.X + width / 2.0 * y.Z, focal * position.X + width / 2.0 * position.Z, focal * x.Y + height / 2.0 * x.Z, focal * y.Y + height / 2.0 * y.Z, focal * position.Y + height / 2.0 * position.Z, x.Z, y.Z, position.Z };
            Homography toBoard = new Homography(m).Inverse;
            using var image = new Image();
            image.Reset(PixelFormat.Gray8, width, height, 0);
            for (int row = 0; row < height; row++)
            for (int column = 0; column < width; column++)
            {
                double sum = 0;
                for (int k = 0; k < 16; k++)
                {
                    Vector2D p = toBoard.Map(new Vector2D(column + (k % 4 - 1.5) / 4 * blurPx, row + (k / 4 - 1.5) / 4 * blurPx));
                    bool isInside = p.X >= 0 && p.Y >= 0 && p.X < 240 && p.Y < 180;
                    sum += isInside && ((int)(p.X / 30) + (int)(p.Y / 30)) % 2 == 0 ? 40 : 210;
                }

                image.Bytes[row * image.Stride + column] = (byte)(sum / 16);
            }

            File.WriteAllBytes(path, new JpegEncoder(quality: 98).Encode(image).ToArray());
        }
    }
}
