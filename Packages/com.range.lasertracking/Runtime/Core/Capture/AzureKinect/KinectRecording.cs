using System;
using System.Collections.Generic;
using System.IO;
using LaserTracking.Capture.Matroska;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// A recording made with an Azure Kinect or Orbbec Femto camera (.mkv). Reads captures forwards and backwards, seeks by time,
    /// and gives payloads, motion samples and custom tracks on demand; about 150 KiB of memory whatever the file's size. Reads over
    /// damage and lists it in <see cref="Problems"/>. One thread at a time.
    /// </summary>
    public sealed class KinectRecording : IDisposable
    {
        private const int Color = 0;
        private const int Depth = 1;
        private const int Infrared = 2;
        private const long MaxSeekUs = 1L << 50;

        private readonly Stream _stream;
        private readonly bool _leaveOpen;
        private readonly ProblemLog _problems = new ProblemLog();
        private readonly MatroskaFile _file;
        private readonly KinectConfigurationReader _configuration;
        private readonly CaptureAssembler _assembler;
        private readonly BlockLacing _lacing = new BlockLacing();

        /// <param name="stream">Seekable and readable; its length must not change.</param>
        /// <param name="name">For messages: the file as the user named it.</param>
        /// <param name="leaveOpen">Leave the stream to the caller when this is disposed.</param>
        /// <exception cref="InputException">Not a recording, or nothing of it can be used.</exception>
        public KinectRecording(Stream stream, string name, bool leaveOpen = false)
        {
            _stream = stream;
            _leaveOpen = leaveOpen;
            Name = name;
            _file = new MatroskaFile(stream, name, _problems);
            _configuration = new KinectConfigurationReader(_file, _problems);
            _configuration.Read();
            if (ColorTrack == null && DepthTrack == null && InfraredTrack == null && ImuTrack == null)
            {
                throw new InputException(name, "a Matroska file, but not an Azure Kinect recording (no track COLOR, DEPTH, IR or IMU)",
                    "give a recording of a depth camera, or read it as a video");
            }

            KinectTrack?[] tracks = { ColorTrack, DepthTrack, InfraredTrack };
            long delay = _configuration.DepthDelayNs;
            _assembler = new CaptureAssembler(
                Array.ConvertAll(tracks, track => track == null ? null : _file.CreateCursor(track.Source.Number)),
                new[] { Math.Max(0, delay), Math.Max(0, -delay), Math.Max(0, -delay) },
                Configuration.FramePeriodNs);
            _assembler.Seek(0);
        }

        internal MatroskaFile File => _file;

        public string Name { get; }

        /// <summary>What was found damaged so far, at most <see cref="ProblemLog.Capacity"/> entries; grows while the recording is read.</summary>
        public IReadOnlyList<FrameProblem> Problems => _problems.Problems;

        public KinectRecordConfiguration Configuration => _configuration.Configuration;

        /// <summary>Colour, depth, infrared, motion as far as they exist, then custom tracks in file order.</summary>
        public IReadOnlyList<KinectTrack> Tracks => _configuration.Tracks;

        public KinectTrack? ColorTrack => _configuration.Color;

        public KinectTrack? DepthTrack => _configuration.Depth;

        public KinectTrack? InfraredTrack => _configuration.Infrared;

        public KinectTrack? ImuTrack => _configuration.Imu;

        /// <summary>All tags in file order.</summary>
        public IReadOnlyList<MatroskaTag> Tags => _file.Tags;

        public IReadOnlyList<MatroskaAttachment> Attachments => _file.Attachments;

        /// <summary>Null when it was recorded without a device.</summary>
        public string? DeviceSerialNumber => Tag("K4A_DEVICE_SERIAL_NUMBER");

        public string? ColorFirmwareVersion => Tag("K4A_COLOR_FIRMWARE_VERSION");

        public string? DepthFirmwareVersion => Tag("K4A_DEPTH_FIRMWARE_VERSION");

        /// <summary>From the first block to the end of the last one, in microseconds.</summary>
        public long LengthUs => _file.LastTimeNs / 1000;

        /// <summary>The end of the recording is missing.</summary>
        public bool IsCut => _file.IsCut;

        /// <summary>
        /// Checks the CRC-32 of each cluster that is entered; a mismatch becomes a problem and marks its pictures. Costs reading
        /// everything once more, wanted or not. Off until set.
        /// </summary>
        public bool VerifiesChecksums
        {
            get => _file.Clusters.VerifiesChecksums;
            set => _file.Clusters.VerifiesChecksums = value;
        }

        /// <exception cref="InputException">The file cannot be opened, or nothing of it can be used.</exception>
        public static KinectRecording Open(string path)
        {
            Stream stream = RecordingStream.Open(path);
            try
            {
                return new KinectRecording(stream, path);
            }
            catch
            {
                stream.Dispose();
                throw;
            }
        }

        /// <summary>The first tag of a name, or null.</summary>
        public string? Tag(string name) => _configuration.Tag(name);

        /// <summary>The bytes of an attachment.</summary>
        public bool TryReadAttachment(MatroskaAttachment attachment, out byte[] bytes)
        {
            bytes = Array.Empty<byte>();
            if (attachment.Size > int.MaxValue || attachment.Size > _file.Reader.Length)
                return false;
            var content = new byte[attachment.Size];
            if (!_file.Reader.TryRead(attachment.DataOffset, content))
                return false;
            bytes = content;
            return true;
        }

        /// <summary>The device's calibration.json as stored, found by its tag, else by its name. False when there is none.</summary>
        public bool TryReadCalibration(out byte[] json)
        {
            json = Array.Empty<byte>();
            MatroskaAttachment? found = null;
            foreach (MatroskaTag tag in Tags)
            {
                if (tag.Name != "K4A_CALIBRATION_FILE" || tag.AttachmentUid == 0)
                    continue;
                foreach (MatroskaAttachment attachment in Attachments)
                    found ??= attachment.Uid == tag.AttachmentUid ? attachment : null;
            }

            foreach (MatroskaAttachment attachment in Attachments)
                found ??= attachment.Name == "calibration.json" ? attachment : null;
            return found != null && TryReadAttachment(found, out json);
        }

        /// <summary>The next capture in order of time; false at the end. Reads no payload and allocates nothing.</summary>
        public bool TryReadNext(KinectCapture capture) => Fill(capture, _assembler.TryNext());

        /// <summary>The capture before the one read last; false at the beginning.</summary>
        public bool TryReadPrevious(KinectCapture capture) => Fill(capture, _assembler.TryPrevious());

        /// <summary>
        /// Goes to a time: the next capture read is the first that reaches it or lies behind it, the previous one the last wholly
        /// before it. Times outside the recording go to its ends.
        /// </summary>
        public void Seek(long offsetUs, KinectSeekOrigin origin)
        {
            if (origin == KinectSeekOrigin.DeviceTime)
                offsetUs = Math.Max(0, offsetUs) - Configuration.StartOffsetUs;
            long offsetNs = Math.Max(-MaxSeekUs, Math.Min(MaxSeekUs, offsetUs)) * 1000;
            if (origin == KinectSeekOrigin.End)
                offsetNs += _file.LastTimeNs + 1;
            _assembler.Seek(Math.Max(0, offsetNs));
        }

        /// <summary>Goes to the first capture, where the index is known again.</summary>
        public void SeekToStart() => _assembler.Seek(0);

        /// <summary>Copies a picture's payload, 16-bit samples little-endian. False when the destination has another size or reading fails.</summary>
        public bool TryReadPayload(in KinectImage image, Span<byte> destination)
        {
            if (!image.IsPresent || destination.Length != image.SizeBytes || !_file.Reader.TryRead(image.Offset, destination))
                return false;
            if (image.Track!.IsBigEndian)
                ByteOrder.Swap16(destination);
            return true;
        }

        /// <summary>Copies the payload of a custom track's frame.</summary>
        public bool TryReadPayload(in KinectDataBlock data, Span<byte> destination) =>
            destination.Length == data.SizeBytes && _file.Reader.TryRead(data.Offset, destination);

        /// <summary>A reader over the motion samples; over none when there is no such track.</summary>
        public KinectImuReader CreateImuReader() =>
            new KinectImuReader(_file.Reader, CreateReader(ImuTrack?.Source.Number ?? long.MaxValue), _problems);

        /// <summary>A reader over the frames of a track.</summary>
        public KinectDataReader CreateDataReader(KinectTrack track) => CreateReader(track.Source.Number);

        public void Dispose()
        {
            if (!_leaveOpen)
                _stream.Dispose();
        }

        internal void Report(long offset, string what, int frameIndex) => _problems.Add(offset, what, frameIndex);

        internal bool AcceptsProblem(long offset) => _problems.Accepts(offset);

        private KinectDataReader CreateReader(long number) =>
            new KinectDataReader(_file.Reader, _file.CreateCursor(number), _problems, Configuration.StartOffsetUs);

        private bool Fill(KinectCapture capture, bool hasCapture)
        {
            capture.Clear();
            if (!hasCapture)
                return false;
            capture.Index = _assembler.Index;
            capture.Color = CreateImage(Color, ColorTrack);
            capture.Depth = CreateImage(Depth, DepthTrack);
            capture.Infrared = CreateImage(Infrared, InfraredTrack);
            return true;
        }

        private KinectImage CreateImage(int slot, KinectTrack? track)
        {
            if (track == null || !_assembler.TryGetBlock(slot, out MatroskaBlock block))
                return default;
            bool isWhole = _lacing.TrySplit(_file.Reader, block) && _lacing.Count == 1;
            if (!isWhole && _problems.Accepts(block.ElementOffset))
                _problems.Add(block.ElementOffset, "a picture of track " + track.Name + " is stored in a way no recorder does (lacing); it may be incomplete", _assembler.Index);
            bool hasFrame = _lacing.Count > 0;
            return new KinectImage(track, block.TimeNs / 1000 + Configuration.StartOffsetUs,
                hasFrame ? _lacing.OffsetOf(0) : block.PayloadOffset, hasFrame ? _lacing.SizeOf(0) : block.PayloadSize, block.IsSuspect);
        }
    }
}
