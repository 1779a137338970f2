using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Hands.Model;
using LaserTracking.Imaging;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    /// <summary>Our executor against what the original runtime answers, with the tolerances of data/hands/README.md.</summary>
    [Category("Reference")]
    public sealed class HandModelReferenceTests
    {
        [TestCase("lite")]
        [TestCase("full")]
        public void HandLandmarkNetwork_EveryPicture_AnswersAsTheOriginalRuntime(string model)
        {
            string inputs = TestFiles.Reference("hands", "inputs.json");
            JObject reference = JObject.Parse(File.ReadAllText(TestFiles.Reference("hands", $"reference_{model}.json")));
            using HandLandmarkNetwork network = HandModelForTests.Open(model);
            Dictionary<string, JToken> answers = reference["results"]!.ToDictionary(result => (string)result["id"]!);
            var first = new Deviation();
            var second = new Deviation();
            var landmarks = new HandLandmarks();
            foreach (JObject input in HandModelPictures.All(inputs))
            {
                if (!answers.TryGetValue((string)input["id"]!, out JToken? answer))
                    continue;
                using Image picture = HandModelPictures.Draw(input);
                network.Run(picture, new HandRegion(picture.Width / 2.0, picture.Height / 2.0, picture.Width, 0), landmarks);
                first.Add(answer, landmarks);
                if (answer["second_pass"] is not { } next)
                    continue;
                HandRegion region = landmarks.NextRegion;
                second.Add(next["roi"]!, region);
                network.Run(picture, region, landmarks);
                second.Add(next, landmarks);
                second.Picture(next["picture_px"]!, next["picture_world"]!, landmarks);
            }

            TestContext.Out.WriteLine($"{model}, first pass: {first}");
            TestContext.Out.WriteLine($"{model}, second pass: {second}");
            Assert.Multiple(() =>
            {
                Assert.That(first.Count, Is.GreaterThan(0));
                Assert.That(first.LandmarksPx, Is.LessThanOrEqualTo(2e-3));
                Assert.That(first.Presence, Is.LessThanOrEqualTo(1e-5));
                Assert.That(first.Handedness, Is.LessThanOrEqualTo(3e-5));
                Assert.That(first.WorldM, Is.LessThanOrEqualTo(1e-5));
                Assert.That(second.LandmarksPx, Is.LessThanOrEqualTo(5e-3));
                Assert.That(second.Presence, Is.LessThanOrEqualTo(1e-4));
                Assert.That(second.Handedness, Is.LessThanOrEqualTo(1e-4));
                Assert.That(second.WorldM, Is.LessThanOrEqualTo(1e-5));
                Assert.That(second.RegionPx, Is.LessThanOrEqualTo(2e-3));
                Assert.That(second.RegionRad, Is.LessThanOrEqualTo(1e-5));
            });
        }

        [Test]
        public void HandRegion_EveryCase_IsThatOfTheReference()
        {
            JObject cases = JObject.Parse(File.ReadAllText(TestFiles.Reference("hands", "roi_cases.json")));
            var deviation = new Deviation();
            foreach (JToken item in cases["from_landmarks"]!)
            {
                Vector3D[] points = item["landmarks"]!.Select(p => new Vector3D((double)p[0]!, (double)p[1]!, 0)).ToArray();
                HandRegion region = HandRegion.FromLandmarks(points);
                deviation.Add(item["roi"]!, region);
                deviation.Corners(item["corners"]!, region);
            }

            foreach (JToken item in cases["from_palm"]!)
            {
                JToken box = item["box"]!, points = item["keypoints"]!;
                HandRegion region = HandRegion.FromPalm((double)box["x"]!, (double)box["y"]!, (double)box["w"]!, (double)box["h"]!,
                    new Vector2D((double)points[0]![0]!, (double)points[0]![1]!), new Vector2D((double)points[2]![0]!, (double)points[2]![1]!));
                deviation.Add(item["roi"]!, region);
                deviation.Corners(item["corners"]!, region);
            }

            TestContext.Out.WriteLine(deviation.ToString());
            Assert.That(deviation.RegionPx, Is.GreaterThan(-1).And.LessThanOrEqualTo(1e-6));
            Assert.That(deviation.RegionRad, Is.LessThanOrEqualTo(1e-9));
        }

        [Test]
        public void HandLandmarks_TakenBackToThePicture_LieWhereTheReferenceHasThem()
        {
            JObject cases = JObject.Parse(File.ReadAllText(TestFiles.Reference("hands", "roi_cases.json")));
            var landmarks = new HandLandmarks();
            var deviation = new Deviation();
            foreach (JToken item in cases["project"]!)
            {
                landmarks.Set(Region(item["roi"]!), Floats(item["raw_landmarks"]!), Floats(item["raw_world"]!), 1, 1);
                deviation.Picture(item["picture_px"]!, item["picture_world"]!, landmarks);
            }

            Assert.That(deviation.PicturePx, Is.GreaterThanOrEqualTo(0).And.LessThanOrEqualTo(1e-6));
            Assert.That(deviation.WorldM, Is.LessThanOrEqualTo(1e-9));
        }

        [TestCase("lite")]
        [TestCase("full")]
        public void HandSearch_DrawnHandInALargerPicture_IsFoundWhereItLies(string model)
        {
            JObject input = HandModelPictures.All(TestFiles.Reference("hands", "inputs.json")).First(item => (string?)item["id"] == "hand_open");
            using HandLandmarkNetwork network = HandModelForTests.Open(model);
            using Image hand = HandModelPictures.Draw(input);
            using var picture = new Image();
            picture.Reset(PixelFormat.Bgra32, 560, 420, 0);
            picture.Bytes.Fill(90);
            for (int y = 0; y < hand.Height; y++)
                hand.Bytes.Slice(y * hand.Stride, hand.Stride).CopyTo(picture.Bytes.Slice((y + 150) * picture.Stride + 300 * 4));
            var found = new HandLandmarks();
            Assert.That(new HandSearch(network).TryFind(picture, found), Is.True);
            var alone = new HandLandmarks();
            network.Run(picture, new HandRegion(412, 262, 224, 0), alone);
            network.Run(picture, alone.NextRegion, alone);
            for (int i = 0; i < HandLandmarks.Count; i++)
            {
                // About a tenth of the hand: two crops of a drawn hand do not agree closer than that.
                Assert.That(found.PicturePx[i].X, Is.EqualTo(alone.PicturePx[i].X).Within(22), "landmark " + i);
                Assert.That(found.PicturePx[i].Y, Is.EqualTo(alone.PicturePx[i].Y).Within(22), "landmark " + i);
            }
        }

        /// <summary>
        /// No picture of people may lie here, so this says only that the answer is about the side: seen in a mirror a right hand is a left
        /// one. The second region, as the tracker uses it; hands that the model does not see both ways round say nothing. Of the drawn
        /// hands lite takes one, a pointing finger, for the same hand either way.
        /// </summary>
        [TestCase("lite", 1)]
        [TestCase("full", 0)]
        public void HandLandmarkNetwork_MirroredPicture_SaysTheOtherSide(string model, int exceptions)
        {
            using HandLandmarkNetwork network = HandModelForTests.Open(model);
            int seen = 0, flipped = 0;
            foreach (JObject input in HandModelPictures.All(TestFiles.Reference("hands", "inputs.json")).Where(item => ((string)item["id"]!).StartsWith("hand", StringComparison.Ordinal)))
            {
                using Image picture = HandModelPictures.Draw(input);
                using Image mirrored = Mirrored(picture);
                if (!TryHandedness(network, picture, out double straight) || !TryHandedness(network, mirrored, out double inMirror))
                    continue;
                seen++;
                flipped += straight > 0.5 != inMirror > 0.5 ? 1 : 0;
                TestContext.Out.WriteLine($"{model} {input["id"]}: {straight:F3}, in a mirror {inMirror:F3}");
            }

            TestContext.Out.WriteLine($"{model}: {flipped} of {seen} hands change sides");
            Assert.That(seen, Is.GreaterThanOrEqualTo(8));
            Assert.That(flipped, Is.GreaterThanOrEqualTo(seen - exceptions));
        }

        private static bool TryHandedness(HandLandmarkNetwork network, Image picture, out double handedness)
        {
            var landmarks = new HandLandmarks();
            network.Run(picture, new HandRegion(picture.Width / 2.0, picture.Height / 2.0, picture.Width, 0), landmarks);
            network.Run(picture, landmarks.NextRegion, landmarks);
            handedness = landmarks.RightHandProbability;
            return landmarks.Presence > HandLandmarkNetwork.MinPresence;
        }

        private static Image Mirrored(Image picture)
        {
            var mirrored = new Image();
            mirrored.Reset(picture.Format, picture.Width, picture.Height, 0);
            for (int y = 0; y < picture.Height; y++)
            {
                for (int x = 0; x < picture.Width; x++)
                    picture.Bytes.Slice(y * picture.Stride + 4 * x, 4).CopyTo(mirrored.Bytes.Slice(y * mirrored.Stride + 4 * (picture.Width - 1 - x)));
            }

            return mirrored;
        }

        /// <summary>Camera 1 has no colour: its infrared picture is linear, of 16 bits and without a unit.</summary>
        [TestCase("lite")]
        [TestCase("full")]
        public void HandLandmarkNetwork_Infrared_SeesTheSameHandAsInColour(string model)
        {
            using HandLandmarkNetwork network = HandModelForTests.Open(model);
            var inColour = new HandLandmarks();
            var inInfrared = new HandLandmarks();
            using var infrared = new Image();
            foreach (JObject input in HandModelPictures.All(TestFiles.Reference("hands", "inputs.json")).Where(item => ((string)item["id"]!).StartsWith("hand_open", StringComparison.Ordinal)))
            {
                using Image picture = HandModelPictures.Draw(input);
                infrared.Reset(PixelFormat.Infrared16, picture.Width, picture.Height, 0);
                for (int i = 0; i < picture.Width * picture.Height; i++)
                {
                    double grey = (picture.Bytes[4 * i] + 2 * picture.Bytes[4 * i + 1] + picture.Bytes[4 * i + 2]) / 1020.0;
                    BitConverter.TryWriteBytes(infrared.Bytes.Slice(2 * i), (ushort)(3000 * grey * grey));
                }

                var region = new HandRegion(112, 112, 224, 0);
                network.Run(picture, region, inColour);
                network.Run(infrared, region, inInfrared);
                Assert.That(inInfrared.Presence, Is.GreaterThan(HandLandmarkNetwork.MinPresence));
                double worst = Enumerable.Range(0, HandLandmarks.Count).Max(i => Math.Max(Math.Abs(inColour.PicturePx[i].X - inInfrared.PicturePx[i].X), Math.Abs(inColour.PicturePx[i].Y - inInfrared.PicturePx[i].Y)));
                TestContext.Out.WriteLine($"{model} {input["id"]}: {worst:F1} px");
                Assert.That(worst, Is.LessThan(20));
            }
        }

        private static HandRegion Region(JToken roi) => new((double)roi["cx"]!, (double)roi["cy"]!, (double)roi["side"]!, (double)roi["rotation_rad"]!);

        private static float[] Floats(JToken list) => list.Select(value => (float)value).ToArray();

        /// <summary>Largest differences so far; -1 where nothing was compared.</summary>
        private sealed class Deviation
        {
            public int Count { get; private set; }
            public double LandmarksPx { get; private set; } = -1;
            public double Presence { get; private set; } = -1;
            public double Handedness { get; private set; } = -1;
            public double WorldM { get; private set; } = -1;
            public double PicturePx { get; private set; } = -1;
            public double RegionPx { get; private set; } = -1;
            public double RegionRad { get; private set; } = -1;

            public void Add(JToken answer, HandLandmarks found)
            {
                Count++;
                float[] landmarks = Floats(answer["landmarks"]!), world = Floats(answer["world"]!);
                for (int i = 0; i < landmarks.Length; i++)
                    LandmarksPx = Math.Max(LandmarksPx, Math.Abs(landmarks[i] - found.CropPx[i]));
                Presence = Math.Max(Presence, Math.Abs((double)answer["presence"]! - found.Presence));
                Handedness = Math.Max(Handedness, Math.Abs((double)answer["handedness"]! - found.RightHandProbability));
                double cos = Math.Cos(-found.Region.RotationRad), sin = Math.Sin(-found.Region.RotationRad);
                for (int i = 0; i < HandLandmarks.Count; i++)
                {
                    Vector3D point = found.WorldM[i];
                    var raw = new Vector3D(point.X * cos - point.Y * sin, point.X * sin + point.Y * cos, point.Z);
                    WorldM = Math.Max(WorldM, Largest(raw - new Vector3D(world[3 * i], world[3 * i + 1], world[3 * i + 2])));
                }
            }

            public void Add(JToken roi, HandRegion region)
            {
                HandRegion expected = Region(roi);
                RegionPx = Math.Max(RegionPx, Math.Max(Math.Abs(expected.SidePx - region.SidePx),
                    Math.Max(Math.Abs(expected.CenterXPx - region.CenterXPx), Math.Abs(expected.CenterYPx - region.CenterYPx))));
                RegionRad = Math.Max(RegionRad, Math.Abs(region.Turned(-expected.RotationRad).RotationRad));
            }

            public void Corners(JToken corners, HandRegion region)
            {
                foreach (JToken corner in corners)
                {
                    Vector2D place = region.ToPicture(((double)corner["crop_pixel"]![0]! + 0.5) / 224, ((double)corner["crop_pixel"]![1]! + 0.5) / 224);
                    RegionPx = Math.Max(RegionPx, Math.Max(Math.Abs(place.X - (double)corner["picture"]![0]!), Math.Abs(place.Y - (double)corner["picture"]![1]!)));
                }
            }

            public void Picture(JToken px, JToken world, HandLandmarks found)
            {
                for (int i = 0; i < HandLandmarks.Count; i++)
                {
                    PicturePx = Math.Max(PicturePx, Largest(found.PicturePx[i] - Point(px, i)));
                    WorldM = Math.Max(WorldM, Largest(found.WorldM[i] - Point(world, i)));
                }
            }

            public override string ToString() => FormattableString.Invariant(
                $"{Count} pictures, landmarks {LandmarksPx:E1} px, presence {Presence:E1}, handedness {Handedness:E1}, world {WorldM:E1} m, in the picture {PicturePx:E1} px, region {RegionPx:E1} px {RegionRad:E1} rad");

            private static Vector3D Point(JToken list, int i) => new((double)list[3 * i]!, (double)list[3 * i + 1]!, (double)list[3 * i + 2]!);

            private static double Largest(Vector3D v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));
        }
    }
}
