using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Threading;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Host.Sessions;

namespace LaserTracking.Host.Recordings
{
    /// <summary>
    /// Takes a recording apart: one file per payload and one line each in frames.jsonl, in order of captures (colour, depth, infrared),
    /// then the custom tracks. Every file gets its name only when it is whole.
    /// </summary>
    internal sealed class RecordingExtractor
    {
        private readonly KinectRecording _recording;
        private readonly ExtractOptions _options;
        private readonly FrameListWriter _lines = new();
        private byte[] _payload = Array.Empty<byte>();
        private long _bytes;
        private long _firstTimeUs = long.MaxValue;
        private long _lastTimeUs = long.MinValue;

        public RecordingExtractor(KinectRecording recording, ExtractOptions options)
        {
            _recording = recording;
            _options = options;
        }

        /// <param name="progress">Called after each capture with the share that is done, 0 to 1.</param>
        /// <param name="cancellation">Ends the work early; what was finished is kept and listed.</param>
        /// <exception cref="InputException">The folder cannot be written to, or the recording has no such captures.</exception>
        public ExtractResult Run(Action<double>? progress = null, CancellationToken cancellation = default)
        {
            try
            {
                return Write(progress, cancellation);
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
            {
                throw new InputException(_options.OutputFolder, "cannot be written to (" + exception.Message.ReplaceLineEndings(" ") + ")",
                    "give a folder that can be written to, with enough room");
            }
        }

        private ExtractResult Write(Action<double>? progress, CancellationToken cancellation)
        {
            using var list = new ResultFile(Path.Combine(_options.OutputFolder, "frames.jsonl"));
            long captures = WriteCaptures(list.Stream, progress, cancellation);
            if (captures == 0 && !cancellation.IsCancellationRequested && _options.HasRange)
                throw new InputException(_recording.Name, $"has no capture {_options.FirstCapture}", "ask for captures that it has; info tells their number");
            foreach (KinectTrack track in _recording.Tracks.Where(track => !track.IsBuiltin))
                WriteCustomTrack(list.Stream, track, cancellation);
            list.Commit();
            return new ExtractResult(captures, _lines.Count, _bytes, cancellation.IsCancellationRequested);
        }

        private long WriteCaptures(Stream list, Action<double>? progress, CancellationToken cancellation)
        {
            var capture = new KinectCapture();
            long captures = 0;
            _recording.SeekToStart();
            while (!cancellation.IsCancellationRequested && _recording.TryReadNext(capture) && capture.Index <= _options.LastCapture)
            {
                if (capture.Index < _options.FirstCapture)
                    continue;
                captures++;
                WriteImage(list, capture.Index, capture.Color);
                WriteImage(list, capture.Index, capture.Depth);
                WriteImage(list, capture.Index, capture.Infrared);
                if (progress != null && _recording.LengthUs > 0)
                    progress(Math.Clamp((capture.DeviceTimeUs - _recording.Configuration.StartOffsetUs) / (double)_recording.LengthUs, 0, 1));
            }

            return captures;
        }

        private void WriteImage(Stream list, int index, in KinectImage image)
        {
            if (!image.IsPresent)
                return;
            _firstTimeUs = Math.Min(_firstTimeUs, image.DeviceTimeUs);
            _lastTimeUs = Math.Max(_lastTimeUs, image.DeviceTimeUs);
            KinectTrack track = image.Track!;
            Span<byte> payload = Room(image.SizeBytes);
            if (_recording.TryReadPayload(image, payload))
                WritePayload(list, index, track, image.DeviceTimeUs, payload, $"capture-{index:D6}-{track.Name}{RecordingFormats.ExtensionOf(track)}");
        }

        /// <summary>All frames of a custom track, or those within the times of the captures that were asked for.</summary>
        private void WriteCustomTrack(Stream list, KinectTrack track, CancellationToken cancellation)
        {
            KinectDataReader reader = _recording.CreateDataReader(track);
            string stem = FileStem(track);
            for (int index = 0; !cancellation.IsCancellationRequested && reader.TryReadNext(out KinectDataBlock data); index++)
            {
                if (_options.HasRange && (data.DeviceTimeUs < _firstTimeUs || data.DeviceTimeUs > _lastTimeUs))
                    continue;
                Span<byte> payload = Room(data.SizeBytes);
                if (_recording.TryReadPayload(data, payload))
                    WritePayload(list, null, track, data.DeviceTimeUs, payload, $"{stem}-{index:D6}.bin");
            }
        }

        private void WritePayload(Stream list, int? capture, KinectTrack track, long timeUs, ReadOnlySpan<byte> payload, string fileName)
        {
            Span<byte> hash = stackalloc byte[SHA256.HashSizeInBytes];
            SHA256.HashData(payload, hash);
            if (!_options.HashesOnly)
            {
                using var file = new ResultFile(Path.Combine(_options.OutputFolder, fileName));
                file.Stream.Write(payload);
                file.Commit();
            }

            _bytes += payload.Length;
            _lines.Write(list, capture, track, timeUs, payload.Length, hash, _options.HashesOnly ? null : fileName);
        }

        private Span<byte> Room(int size)
        {
            if (_payload.Length < size)
                _payload = new byte[size];
            return _payload.AsSpan(0, size);
        }

        /// <summary>A custom track's name comes from the file: only letters that cannot leave the folder are kept, and its number makes it unique.</summary>
        private string FileStem(KinectTrack track)
        {
            string safe = new(track.Name.Select(letter => char.IsAsciiLetterOrDigit(letter) || letter is '_' or '-' ? letter : '_').Take(60).ToArray());
            int number = Enumerable.Range(0, _recording.Tracks.Count).First(i => ReferenceEquals(_recording.Tracks[i], track));
            bool isUnique = safe == track.Name && safe.Length > 0 && _recording.Tracks.Count(other => other.Name == track.Name) == 1;
            return isUnique ? "track-" + safe : $"track-{safe}-{number}";
        }
    }
}
