using System;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Hands.Model;
using LaserTracking.Imaging;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    /// <summary>The whole way with the real model: a drawn hand before camera 1, placed, sized and turned by depth, followed by its landmarks.</summary>
    [Category("Reference")]
    public sealed class HandModelTrackingTests
    {
        private const int Frames = 8;

        private static readonly PinholeCamera Camera = new(504, 504, 319.5, 287.5, 640, 576);

        // Wrist below, fingers up; degrees clockwise. The forearm is seen from the side, or points at the camera.
        [TestCase("lite", 0, true)]
        [TestCase("lite", 60, true)]
        [TestCase("lite", -120, true)]
        [TestCase("lite", 90, false)]
        [TestCase("full", 0, true)]
        [TestCase("full", 150, true)]
        [TestCase("full", -90, false)]
        public void LandmarkHandTracker_TurnedHand_IsSeenUpright(string model, double degrees, bool isArmSeen)
        {
            JObject input = HandModelPictures.All(TestFiles.Reference("hands", "inputs.json")).First(item => (string?)item["id"] == "hand_open");
            using HandLandmarkNetwork network = HandModelForTests.Open(model);
            using Image drawn = HandModelPictures.Draw(input);
            var alone = new HandLandmarks();
            network.Run(drawn, new HandRegion(112, 112, 224, 0), alone);
            network.Run(drawn, alone.NextRegion, alone);

            // The drawn square is 270 mm wide here, as large as the hand in it is in truth.
            double turn = degrees * Math.PI / 180;
            var place = new HandRegion(330, 260, 170, turn);
            using var frame = new Frame();
            var hand = new FixedTracker();
            Vector2D palmPx = ToFrame(place, PalmOf(alone));
            double distance = 504 * 270 / place.SidePx;
            hand.Hand = new HandObservation
            {
                TrackId = 1, SigmaMm = 12, DepthSource = DepthSource.Measured, PalmMm = Camera.Unproject(palmPx.X - 0.5 + 5, palmPx.Y - 0.5 - 4, distance),
                AimDirection = isArmSeen ? new Vector3D(Math.Sin(turn), -Math.Cos(turn), 0) : new Vector3D(0, 0, -1),
            };
            var tracker = new LandmarkHandTracker(hand, Camera, network);
            var hands = new HandObservations();
            Show(frame, drawn, place);
            for (int i = 0; i < Frames; i++)
                tracker.Process(frame, hands);

            Assert.That(tracker.TryGetLandmarks(1, out HandLandmarks seen), Is.True);
            double scale = place.SidePx / 224, worst = 0;
            for (int i = 0; i < HandLandmarks.Count; i++)
            {
                Vector2D expected = ToFrame(place, new Vector2D(alone.PicturePx[i].X, alone.PicturePx[i].Y));
                worst = Math.Max(worst, Math.Max(Math.Abs(expected.X - seen.PicturePx[i].X), Math.Abs(expected.Y - seen.PicturePx[i].Y)));
            }

            TestContext.Out.WriteLine($"{model} {degrees}: {worst:F1} px of {110 * scale:F0} px palm and fingers, presence {seen.Presence:F3}");
            Assert.That(worst, Is.LessThan(6));
            Assert.That((hands.Hands[0].PalmMm - Camera.Unproject(palmPx.X - 0.5, palmPx.Y - 0.5, distance)).Length,
                Is.LessThan((hand.Hand.PalmMm - Camera.Unproject(palmPx.X - 0.5, palmPx.Y - 0.5, distance)).Length));
        }

        private static Vector2D PalmOf(HandLandmarks hand)
        {
            Vector3D sum = hand.PicturePx[0] + hand.PicturePx[5] + hand.PicturePx[9] + hand.PicturePx[13] + hand.PicturePx[17];
            return new Vector2D(sum.X / 5, sum.Y / 5);
        }

        private static Vector2D ToFrame(HandRegion place, Vector2D drawn) => place.ToPicture(drawn.X / 224, drawn.Y / 224);

        /// <summary>The drawn square at its place in camera 1's picture, its edge repeated around it.</summary>
        private static void Show(Frame frame, Image drawn, HandRegion place)
        {
            frame.Begin(0, 0);
            frame.Depth.Reset(PixelFormat.Depth16, Camera.Width, Camera.Height, 0);
            frame.Color.Reset(PixelFormat.Bgra32, Camera.Width, Camera.Height, 0);
            double cos = Math.Cos(place.RotationRad), sin = Math.Sin(place.RotationRad), scale = 224 / place.SidePx;
            for (int y = 0; y < Camera.Height; y++)
            {
                for (int x = 0; x < Camera.Width; x++)
                {
                    double dx = x + 0.5 - place.CenterXPx, dy = y + 0.5 - place.CenterYPx;
                    int u = Math.Clamp((int)(112 + (dx * cos + dy * sin) * scale), 0, 223), v = Math.Clamp((int)(112 + (dy * cos - dx * sin) * scale), 0, 223);
                    drawn.Bytes.Slice(v * drawn.Stride + 4 * u, 4).CopyTo(frame.Color.Bytes.Slice(y * frame.Color.Stride + 4 * x));
                }
            }
        }

        private sealed class FixedTracker : IHandTracker
        {
            public HandObservation Hand { get; set; }

            public void Process(Frame frame, HandObservations observations)
            {
                observations.Begin(frame.Index, frame.Depth.TimeUs);
                observations.Add(Hand);
            }

            public void Reset()
            {
            }
        }
    }
}
