using System;
using System.Buffers.Binary;
using LaserTracking.Capture.Matroska;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Goes through the samples of the motion sensor, from its first. Independent of the capture being read.</summary>
    public sealed class KinectImuReader
    {
        private const int SampleSize = 40;

        private readonly EbmlReader _reader;
        private readonly KinectDataReader _frames;
        private readonly ProblemLog _problems;

        internal KinectImuReader(EbmlReader reader, KinectDataReader frames, ProblemLog problems)
        {
            _reader = reader;
            _frames = frames;
            _problems = problems;
        }

        /// <summary>The next sample; false at the end. Samples of a wrong size are skipped and reported. Allocates nothing.</summary>
        public bool TryReadNext(out ImuSample sample)
        {
            Span<byte> bytes = stackalloc byte[SampleSize];
            sample = default;
            while (_frames.TryReadNext(out KinectDataBlock frame))
            {
                if (frame.SizeBytes != SampleSize || !_reader.TryRead(frame.Offset, bytes))
                {
                    if (_problems.Accepts(frame.Offset))
                        _problems.Add(frame.Offset, "a motion sample has " + frame.SizeBytes + " bytes instead of 40 and is lost");
                    continue;
                }

                sample.AccelerometerTimeNs = BinaryPrimitives.ReadUInt64LittleEndian(bytes);
                sample.AccelerationX = ReadSingle(bytes.Slice(8));
                sample.AccelerationY = ReadSingle(bytes.Slice(12));
                sample.AccelerationZ = ReadSingle(bytes.Slice(16));
                sample.GyroscopeTimeNs = BinaryPrimitives.ReadUInt64LittleEndian(bytes.Slice(20));
                sample.AngularVelocityX = ReadSingle(bytes.Slice(28));
                sample.AngularVelocityY = ReadSingle(bytes.Slice(32));
                sample.AngularVelocityZ = ReadSingle(bytes.Slice(36));
                return true;
            }

            return false;
        }

        private static float ReadSingle(ReadOnlySpan<byte> bytes) =>
            BitConverter.Int32BitsToSingle(BinaryPrimitives.ReadInt32LittleEndian(bytes));
    }
}
