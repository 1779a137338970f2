using System;
using System.Text.Json;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Sources
{
    /// <summary>What a line of frames.jsonl says about a picture's time and place.</summary>
    internal readonly struct FrameListLine
    {
        public bool IsColor { get; private init; }

        /// <summary>Device time in microseconds.</summary>
        public long TimeUs { get; private init; }

        /// <summary>Name of the payload's file, or null.</summary>
        public string? File { get; private init; }

        public long? Capture { get; private init; }

        /// <summary>None for JPEG and for anything whose rows are padded.</summary>
        public PixelFormat RawFormat { get; private init; }

        public int Width { get; private init; }

        public int Height { get; private init; }

        /// <summary>False when the line is no JSON object or lacks the track or the time.</summary>
        public static bool TryParse(string text, out FrameListLine line)
        {
            line = default;
            try
            {
                using JsonDocument document = JsonDocument.Parse(text);
                JsonElement root = document.RootElement;
                if (root.ValueKind != JsonValueKind.Object || Text(root, "track") is not string track || Integer(root, "time_us") is not long timeUs)
                    return false;
                int width = (int)Math.Clamp(Integer(root, "width") ?? 0, 0, 0xFFFF);
                int height = (int)Math.Clamp(Integer(root, "height") ?? 0, 0, 0xFFFF);
                PixelFormat format = Text(root, "format") switch
                {
                    "NV12" => PixelFormat.Nv12,
                    "YUY2" => PixelFormat.Yuy2,
                    "BGRA32" => PixelFormat.Bgra32,
                    _ => PixelFormat.None,
                };
                bool isTight = Image.TightSize(format, width, height) > 0 && Integer(root, "stride") == Image.TightStride(format, width);
                line = new FrameListLine
                {
                    IsColor = track == "COLOR",
                    TimeUs = timeUs,
                    File = Text(root, "file"),
                    Capture = Integer(root, "capture"),
                    RawFormat = isTight ? format : PixelFormat.None,
                    Width = width,
                    Height = height,
                };
                return true;
            }
            catch (JsonException)
            {
                return false;
            }
        }

        private static string? Text(JsonElement root, string name) =>
            root.TryGetProperty(name, out JsonElement value) && value.ValueKind == JsonValueKind.String ? value.GetString() : null;

        private static long? Integer(JsonElement root, string name) =>
            root.TryGetProperty(name, out JsonElement value) && value.ValueKind == JsonValueKind.Number && value.TryGetInt64(out long number)
                ? number
                : null;
    }
}
