using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Remote
{
    public sealed class RemoteMessageReaderTests
    {
        [Test]
        public void Message_ShotOfThePipeline_ComesBackWhole()
        {
            ShotEvent sent = EventExamples.FullShot();
            using (var writer = new MessageWriter(null))
                Assert.That(RemoteMessageReader.Read(writer.Shot(sent, 5), out RemoteMessage message), Is.EqualTo(RemoteDrop.None));
            using (var writer = new MessageWriter(null))
            {
                RemoteMessageReader.Read(writer.Shot(sent, 5), out RemoteMessage message);
                ShotEvent read = message.Shot.Event;
                Assert.That(message.IsShot, Is.True);
                Assert.That((message.Counter, message.SentUs), Is.EqualTo((1L, 5L)));
                Assert.That((read.Shot.Id, read.Shot.FrameIndex, read.Shot.FirstFrameIndex, read.Shot.LastFrameIndex), Is.EqualTo((7, 412, 411, 413)));
                Assert.That((read.Shot.TimeUs, read.Shot.TimeSigmaUs, read.PairDeltaUs), Is.EqualTo((sent.Shot.TimeUs, sent.Shot.TimeSigmaUs, sent.PairDeltaUs)));
                Assert.That(read.Shot.Dot.PositionPx, Is.EqualTo(sent.Shot.Dot.PositionPx));
                Assert.That(read.Shot.Dot.CovariancePx, Is.EqualTo(sent.Shot.Dot.CovariancePx));
                Assert.That((read.Shot.Dot.Peak, read.Shot.Dot.AreaPx, read.Shot.Dot.Color, read.Shot.Dot.Confidence), Is.EqualTo((255, 31, LaserColor.Green, 0.91)));
                Assert.That(read.Shot.Dot.StreakPx, Is.EqualTo(sent.Shot.Dot.StreakPx));
                Assert.That((read.HasScreenPosition, read.ScreenM, read.ScreenCovarianceMm2), Is.EqualTo((true, sent.ScreenM, sent.ScreenCovarianceMm2)));
                Assert.That((read.Shooter, read.ShooterProbability, read.Hand), Is.EqualTo((2, 0.97, HandSide.Right)));
                Assert.That((read.HasMuzzle, read.MuzzleM), Is.EqualTo((true, sent.MuzzleM)));
                Assert.That((read.Direction - sent.Direction).Length, Is.LessThan(1e-4));
                Assert.That(read.HasHit, Is.False, "what was hit is judged where the scene is");
            }
        }

        [Test]
        public void Message_HandOfThePipeline_IsAPose()
        {
            using (var writer = new MessageWriter(null))
            {
                RemoteMessageReader.Read(writer.Hand(EventExamples.Hand(3, 4000), 5), out RemoteMessage message);
                Assert.That((message.IsPose, message.IsShot), Is.EqualTo((true, false)));
                Assert.That((message.Pose.Space, message.Pose.TimeUs, message.Pose.TrackId, message.Pose.Hand), Is.EqualTo((RemoteSpace.ScreenM, 4000L, 2, HandSide.Left)));
                Assert.That(message.Pose.Muzzle, Is.EqualTo(new Vector3D(1.1, 1.2, -2.3)));
                Assert.That(message.Pose.Direction.IsFinite, Is.False);
            }
        }

        [TestCase("{\"timestamp\":1717.25,\"muzzle\":[100,-50,1500],\"target\":[400,350,1500],\"confidence\":0.8}")]
        [TestCase("{\"timestamp\":1717.25,\"muzzle\":{\"x\":100,\"y\":-50,\"z\":1500},\"target\":{\"z\":1500,\"y\":350,\"x\":400},\"confidence\":0.8,\"camera\":{\"id\":[0]}}")]
        public void Message_Published_GivesTheRayOfItsEquation(string text)
        {
            Assert.That(RemoteMessageReader.Read(RemoteExamples.Bytes(text), out RemoteMessage message), Is.EqualTo(RemoteDrop.None));
            Assert.That((message.IsPose, message.IsShot, message.HasHead, message.Pose.Space), Is.EqualTo((true, false, false, RemoteSpace.CameraMm)));
            Assert.That(message.Pose.TimeUs, Is.EqualTo(1717250000));
            Assert.That(message.Pose.Confidence, Is.EqualTo(0.8));
            // (300, 400, 0) has length 500.
            Assert.That((message.Pose.Direction - new Vector3D(0.6, 0.8, 0)).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void Message_PublishedThatSaysShot_IsBoth()
        {
            RemoteMessageReader.Read(RemoteExamples.Bytes(RemoteExamples.Published.Replace("}", ",\"shot\":true}")), out RemoteMessage message);
            Assert.That((message.IsPose, message.IsShot), Is.EqualTo((true, true)));
            Assert.That(message.Shot.Aim.Target, Is.EqualTo(new Vector3D(400, 350, 1500)));
        }

        [TestCase("\"id\":7", "\"id\":0", RemoteDrop.OutOfRange)]
        [TestCase("\"id\":7", "\"id\":2147483648", RemoteDrop.OutOfRange)]
        [TestCase("\"id\":7", "\"id\":7.5", RemoteDrop.OutOfRange)]
        [TestCase("\"id\":7", "\"id\":\"7\"", RemoteDrop.WrongField)]
        [TestCase("\"id\":7", "\"id\":null", RemoteDrop.WrongField)]
        [TestCase("\"id\":7", "\"id\":7,\"id\":8", RemoteDrop.WrongField)]
        [TestCase("\"v\":1", "\"v\":2", RemoteDrop.WrongField)]
        [TestCase("\"type\":\"shot\"", "\"type\":\"health\"", RemoteDrop.UnknownType)]
        [TestCase("\"type\":\"shot\"", "\"type\":3", RemoteDrop.WrongField)]
        [TestCase("\"type\":\"shot\",", "", RemoteDrop.WrongField)]
        [TestCase("\"counter\":1,", "", RemoteDrop.WrongField)]
        [TestCase("0.9", "1.01", RemoteDrop.OutOfRange)]
        [TestCase("0.9", "1e999", RemoteDrop.OutOfRange)]
        [TestCase("0.9", "-1e999", RemoteDrop.OutOfRange)]
        [TestCase("0.9", "NaN", RemoteDrop.NotJson)]
        [TestCase("0.9", "true", RemoteDrop.WrongField)]
        [TestCase("[1.5,0.5]", "[1.5,101]", RemoteDrop.OutOfRange)]
        [TestCase("[1.5,0.5]", "[1.5]", RemoteDrop.WrongField)]
        [TestCase("[1.5,0.5]", "[1.5,0.5,0]", RemoteDrop.WrongField)]
        [TestCase("[1.5,0.5]", "[1.5,null]", RemoteDrop.WrongField)]
        [TestCase("[1.5,0.5]", "{\"x\":1,\"x\":2}", RemoteDrop.WrongField)]
        [TestCase("[1.5,0.5]", "null", RemoteDrop.WrongField)]
        [TestCase("[1.5,0.5]", "[1.5,0.5],\"screen_cov_mm2\":[1,2,1]", RemoteDrop.OutOfRange)]
        [TestCase("[1.5,0.5]", "[1.5,0.5],\"direction\":[0,0,0.5]", RemoteDrop.OutOfRange)]
        [TestCase("[1.5,0.5]", "[1.5,0.5],\"hand\":\"third\"", RemoteDrop.WrongField)]
        [TestCase("[1.5,0.5]", "[1.5,0.5],\"color\":\"blue\"", RemoteDrop.WrongField)]
        [TestCase("[1.5,0.5]", "[1.5,0.5],\"whatever\":{\"deep\":[1,{}]}", RemoteDrop.None)]
        [TestCase("[1.5,0.5]", "null,\"x_px\":12,\"y_px\":13", RemoteDrop.None)]
        [TestCase("[1.5,0.5]", "null,\"x_px\":12", RemoteDrop.WrongField)]
        public void Message_WithOneThingChanged_IsJudged(string from, string to, RemoteDrop expected)
        {
            string text = RemoteExamples.Shot(7, 1, 5);
            Assert.That(RemoteMessageReader.Read(RemoteExamples.Bytes(text), out _), Is.EqualTo(RemoteDrop.None));
            Assert.That(text, Does.Contain(from));
            Assert.That(RemoteMessageReader.Read(RemoteExamples.Bytes(text.Replace(from, to)), out _), Is.EqualTo(expected));
        }

        [TestCase("{\"timestamp\":1}", RemoteDrop.WrongField)]
        [TestCase("{\"muzzle\":[0,0,1],\"target\":[0,0,2]}", RemoteDrop.WrongField)]
        [TestCase("{\"timestamp\":1,\"muzzle\":[0,0,1],\"target\":[0,0,1]}", RemoteDrop.OutOfRange)]
        [TestCase("{\"timestamp\":1,\"target\":[0,0,100001]}", RemoteDrop.OutOfRange)]
        [TestCase("{\"timestamp\":-1,\"target\":[0,0,1]}", RemoteDrop.OutOfRange)]
        [TestCase("{\"timestamp\":1,\"target\":[0,0,1],\"shot\":1}", RemoteDrop.WrongField)]
        [TestCase("{\"timestamp\":1,\"target\":[0,0,1]}", RemoteDrop.None)]
        [TestCase("{\"timestamp\":1,\"muzzle\":[0,0,1],\"direction\":[0,0,1]}", RemoteDrop.None)]
        [TestCase("{\"timestamp\":1,\"muzzle\":[0,0,1]}", RemoteDrop.WrongField)]
        public void Message_Published_IsJudged(string text, RemoteDrop expected) =>
            Assert.That(RemoteMessageReader.Read(RemoteExamples.Bytes(text), out _), Is.EqualTo(expected));

        [Test]
        public void Message_ReadAndWritten_LeavesNoGarbage()
        {
            ShotEvent shot = EventExamples.FullShot();
            using (var writer = new MessageWriter(null))
            {
                Assert.That(Allocation.Of(() =>
                {
                    for (int i = 0; i < 100; i++)
                        RemoteMessageReader.Read(writer.Shot(shot, 5), out _);
                }), Is.Zero);
            }
        }
    }
}
