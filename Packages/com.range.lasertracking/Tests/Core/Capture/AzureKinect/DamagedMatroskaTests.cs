using System;
using System.IO;
using LaserTracking.Capture.Matroska;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Structures that a tolerant reader must get over, one at a time, on recordings made in memory.</summary>
    public sealed class DamagedMatroskaTests
    {
        private const int Clusters = 6;

        [Test]
        public void KinectRecording_OpenEndedSegmentAndClusters_IsWhole()
        {
            RecordingMuxer muxer = Muxer(EbmlBuilder.SizeField.Unknown);
            muxer.SegmentSize = EbmlBuilder.SizeField.Unknown;
            AssertAll(muxer.ToArray(), Clusters, 0);
        }

        [Test]
        public void KinectRecording_VoidsAndUnknownElementsBetweenClusters_AreSkipped()
        {
            RecordingMuxer muxer = Muxer();
            muxer.BetweenClusters = EbmlBuilder.Join(EbmlBuilder.Element(MatroskaIds.Void, new byte[300]), EbmlBuilder.Element(0x1F00AA55, new byte[5]));
            AssertAll(muxer.ToArray(), Clusters, 0);
        }

        [Test]
        public void KinectRecording_SegmentSizeZeroWithoutCuesOrInfo_IsReadToTheEnd()
        {
            RecordingMuxer muxer = Muxer();
            muxer.SegmentSize = EbmlBuilder.SizeField.Zero;
            muxer.WritesCues = false;
            muxer.WritesInfo = false;
            AssertAll(muxer.ToArray(), Clusters, 1);
        }

        [Test]
        public void KinectRecording_GarbageBetweenClusters_IsSearchedOver()
        {
            RecordingMuxer muxer = Muxer();
            muxer.BetweenClusters = new byte[] { 0, 0, 1, 2, 3, 0x1F, 0x43, 0xB6, 0x75, 0, 7 };
            AssertAll(muxer.ToArray(), Clusters, Clusters);
        }

        [TestCase(EbmlBuilder.SizeField.TooLarge)]
        [TestCase(EbmlBuilder.SizeField.Huge)]
        [TestCase(EbmlBuilder.SizeField.Zero)]
        public void KinectRecording_EveryClusterSizeWrong_LosesNoCapture(EbmlBuilder.SizeField size)
        {
            KinectRecording recording = Open(Muxer(size).ToArray());
            Assert.That(Count(recording), Is.EqualTo(Clusters));
        }

        [Test]
        public void KinectRecording_BlockLargerThanItsCluster_LosesOnlyThatCluster()
        {
            RecordingMuxer muxer = Muxer();
            muxer.AddCluster(1000000, EbmlBuilder.Element(MatroskaIds.SimpleBlock, EbmlBuilder.SizeField.Huge, RecordingMuxer.Picture(RecordingMuxer.Color, 0)));
            muxer.AddCluster(1033333, RecordingMuxer.Picture(RecordingMuxer.Color, 0));
            AssertAll(muxer.ToArray(), Clusters + 1, 1);
        }

        [TestCase(EbmlBuilder.SizeField.Unknown)]
        [TestCase(EbmlBuilder.SizeField.Huge)]
        public void KinectRecording_DamageInAClusterWithoutUsableSize_LosesNoLaterCluster(EbmlBuilder.SizeField clusterSize)
        {
            RecordingMuxer muxer = Muxer();
            muxer.WritesCues = false;
            muxer.ClusterSize = clusterSize;
            muxer.AddCluster(1000000, RecordingMuxer.Picture(RecordingMuxer.Color, 0), new byte[] { 0, 0, 0, 0, 0, 0 });
            muxer.AddCluster(1033333, RecordingMuxer.Picture(RecordingMuxer.Color, 0));
            KinectRecording recording = Open(muxer.ToArray());
            Assert.That(Count(recording), Is.EqualTo(Clusters + 2));
            Assert.That(recording.IsCut, Is.False);
            Assert.That(recording.LengthUs, Is.EqualTo(1033333));
        }

        [Test]
        public void KinectRecording_ClusterWithDestroyedHead_LosesOnlyThatCluster()
        {
            RecordingMuxer muxer = Muxer();
            muxer.WritesCues = false;
            byte[] bytes = muxer.ToArray();
            int first = bytes.AsSpan().IndexOf(new byte[] { 0x1F, 0x43, 0xB6, 0x75 });
            int second = first + 4 + bytes.AsSpan(first + 4).IndexOf(new byte[] { 0x1F, 0x43, 0xB6, 0x75 });
            bytes.AsSpan(second, 12).Clear();
            KinectRecording recording = Open(bytes);
            Assert.That(Count(recording), Is.EqualTo(Clusters - 1));
            var capture = new KinectCapture();
            recording.Seek(33333, KinectSeekOrigin.Begin);
            Assert.That(recording.TryReadNext(capture), Is.True);
            Assert.That(capture.Color.DeviceTimeUs, Is.EqualTo(2 * 33333));
            Assert.That(recording.TryReadPrevious(capture), Is.True);
            Assert.That(capture.Color.DeviceTimeUs, Is.Zero);
        }

        [Test]
        public void KinectRecording_CutAnywhere_KeepsEveryWholeCapture()
        {
            byte[] bytes = Muxer().ToArray();
            byte[] block = RecordingMuxer.Picture(RecordingMuxer.Color, 0);
            for (int length = 0; length < bytes.Length; length++)
            {
                byte[] cut = bytes.AsSpan(0, length).ToArray();
                int whole = 0;
                for (int at = cut.AsSpan().IndexOf(block); at >= 0; whole++)
                {
                    int next = cut.AsSpan(at + 1).IndexOf(block);
                    at = next < 0 ? -1 : at + 1 + next;
                }

                try
                {
                    KinectRecording recording = Open(cut);
                    Assert.That(Count(recording), Is.EqualTo(whole), "cut to " + length);
                    Assert.That(recording.IsCut, Is.True);
                    Assert.That(recording.Problems, Is.Not.Empty);
                }
                catch (InputException)
                {
                    Assert.That(whole, Is.Zero, "cut to " + length);
                }
            }
        }

        [Test]
        public void KinectRecording_CuesThatPointNowhere_AreDisregarded()
        {
            RecordingMuxer muxer = Muxer();
            byte[] right = muxer.ToArray();
            muxer.BetweenClusters = EbmlBuilder.Element(MatroskaIds.Void, new byte[50]);
            byte[] bytes = muxer.ToArray();
            // The cues of the shorter file behind the clusters of the longer one.
            int cues = right.AsSpan().LastIndexOf(new byte[] { 0x1C, 0x53, 0xBB, 0x6B });
            right.AsSpan(cues).CopyTo(bytes.AsSpan(bytes.AsSpan().LastIndexOf(new byte[] { 0x1C, 0x53, 0xBB, 0x6B })));
            KinectRecording recording = Open(bytes);
            Assert.That(Count(recording), Is.EqualTo(Clusters));
            var capture = new KinectCapture();
            recording.Seek(3 * 33333, KinectSeekOrigin.Begin);
            Assert.That(recording.TryReadNext(capture), Is.True);
            Assert.That(capture.Color.DeviceTimeUs, Is.EqualTo(3 * 33333));
        }

        [Test]
        public void KinectRecording_ChangedPayload_IsReportedAndGiven()
        {
            byte[] bytes = Muxer().ToArray();
            bytes[bytes.AsSpan().IndexOf(new byte[] { 0x1F, 0x43, 0xB6, 0x75 }) + 60] ^= 1;
            KinectRecording recording = Open(bytes);
            recording.VerifiesChecksums = true;
            Assert.That(Count(recording), Is.EqualTo(Clusters));
            int mismatches = 0;
            foreach (FrameProblem problem in recording.Problems)
                mismatches += problem.What.Contains("checksum") ? 1 : 0;
            Assert.That(mismatches, Is.EqualTo(1));
        }

        [Test]
        public void KinectRecording_ManyProblems_AreBounded()
        {
            RecordingMuxer muxer = Muxer();
            for (ulong i = 0; i < 1000; i++)
                muxer.AddCluster(1000000 + i, EbmlBuilder.Element(MatroskaIds.SimpleBlock, new byte[] { 0 }));
            KinectRecording recording = Open(muxer.ToArray());
            Count(recording);
            Assert.That(recording.Problems.Count, Is.EqualTo(ProblemLog.Capacity));
        }

        [Test]
        public void KinectRecordingSource_PayloadOfWrongSize_LeavesThePictureOutAndTheFrameIn()
        {
            RecordingMuxer muxer = RecordingMuxer.WithAllTracks();
            muxer.AddCluster(0, RecordingMuxer.SimpleBlock(RecordingMuxer.Color, 0, 0x80, new byte[17]), RecordingMuxer.Picture(RecordingMuxer.Depth, 0));
            using var source = new KinectRecordingSource(Open(muxer.ToArray()));
            using var frame = new Frame();
            Assert.That(source.TryRead(frame), Is.True);
            Assert.That(frame.Color.IsPresent, Is.False);
            Assert.That(frame.Depth.IsPresent, Is.True);
            Assert.That(source.Problems[source.Problems.Count - 1].FrameIndex, Is.EqualTo(0));
            Assert.That(source.Problems[source.Problems.Count - 1].What, Does.Contain("17 bytes"));
        }

        [Test]
        public void KinectRecordingSource_BigEndianDepth_ComesLittleEndian()
        {
            RecordingMuxer muxer = RecordingMuxer.WithAllTracks();
            var payload = new byte[RecordingMuxer.Width * RecordingMuxer.Height * 2];
            for (int i = 0; i < payload.Length; i += 2)
            {
                payload[i] = (byte)(i / 2);
                payload[i + 1] = 0xAB;
            }

            muxer.AddCluster(0, RecordingMuxer.SimpleBlock(RecordingMuxer.Depth, 0, 0x80, payload));
            using var source = new KinectRecordingSource(Open(muxer.ToArray()));
            using var frame = new Frame();
            Assert.That(source.TryRead(frame), Is.True);
            for (int i = 0; i < payload.Length / 2; i++)
                Assert.That(BitConverter.ToUInt16(frame.Depth.Bytes.Slice(i * 2, 2)), Is.EqualTo((i << 8) | 0xAB));
        }

        private static RecordingMuxer Muxer(EbmlBuilder.SizeField clusterSize = EbmlBuilder.SizeField.Right)
        {
            RecordingMuxer muxer = RecordingMuxer.WithAllTracks();
            muxer.AddTag("K4A_COLOR_MODE", "NV12_8P");
            muxer.ClusterSize = clusterSize;
            muxer.WritesCues = clusterSize == EbmlBuilder.SizeField.Right || clusterSize == EbmlBuilder.SizeField.Unknown;
            for (ulong i = 0; i < Clusters; i++)
                muxer.AddCluster(i * 33333, RecordingMuxer.Picture(RecordingMuxer.Color, 0), RecordingMuxer.SimpleBlock(RecordingMuxer.Imu, 3, 0, RecordingMuxer.ImuSample(i)));
            muxer.ClusterSize = EbmlBuilder.SizeField.Right;
            return muxer;
        }

        private static void AssertAll(byte[] bytes, int captures, int problems)
        {
            KinectRecording recording = Open(bytes);
            recording.VerifiesChecksums = true;
            Assert.That(Count(recording), Is.EqualTo(captures));
            int tagProblems = 0;
            foreach (FrameProblem problem in recording.Problems)
                tagProblems += problem.What.StartsWith("tag K4A_DEPTH_MODE", StringComparison.Ordinal) ? 1 : 0;
            Assert.That(recording.Problems.Count - tagProblems, Is.EqualTo(problems));
        }

        private static KinectRecording Open(byte[] bytes) => new KinectRecording(new MemoryStream(bytes), "test");

        private static int Count(KinectRecording recording)
        {
            var capture = new KinectCapture();
            int count = 0;
            while (recording.TryReadNext(capture))
                count++;
            return count;
        }
    }
}
