using System.Collections.Generic;
using System.IO;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>What tracks and tags mean, on recordings made in memory.</summary>
    public sealed class KinectConfigurationTests
    {
        [Test]
        public void KinectRecording_TrackTags_OutweighNames()
        {
            var muxer = new RecordingMuxer();
            muxer.AddVideo(RecordingMuxer.Color, "DEPTH", "NV12");
            muxer.AddVideo(RecordingMuxer.Depth, "COLOR", "b16g", 33333333, 640, 576);
            muxer.AddTag("K4A_COLOR_TRACK", (RecordingMuxer.Color + 1000).ToString());
            muxer.AddTag("K4A_DEPTH_TRACK", (RecordingMuxer.Depth + 1000).ToString());
            muxer.AddTag("K4A_DEPTH_MODE", "NFOV_UNBINNED");
            KinectRecording recording = Open(muxer);
            Assert.That(recording.ColorTrack!.Format, Is.EqualTo(KinectImageFormat.Nv12));
            Assert.That(recording.DepthTrack!.Format, Is.EqualTo(KinectImageFormat.Depth16));
            Assert.That(recording.Configuration.DepthMode, Is.EqualTo(KinectDepthMode.NfovUnbinned));
            Assert.That(recording.Problems, Is.Empty);
        }

        [Test]
        public void KinectRecording_EarlyNames_AreUnderstood()
        {
            var muxer = new RecordingMuxer();
            muxer.AddVideo(RecordingMuxer.Infrared, "DEPTH_IR", "YUY2", 66666666, 320, 288);
            muxer.AddVideo(RecordingMuxer.Depth, "DEPTH", "YUY2", 66666666, 320, 288);
            muxer.AddTag("K4A_DEPTH_MODE", "NFOV_2x2BINNED");
            var payload = new byte[320 * 288 * 2];
            payload[0] = 1;
            muxer.AddCluster(0, RecordingMuxer.SimpleBlock(RecordingMuxer.Depth, 0, 0x80, payload));
            KinectRecording recording = Open(muxer, addCluster: false);
            Assert.That(recording.InfraredTrack!.Name, Is.EqualTo("IR"));
            Assert.That(recording.InfraredTrack!.Format, Is.EqualTo(KinectImageFormat.Ir16));
            Assert.That(recording.Configuration.FramesPerSecond, Is.EqualTo(15));
            Assert.That(recording.Configuration.DepthMode, Is.EqualTo(KinectDepthMode.Nfov2x2Binned));
            Assert.That(recording.Problems, Is.Empty);
            var capture = new KinectCapture();
            Assert.That(recording.TryReadNext(capture), Is.True);
            var read = new byte[payload.Length];
            Assert.That(recording.TryReadPayload(capture.Depth, read), Is.True);
            Assert.That(read[0], Is.EqualTo(1), "early recordings hold little-endian samples");
        }

        [Test]
        public void KinectRecording_TagsThatContradictTheTracks_AreReportedAndTheTracksCount()
        {
            RecordingMuxer muxer = new RecordingMuxer();
            muxer.AddVideo(RecordingMuxer.Color, "COLOR", "NV12", 33333333, 1280, 720);
            muxer.AddVideo(RecordingMuxer.Depth, "DEPTH", "b16g", 66666666, 512, 512);
            muxer.AddTag("K4A_COLOR_MODE", "MJPG_1080P");
            muxer.AddTag("K4A_DEPTH_MODE", "NFOV_UNBINNED");
            muxer.AddTag("K4A_WIRED_SYNC_MODE", "LORD");
            muxer.AddTag("K4A_DEPTH_DELAY_NS", "soon\n");
            muxer.AddTag("K4A_START_OFFSET_NS", "99999999999999999999999");
            KinectRecording recording = Open(muxer);
            KinectRecordConfiguration configuration = recording.Configuration;
            Assert.That(configuration.ColorFormat, Is.EqualTo(KinectImageFormat.Nv12));
            Assert.That(configuration.DepthMode, Is.EqualTo(KinectDepthMode.Wfov2x2Binned));
            Assert.That(configuration.WiredSyncMode, Is.EqualTo(KinectWiredSyncMode.Standalone));
            Assert.That(configuration.DepthDelayOffColorUs, Is.Zero);
            Assert.That(configuration.StartOffsetUs, Is.Zero);
            Assert.That(configuration.FramesPerSecond, Is.EqualTo(30));
            var texts = new List<string>();
            foreach (FrameProblem problem in recording.Problems)
            {
                texts.Add(problem.What);
                Assert.That(problem.What, Does.Not.Contain("\n"));
            }

            foreach (string expected in new[] { "K4A_COLOR_MODE", "K4A_DEPTH_MODE", "K4A_WIRED_SYNC_MODE", "K4A_DEPTH_DELAY_NS", "K4A_START_OFFSET_NS", "frame period" })
                Assert.That(texts, Has.Some.Contains(expected));
            Assert.That(texts.Count, Is.EqualTo(6));
        }

        [Test]
        public void KinectRecording_StartOffsetBeyond32Bits_IsKept()
        {
            RecordingMuxer muxer = RecordingMuxer.WithAllTracks();
            muxer.AddTag("K4A_START_OFFSET_NS", "1730796756988167000");
            KinectRecording recording = Open(muxer);
            var capture = new KinectCapture();
            recording.TryReadNext(capture);
            Assert.That(capture.DeviceTimeUs, Is.EqualTo(1730796756988167));
            recording.Seek(1730796756988167, KinectSeekOrigin.DeviceTime);
            Assert.That(recording.TryReadNext(capture), Is.True);
            Assert.That(capture.DeviceTimeUs, Is.EqualTo(1730796756988167));
        }

        [Test]
        public void KinectRecording_CalibrationUnderAnotherName_IsFoundByItsTag()
        {
            RecordingMuxer muxer = RecordingMuxer.WithAllTracks();
            muxer.AddAttachment("notes.txt", 7, new byte[] { 1 });
            muxer.AddAttachment("device.json", 8, new byte[] { 2, 3 });
            muxer.AddTag("K4A_CALIBRATION_FILE", "device.json", 8);
            Assert.That(Open(muxer).TryReadCalibration(out byte[] json), Is.True);
            Assert.That(json, Is.EqualTo(new byte[] { 2, 3 }));
        }

        [Test]
        public void KinectRecording_CalibrationWithoutTag_IsFoundByItsName()
        {
            RecordingMuxer muxer = RecordingMuxer.WithAllTracks();
            muxer.AddAttachment("calibration.json", 8, new byte[] { 4 });
            Assert.That(Open(muxer).TryReadCalibration(out byte[] json), Is.True);
            Assert.That(json, Is.EqualTo(new byte[] { 4 }));
        }

        [Test]
        public void KinectRecording_MatroskaWithoutCameraTracks_IsRefusedInOneLine()
        {
            var muxer = new RecordingMuxer();
            muxer.AddVideo(1, "Holiday", "MJPG");
            InputException? exception = Assert.Throws<InputException>(() => Open(muxer));
            Assert.That(exception!.Message, Does.Contain("not an Azure Kinect recording"));
        }

        private static KinectRecording Open(RecordingMuxer muxer, bool addCluster = true)
        {
            if (addCluster)
                muxer.AddCluster(0, RecordingMuxer.Picture(RecordingMuxer.Color, 0));
            return new KinectRecording(new MemoryStream(muxer.ToArray()), "test");
        }
    }
}
