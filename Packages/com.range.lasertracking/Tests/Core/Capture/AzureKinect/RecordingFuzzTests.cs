using System.Collections.Generic;
using LaserTracking.Capture.Matroska;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Thousands of damaged recordings: none may crash, hang, or make the reader take more memory than the file could justify.</summary>
    public sealed class RecordingFuzzTests
    {
        private const int FilesPerKind = 5000;

        [TestCase(EbmlBuilder.SizeField.Right, EbmlBuilder.SizeField.Right, false)]
        [TestCase(EbmlBuilder.SizeField.Unknown, EbmlBuilder.SizeField.Unknown, false)]
        [TestCase(EbmlBuilder.SizeField.Zero, EbmlBuilder.SizeField.Right, true)]
        [TestCase(EbmlBuilder.SizeField.Right, EbmlBuilder.SizeField.TooLarge, true)]
        [Category("Long")]
        public void KinectRecording_ThousandsOfDamagedFiles_AreSurvived(EbmlBuilder.SizeField segmentSize, EbmlBuilder.SizeField clusterSize, bool isUnfinished)
        {
            var mutator = new RecordingMutator(Create(segmentSize, clusterSize, isUnfinished));
            var exerciser = new RecordingExerciser(KinectStreams.All);
            for (int seed = 0; seed < FilesPerKind; seed++)
                exerciser.Run(mutator.Mutate(seed), "seed " + seed);

            // Damage that stops everything would make this test prove nothing.
            Assert.That(exerciser.Opened, Is.GreaterThan(FilesPerKind / 2));
            Assert.That(exerciser.Captures, Is.GreaterThan(FilesPerKind));
            TestContext.WriteLine(exerciser.Opened + " opened, " + exerciser.Captures + " captures, slowest " + exerciser.Slowest.TotalMilliseconds + " ms");
        }

        private static byte[] Create(EbmlBuilder.SizeField segmentSize, EbmlBuilder.SizeField clusterSize, bool isUnfinished)
        {
            RecordingMuxer muxer = RecordingMuxer.WithAllTracks();
            muxer.SegmentSize = segmentSize;
            muxer.ClusterSize = clusterSize;
            muxer.WritesCues = !isUnfinished;
            muxer.WritesInfo = !isUnfinished;
            muxer.AddTag("K4A_DEPTH_MODE", "NFOV_UNBINNED");
            muxer.AddTag("K4A_DEPTH_DELAY_NS", "-160000");
            muxer.AddTag("K4A_START_OFFSET_NS", "5000000000");
            for (ulong i = 0; i < 5; i++)
            {
                var laced = new List<byte> { 2 };
                for (ulong sample = 0; sample < 3; sample++)
                    laced.AddRange(RecordingMuxer.ImuSample(i * 33333 + sample));
                muxer.AddCluster(i * 33333,
                    RecordingMuxer.Picture(RecordingMuxer.Color, 160),
                    RecordingMuxer.Picture(RecordingMuxer.Depth, 0),
                    i % 2 == 0 ? RecordingMuxer.Picture(RecordingMuxer.Infrared, 0) : new byte[0],
                    RecordingMuxer.BlockGroup(RecordingMuxer.Imu, 0, 0x04, 3, laced.ToArray()),
                    RecordingMuxer.BlockGroup(RecordingMuxer.Custom, 10, 0x06, 100, new byte[] { 2, 0x83, 0xBD, 1, 1, 1, 2, 3, 3 }),
                    RecordingMuxer.BlockGroup(RecordingMuxer.Custom, 20, 0x02, 100, new byte[] { 2, 1, 2, 1, 2, 2, 3, 3, 3 }));
            }

            return muxer.ToArray();
        }
    }
}
