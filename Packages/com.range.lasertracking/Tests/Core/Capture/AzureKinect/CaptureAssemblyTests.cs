using System.Collections.Generic;
using System.IO;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>The rule that joins colour, depth and infrared into captures, on recordings made in memory.</summary>
    public sealed class CaptureAssemblyTests
    {
        private const short HalfPeriodUs = 16666;

        [Test]
        public void KinectRecording_BlocksWithinHalfAPeriod_FormOneCapture()
        {
            KinectRecording recording = Recording(0, (RecordingMuxer.Depth, 0), (RecordingMuxer.Color, HalfPeriodUs - 1));
            Assert.That(Forwards(recording), Is.EqualTo(new[] { "C16665 D0" }));
        }

        [Test]
        public void KinectRecording_BlockHalfAPeriodLater_OpensTheNextCapture()
        {
            // Half of 33333333 ns is 16666666 ns: 16666 us is inside, 16667 us is not.
            KinectRecording recording = Recording(0, (RecordingMuxer.Depth, 0), (RecordingMuxer.Color, HalfPeriodUs + 1));
            Assert.That(Forwards(recording), Is.EqualTo(new[] { "D0", "C16667" }));
        }

        [Test]
        public void KinectRecording_PositiveDepthDelay_BelongsToTheEarlierColor()
        {
            KinectRecording recording = Recording(20000, (RecordingMuxer.Color, 0), (RecordingMuxer.Depth, 20000), (RecordingMuxer.Infrared, 20000));
            Assert.That(Forwards(recording), Is.EqualTo(new[] { "C0 D20000 I20000" }));
        }

        [Test]
        public void KinectRecording_NegativeDepthDelay_BelongsToTheLaterColor()
        {
            KinectRecording recording = Recording(-20000, (RecordingMuxer.Depth, 0), (RecordingMuxer.Color, 20000));
            Assert.That(Forwards(recording), Is.EqualTo(new[] { "C20000 D0" }));
        }

        [Test]
        public void KinectRecording_BackwardsWithRarePictures_IsTheReverse()
        {
            var muxer = RecordingMuxer.WithAllTracks();
            for (short i = 0; i < 100; i++)
            {
                byte[] depth = i % 7 == 0 ? RecordingMuxer.Picture(RecordingMuxer.Depth, 10) : new byte[0];
                muxer.AddCluster((ulong)i * 33333, RecordingMuxer.Picture(RecordingMuxer.Color, 0), depth);
            }

            KinectRecording recording = Open(muxer);
            string[] forwards = Forwards(recording);
            Assert.That(forwards.Length, Is.EqualTo(100));
            var capture = new KinectCapture();
            for (int i = forwards.Length - 1; i >= 0; i--)
            {
                Assert.That(recording.TryReadPrevious(capture), Is.True);
                Assert.That(Describe(capture), Is.EqualTo(forwards[i]));
                Assert.That(capture.Index, Is.EqualTo(i));
            }

            Assert.That(recording.TryReadPrevious(capture), Is.False);
        }

        [Test]
        public void KinectRecording_TurningRound_LosesNoPicture()
        {
            var muxer = RecordingMuxer.WithAllTracks();
            for (short i = 0; i < 8; i++)
                muxer.AddCluster((ulong)i * 33333, RecordingMuxer.Picture(RecordingMuxer.Color, 0), i == 0 ? RecordingMuxer.Picture(RecordingMuxer.Depth, 5) : new byte[0]);
            KinectRecording recording = Open(muxer);
            var capture = new KinectCapture();
            for (int i = 0; i < 4; i++)
                recording.TryReadNext(capture);
            for (int i = 2; i >= 0; i--)
                Assert.That(recording.TryReadPrevious(capture), Is.True);
            Assert.That(Describe(capture), Is.EqualTo("C0 D5"));
            Assert.That(recording.TryReadNext(capture), Is.True);
            Assert.That(Describe(capture), Is.EqualTo("C33333"));
        }

        [Test]
        public void KinectRecording_SeekIntoACapture_CountsItAsTheNext()
        {
            KinectRecording recording = Recording(0, (RecordingMuxer.Depth, 0), (RecordingMuxer.Color, 4),
                (RecordingMuxer.Depth, 20000), (RecordingMuxer.Color, 20004), (RecordingMuxer.Infrared, 20008));
            var capture = new KinectCapture();
            foreach (long offset in new long[] { 20000, 20001, 20004, 20005, 20008 })
            {
                recording.Seek(offset, KinectSeekOrigin.Begin);
                recording.TryReadNext(capture);
                Assert.That(Describe(capture), Is.EqualTo("C20004 D20000 I20008"), offset + " forwards");
                recording.Seek(offset, KinectSeekOrigin.Begin);
                recording.TryReadPrevious(capture);
                Assert.That(Describe(capture), Is.EqualTo("C4 D0"), offset + " backwards");
            }
        }

        [Test]
        public void KinectRecording_LacedMotionSamples_AreAllGiven()
        {
            var muxer = RecordingMuxer.WithAllTracks();
            var laced = new List<byte> { 2 };
            for (ulong i = 0; i < 3; i++)
                laced.AddRange(RecordingMuxer.ImuSample(100 + i));
            muxer.AddCluster(0, RecordingMuxer.Picture(RecordingMuxer.Color, 0),
                RecordingMuxer.BlockGroup(RecordingMuxer.Imu, 0, 0x04, 3, laced.ToArray()),
                RecordingMuxer.SimpleBlock(RecordingMuxer.Imu, 5, 0, RecordingMuxer.ImuSample(105)));
            KinectImuReader reader = Open(muxer).CreateImuReader();
            var times = new List<ulong>();
            while (reader.TryReadNext(out ImuSample sample))
                times.Add(sample.AccelerometerTimeNs / 1000);
            Assert.That(times, Is.EqualTo(new ulong[] { 100, 101, 102, 105 }));
        }

        [Test]
        public void KinectRecording_LacedCustomFrames_ShareTheBlocksDuration()
        {
            var muxer = RecordingMuxer.WithAllTracks();
            muxer.AddCluster(0, RecordingMuxer.Picture(RecordingMuxer.Color, 0),
                RecordingMuxer.BlockGroup(RecordingMuxer.Custom, 10, 0x04, 101, new byte[] { 4, 1, 2, 3, 4, 5 }));
            KinectRecording recording = Open(muxer);
            KinectDataReader reader = recording.CreateDataReader(recording.Tracks[4]);
            var times = new List<long>();
            while (reader.TryReadNext(out KinectDataBlock data))
                times.Add(data.DeviceTimeUs);
            Assert.That(times, Is.EqualTo(new long[] { 10, 35, 60, 85, 110 }));
        }

        private static KinectRecording Recording(long depthDelayUs, params (int Track, short TimeUs)[] pictures)
        {
            var muxer = RecordingMuxer.WithAllTracks();
            muxer.AddTag("K4A_DEPTH_DELAY_NS", (depthDelayUs * 1000).ToString(System.Globalization.CultureInfo.InvariantCulture));
            var blocks = new List<byte[]>();
            foreach ((int track, short time) in pictures)
                blocks.Add(RecordingMuxer.Picture(track, time));
            muxer.AddCluster(0, blocks.ToArray());
            return Open(muxer);
        }

        private static KinectRecording Open(RecordingMuxer muxer) => new KinectRecording(new MemoryStream(muxer.ToArray()), "test");

        private static string[] Forwards(KinectRecording recording)
        {
            var captures = new List<string>();
            var capture = new KinectCapture();
            while (recording.TryReadNext(capture))
                captures.Add(Describe(capture));
            return captures.ToArray();
        }

        private static string Describe(KinectCapture capture)
        {
            string text = "";
            if (capture.Color.IsPresent)
                text += "C" + capture.Color.DeviceTimeUs + " ";
            if (capture.Depth.IsPresent)
                text += "D" + capture.Depth.DeviceTimeUs + " ";
            if (capture.Infrared.IsPresent)
                text += "I" + capture.Infrared.DeviceTimeUs + " ";
            return text.TrimEnd();
        }
    }
}
