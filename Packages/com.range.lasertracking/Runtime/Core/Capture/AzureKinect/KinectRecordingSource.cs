using System;
using System.Collections.Generic;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// Frames of a recording. Colour comes as it was recorded (NV12, YUY2, BGRA) or as <see cref="JpegDecoder"/> gives it; depth and infrared
    /// little-endian; of a recorded part of the camera's picture the rest is black. A picture whose payload has the wrong size or cannot be decoded is absent and a problem; its frame stays.
    /// </summary>
    public sealed class KinectRecordingSource : IFrameSource
    {
        private const int MaxJpegHeader = 1 << 16;

        private readonly KinectRecording _recording;
        private readonly KinectStreams _streams;
        private JpegDecoder? _jpegDecoder;
        private readonly KinectCapture _capture = new KinectCapture();
        private readonly Image _part = new Image();
        private byte[] _jpeg = Array.Empty<byte>();

        /// <param name="recording">Read from where it stands; disposed with this source.</param>
        /// <param name="streams">The pictures to deliver; others are not read.</param>
        public KinectRecordingSource(KinectRecording recording, KinectStreams streams = KinectStreams.All)
        {
            _recording = recording;
            _streams = streams;
            KinectTrack? track = ((streams & KinectStreams.Color) != 0 ? recording.ColorTrack : null)
                ?? ((streams & KinectStreams.Depth) != 0 ? recording.DepthTrack : null)
                ?? ((streams & KinectStreams.Infrared) != 0 ? recording.InfraredTrack : null);
            PixelRegion? region = track == recording.ColorTrack ? recording.Configuration.ColorRegion : null;
            Info = new FrameSourceInfo(recording.Name, region?.FullWidth ?? track?.Width ?? 0, region?.FullHeight ?? track?.Height ?? 0, recording.Configuration.FramesPerSecond, recording.LengthUs);
        }

        public FrameSourceInfo Info { get; }

        public IReadOnlyList<FrameProblem> Problems => _recording.Problems;

        /// <summary>The recording, for its calibration, configuration and seeking.</summary>
        public KinectRecording Recording => _recording;

        /// <summary>
        /// Fills the next capture's pictures. <see cref="Frame.TimeUs"/> is that of the first wanted picture in the order colour,
        /// depth, infrared. A capture without any wanted picture is an empty frame, so that indices stay those of the recording.
        /// </summary>
        public bool TryRead(Frame frame)
        {
            if (!_recording.TryReadNext(_capture))
                return false;
            frame.Begin(_capture.Index, FirstWantedTime());
            if ((_streams & KinectStreams.Color) != 0)
                ReadImage(_capture.Color, frame.Color);
            if ((_streams & KinectStreams.Depth) != 0)
                ReadImage(_capture.Depth, frame.Depth);
            if ((_streams & KinectStreams.Infrared) != 0)
                ReadImage(_capture.Infrared, frame.Infrared);
            return true;
        }

        /// <summary>Passes over captures without reading their pictures, until the next frame has this index. False when the recording ends before.</summary>
        public bool TrySkipTo(int index)
        {
            if (_capture.Index < 0 || _capture.Index >= index)
            {
                _recording.SeekToStart();
                _capture.Clear();
            }

            while (_capture.Index < index - 1)
            {
                if (!_recording.TryReadNext(_capture))
                    return false;
            }

            return true;
        }

        public void Dispose()
        {
            _recording.Dispose();
            _part.Dispose();
        }

        private long FirstWantedTime()
        {
            if ((_streams & KinectStreams.Color) != 0 && _capture.Color.IsPresent)
                return _capture.Color.DeviceTimeUs;
            if ((_streams & KinectStreams.Depth) != 0 && _capture.Depth.IsPresent)
                return _capture.Depth.DeviceTimeUs;
            if ((_streams & KinectStreams.Infrared) != 0 && _capture.Infrared.IsPresent)
                return _capture.Infrared.DeviceTimeUs;
            return _capture.DeviceTimeUs;
        }

        private void ReadImage(in KinectImage source, Image target)
        {
            if (!source.IsPresent)
                return;
            KinectTrack track = source.Track!;
            PixelRegion? region = track == _recording.ColorTrack ? _recording.Configuration.ColorRegion : null;
            Image read = region == null ? target : _part;
            string? problem = track.Format switch
            {
                KinectImageFormat.Unknown => "",
                KinectImageFormat.Mjpg => ReadJpeg(source, read),
                _ => ReadRaw(source, read),
            };
            if (problem == null)
            {
                region?.Restore(_part, target);
                return;
            }

            target.Clear();
            if (problem.Length > 0 && _recording.AcceptsProblem(source.Offset))
                _recording.Report(source.Offset, track.Name + " picture is missing: " + problem, _capture.Index);
        }

        private string? ReadRaw(in KinectImage source, Image target)
        {
            KinectTrack track = source.Track!;
            PixelFormat format = KinectImageFormats.PixelFormatOf(track.Format);
            long size = Image.TightSize(format, track.Width, track.Height);
            if (size == 0 || size != source.SizeBytes)
            {
                // The message is only built when it will be kept: a damaged recording must not allocate with every frame.
                return _recording.AcceptsProblem(source.Offset)
                    ? "its payload has " + source.SizeBytes + " bytes, " + track.Width + "×" + track.Height + " " + track.Format + " needs " + size
                    : "";
            }

            target.Reset(format, track.Width, track.Height, source.DeviceTimeUs);
            return _recording.TryReadPayload(source, target.Bytes) ? null : "its payload cannot be read";
        }

        private string? ReadJpeg(in KinectImage source, Image target)
        {
            KinectTrack track = source.Track!;
            if (source.SizeBytes > (long)track.Width * track.Height * 4 + MaxJpegHeader)
                return "its JPEG is larger than the raw picture";
            if (_jpeg.Length < source.SizeBytes)
                _jpeg = new byte[source.SizeBytes + source.SizeBytes / 4];
            Span<byte> jpeg = _jpeg.AsSpan(0, source.SizeBytes);
            if (!_recording.TryReadPayload(source, jpeg))
                return "its payload cannot be read";
            _jpegDecoder ??= new JpegDecoder();
            if (!_jpegDecoder.TryDecode(jpeg, target, source.DeviceTimeUs, out string problem))
                return problem;
            if (target.Width == track.Width && target.Height == track.Height)
                return null;
            return _recording.AcceptsProblem(source.Offset)
                ? "its JPEG has " + target.Width + "×" + target.Height + " pixels, the track " + track.Width + "×" + track.Height
                : "";
        }
    }
}
