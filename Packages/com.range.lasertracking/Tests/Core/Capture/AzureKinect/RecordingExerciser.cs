using System;
using System.Diagnostics;
using System.IO;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Does with a damaged recording everything that can be done with one, and watches time, memory and exceptions.</summary>
    internal sealed class RecordingExerciser
    {
        /// <summary>What opening and reading costs for any file: pages, caches, tables, at most 200 problems.</summary>
        private const long FixedAllocation = 300000;

        private static readonly TimeSpan Limit = TimeSpan.FromSeconds(1);

        private readonly KinectCapture _capture = new KinectCapture();
        private readonly Frame _frame = new Frame();
        private readonly KinectStreams _streams;

        /// <param name="streams">Pictures to read; without colour where decoding its JPEGs would take the test's time.</param>
        public RecordingExerciser(KinectStreams streams) => _streams = streams;

        /// <summary>Number of files that could be opened.</summary>
        public int Opened { get; private set; }

        public long Captures { get; private set; }

        public TimeSpan Slowest { get; private set; }

        /// <summary>A file that seems to take too long is tried once more: other work on the machine is no hang.</summary>
        public void Run(byte[] bytes, string what)
        {
            TimeSpan time = RunOnce(bytes, what);
            if (time > Limit)
                time = RunOnce(bytes, what);
            if (time > Limit)
                Assert.Fail(what + ": took " + time);
            if (time > Slowest)
                Slowest = time;
        }

        private TimeSpan RunOnce(byte[] bytes, string what)
        {
            var watch = Stopwatch.StartNew();
            long before = GC.GetAllocatedBytesForCurrentThread();
            try
            {
                using var recording = new KinectRecording(new MemoryStream(bytes), "fuzz");
                ReadEverything(recording, bytes.Length, what);
                Opened++;
            }
            catch (InputException exception)
            {
                Assert.That(exception.Message.Contains("\n"), Is.False, what);
            }
            catch (Exception exception) when (!(exception is AssertionException))
            {
                Assert.Fail(what + ": " + exception);
            }

            long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
            watch.Stop();
            if (allocated > 4L * bytes.Length + FixedAllocation)
                Assert.Fail(what + ": " + allocated + " bytes allocated for a file of " + bytes.Length);
            return watch.Elapsed;
        }

        private void ReadEverything(KinectRecording recording, int fileSize, string what)
        {
            recording.VerifiesChecksums = true;
            using var source = new KinectRecordingSource(recording, _streams);
            int most = fileSize / 6 + 1;
            int count = 0;
            while (source.TryRead(_frame))
            {
                Captures++;
                if (++count > most)
                    Assert.Fail(what + ": more captures than blocks fit into the file");
                if (_frame.Color.SizeBytes + _frame.Depth.SizeBytes + _frame.Infrared.SizeBytes > 3L * fileSize)
                    Assert.Fail(what + ": pictures larger than the file");
            }

            recording.VerifiesChecksums = false;
            for (int back = 0; recording.TryReadPrevious(_capture); back++)
            {
                if (back > most)
                    Assert.Fail(what + ": going back does not end");
            }

            for (int step = -1; step <= 4; step++)
            {
                recording.Seek(recording.LengthUs / 4 * step, KinectSeekOrigin.Begin);
                recording.TryReadPrevious(_capture);
                recording.TryReadNext(_capture);
                recording.TryReadNext(_capture);
            }

            recording.Seek(long.MinValue, KinectSeekOrigin.End);
            recording.Seek(long.MaxValue, KinectSeekOrigin.DeviceTime);
            recording.TryReadPrevious(_capture);
            KinectImuReader imu = recording.CreateImuReader();
            while (imu.TryReadNext(out _))
            {
            }

            foreach (KinectTrack track in recording.Tracks)
            {
                if (track.IsBuiltin)
                    continue;
                KinectDataReader data = recording.CreateDataReader(track);
                while (data.TryReadNext(out _))
                {
                }

                break;
            }

            recording.TryReadCalibration(out _);
        }
    }
}
