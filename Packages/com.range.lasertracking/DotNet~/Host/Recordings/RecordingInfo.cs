using System;
using System.Collections.Generic;
using System.Security.Cryptography;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;

namespace LaserTracking.Host.Recordings
{
    /// <summary>
    /// What `info` says about a depth camera's recording. Reads all of it once: counts come from the blocks themselves and every
    /// cluster's checksum is verified.
    /// </summary>
    internal sealed class RecordingInfo
    {
        private readonly KinectRecording _recording;
        private readonly Dictionary<KinectTrack, long> _frames = new();
        private readonly List<FrameProblem> _calibrationProblems = new();

        public RecordingInfo(KinectRecording recording) => _recording = recording;

        /// <summary>Builds the JSON object of the contract.</summary>
        /// <param name="progress">Called now and then with the share that is done, 0 to 1.</param>
        /// <param name="cancellation">Ends the work with an <see cref="OperationCanceledException"/>.</param>
        public JsonObject Build(Action<double>? progress = null, CancellationToken cancellation = default)
        {
            long captures = CountCaptures(progress, cancellation);
            CountData(cancellation);
            KinectRecordConfiguration configuration = _recording.Configuration;
            JsonObject? calibration = DescribeCalibration();
            return new JsonObject
            {
                ["container"] = "k4a-mkv",
                ["duration_us"] = _recording.LengthUs,
                ["truncated"] = _recording.IsCut,
                ["tracks"] = DescribeTracks(),
                ["captures"] = captures,
                ["imu_samples"] = _recording.ImuTrack == null ? 0 : _frames[_recording.ImuTrack],
                ["device"] = DescribeDevice(),
                ["depth_mode"] = KinectDepthModes.NameOf(configuration.DepthMode),
                ["start_offset_us"] = configuration.StartOffsetUs,
                ["sync"] = new JsonObject
                {
                    ["mode"] = configuration.WiredSyncMode.ToString().ToUpperInvariant(),
                    ["subordinate_delay_us"] = configuration.SubordinateDelayOffMasterUs,
                    ["depth_delay_us"] = configuration.DepthDelayOffColorUs,
                },
                ["calibration"] = calibration,
                ["problems"] = DescribeProblems(),
            };
        }

        private long CountCaptures(Action<double>? progress, CancellationToken cancellation)
        {
            foreach (KinectTrack track in _recording.Tracks)
                _frames[track] = 0;
            var capture = new KinectCapture();
            long captures = 0;
            _recording.VerifiesChecksums = true;
            _recording.SeekToStart();
            for (; _recording.TryReadNext(capture); captures++)
            {
                cancellation.ThrowIfCancellationRequested();
                Count(capture.Color);
                Count(capture.Depth);
                Count(capture.Infrared);
                if (progress != null && _recording.LengthUs > 0)
                    progress(Math.Clamp((capture.DeviceTimeUs - _recording.Configuration.StartOffsetUs) / (double)_recording.LengthUs, 0, 1));
            }

            // The same bytes are not verified again for the other tracks.
            _recording.VerifiesChecksums = false;
            return captures;
        }

        private void Count(in KinectImage image)
        {
            if (image.IsPresent)
                _frames[image.Track!]++;
        }

        private void CountData(CancellationToken cancellation)
        {
            foreach (KinectTrack track in _recording.Tracks)
            {
                if (track == _recording.ImuTrack)
                {
                    KinectImuReader samples = _recording.CreateImuReader();
                    while (samples.TryReadNext(out _))
                        _frames[track]++;
                }
                else if (!track.IsBuiltin)
                {
                    KinectDataReader frames = _recording.CreateDataReader(track);
                    while (frames.TryReadNext(out _))
                        _frames[track]++;
                }

                cancellation.ThrowIfCancellationRequested();
            }
        }

        private JsonArray DescribeTracks()
        {
            var tracks = new JsonArray();
            foreach (KinectTrack track in _recording.Tracks)
            {
                var description = new JsonObject { ["name"] = track.Name, ["format"] = RecordingFormats.NameOf(track) };
                if (track.IsVideo)
                {
                    description["width"] = track.Width;
                    description["height"] = track.Height;
                    description["fps"] = track.FramesPerSecond;
                }

                if (track == _recording.ColorTrack && _recording.Configuration.ColorRegion is { } region)
                    description["region"] = new JsonObject { ["x"] = region.X, ["y"] = region.Y, ["full_width"] = region.FullWidth, ["full_height"] = region.FullHeight };
                description["frames"] = _frames[track];
                tracks.Add(description);
            }

            return tracks;
        }

        private JsonObject? DescribeDevice()
        {
            if (_recording.DeviceSerialNumber == null && _recording.ColorFirmwareVersion == null && _recording.DepthFirmwareVersion == null)
                return null;
            return new JsonObject
            {
                ["serial"] = _recording.DeviceSerialNumber,
                ["firmware_color"] = _recording.ColorFirmwareVersion,
                ["firmware_depth"] = _recording.DepthFirmwareVersion,
            };
        }

        private JsonObject? DescribeCalibration()
        {
            if (!_recording.TryReadCalibration(out byte[] json))
                return null;
            var description = new JsonObject
            {
                ["size"] = json.Length,
                ["sha256"] = Convert.ToHexString(SHA256.HashData(json)).ToLowerInvariant(),
            };
            try
            {
                using JsonDocument document = JsonDocument.Parse(json.AsMemory(HasByteOrderMark(json) ? 3 : 0).TrimEnd((byte)0));
                var cameras = new JsonArray();
                foreach (JsonElement camera in document.RootElement.GetProperty("CalibrationInformation").GetProperty("Cameras").EnumerateArray())
                {
                    JsonElement intrinsics = camera.GetProperty("Intrinsics");
                    cameras.Add(new JsonObject
                    {
                        ["location"] = camera.GetProperty("Location").GetString(),
                        ["model"] = intrinsics.GetProperty("ModelType").GetString(),
                        ["parameters"] = JsonNode.Parse(intrinsics.GetProperty("ModelParameters").GetRawText()),
                        ["sensor_width"] = camera.GetProperty("SensorWidth").GetInt32(),
                        ["sensor_height"] = camera.GetProperty("SensorHeight").GetInt32(),
                    });
                }

                description["cameras"] = cameras;
            }
            catch (Exception exception) when (exception is JsonException or KeyNotFoundException or InvalidOperationException or FormatException)
            {
                _calibrationProblems.Add(new FrameProblem(-1, exception is JsonException parsing
                    ? $"calibration.json cannot be read (line {parsing.LineNumber + 1}, byte {parsing.BytePositionInLine}): it is no valid JSON"
                    : "calibration.json lacks what a calibration needs"));
            }

            return description;
        }

        private JsonArray DescribeProblems()
        {
            var problems = new JsonArray();
            foreach (IReadOnlyList<FrameProblem> list in new[] { _recording.Problems, _calibrationProblems })
            {
                foreach (FrameProblem problem in list)
                {
                    var entry = new JsonObject { ["offset"] = problem.Offset < 0 ? null : problem.Offset, ["what"] = problem.What };
                    if (problem.FrameIndex >= 0)
                        entry["capture"] = problem.FrameIndex;
                    problems.Add(entry);
                }
            }

            return problems;
        }

        private static bool HasByteOrderMark(ReadOnlySpan<byte> json) => json.StartsWith("\uFEFF"u8);
    }
}
