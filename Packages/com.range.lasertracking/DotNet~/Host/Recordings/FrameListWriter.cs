using System;
using System.Buffers;
using System.IO;
using System.Text.Encodings.Web;
using System.Text.Json;
using LaserTracking.Capture.AzureKinect;

namespace LaserTracking.Host.Recordings
{
    /// <summary>Writes the lines of frames.jsonl: UTF-8, LF.</summary>
    internal sealed class FrameListWriter
    {
        private readonly ArrayBufferWriter<byte> _line = new();
        private readonly Utf8JsonWriter _json;

        public FrameListWriter() => _json = new Utf8JsonWriter(_line, new JsonWriterOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping });

        /// <summary>Number of lines written.</summary>
        public long Count { get; private set; }

        /// <param name="stream">Gets the line.</param>
        /// <param name="capture">Index of the capture; null for custom tracks.</param>
        /// <param name="track">Width, height and stride are null for custom tracks.</param>
        /// <param name="timeUs">Device time in microseconds.</param>
        /// <param name="size">Payload in bytes.</param>
        /// <param name="sha256">32 bytes.</param>
        /// <param name="file">Name of the payload's file, or null.</param>
        public void Write(Stream stream, int? capture, KinectTrack track, long timeUs, int size, ReadOnlySpan<byte> sha256, string? file)
        {
            _line.ResetWrittenCount();
            _json.Reset();
            _json.WriteStartObject();
            if (capture is int index)
                _json.WriteNumber("capture", index);
            else
                _json.WriteNull("capture");
            _json.WriteString("track", track.Name);
            _json.WriteNumber("time_us", timeUs);
            _json.WriteString("format", RecordingFormats.NameOf(track));
            if (capture != null)
            {
                _json.WriteNumber("width", track.Width);
                _json.WriteNumber("height", track.Height);
                _json.WriteNumber("stride", track.Stride);
            }
            else
            {
                _json.WriteNull("width");
                _json.WriteNull("height");
                _json.WriteNull("stride");
            }

            _json.WriteNumber("size", size);
            _json.WriteString("sha256", Convert.ToHexString(sha256).ToLowerInvariant());
            if (file != null)
                _json.WriteString("file", file);
            _json.WriteEndObject();
            _json.Flush();
            _line.Write("\n"u8);
            stream.Write(_line.WrittenSpan);
            Count++;
        }
    }
}
