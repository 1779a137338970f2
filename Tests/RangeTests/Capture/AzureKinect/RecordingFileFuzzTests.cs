using System.IO;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>The fuzzing of the in-memory recordings again, on recordings of the genuine recorder: larger clusters, attachments, cues.</summary>
    [Category("Reference")]
    public sealed class RecordingFileFuzzTests
    {
        [TestCase("rec_small.mkv", 600)]
        [TestCase("rec_small_remuxed.mkv", 300)]
        [TestCase("bad_corrupt_block_size.mkv", 100)]
        [TestCase("bad_truncated_mid_cluster.mkv", 200)]
        [TestCase("bad_truncated_header.mkv", 100)]
        [TestCase("bad_unflushed.mkv", 100)]
        [TestCase("rec_large_offset.mkv", 600)]
        public void KinectRecording_DamagedFurther_IsSurvived(string name, int files)
        {
            var mutator = new RecordingMutator(File.ReadAllBytes(TestFiles.Reference("k4a", name)));
            var exerciser = new RecordingExerciser(KinectStreams.Depth | KinectStreams.Infrared);
            for (int seed = 0; seed < files; seed++)
                exerciser.Run(mutator.Mutate(seed), name + " seed " + seed);
            TestContext.Out.WriteLine(exerciser.Opened + " opened, " + exerciser.Captures + " captures, slowest " + exerciser.Slowest.TotalMilliseconds + " ms");
        }
    }
}
