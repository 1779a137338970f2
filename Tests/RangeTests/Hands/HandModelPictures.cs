using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using LaserTracking.Imaging;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Hands
{
    /// <summary>Draws the pictures of the hand-landmark references from their formulas (data/hands/README.md), in integers throughout.</summary>
    internal static class HandModelPictures
    {
        public static IEnumerable<JObject> All(string inputsPath) => JObject.Parse(File.ReadAllText(inputsPath))["inputs"]!.Cast<JObject>();

        /// <summary>The picture, once its bytes have the SHA-256 that the file says.</summary>
        public static Image Draw(JObject input, int size = 224)
        {
            Func<int, int, int, long> behind = Background((JObject)input["background"]!, size);
            long[][] shapes = input["shapes"]!.Select(shape => shape.Select(value => (long)value).ToArray()).ToArray();
            byte[] rgb = new byte[size * size * 3];
            long[] pixel = new long[3];
            for (int y = 0; y < size; y++)
            {
                for (int x = 0; x < size; x++)
                {
                    for (int c = 0; c < 3; c++)
                        pixel[c] = behind(x, y, c);
                    if (shapes.Length > 0)
                        Cover(shapes, x, y, pixel);
                    for (int c = 0; c < 3; c++)
                        rgb[(y * size + x) * 3 + c] = (byte)pixel[c];
                }
            }

            string hash = Convert.ToHexString(SHA256.HashData(rgb)).ToLowerInvariant();
            if (hash != (string?)input["sha256"])
                throw new InvalidOperationException("drawn otherwise than described: " + input["id"]);
            var image = new Image();
            image.Reset(PixelFormat.Bgra32, size, size, 0);
            for (int i = 0; i < size * size; i++)
            {
                image.Bytes[4 * i] = rgb[3 * i + 2];
                image.Bytes[4 * i + 1] = rgb[3 * i + 1];
                image.Bytes[4 * i + 2] = rgb[3 * i];
                image.Bytes[4 * i + 3] = 255;
            }

            return image;
        }

        /// <summary>The mean of 16 samples, each of the topmost shape there or of what is behind.</summary>
        private static void Cover(long[][] shapes, int x, int y, long[] pixel)
        {
            long red = 8, green = 8, blue = 8;
            for (int j = 1; j < 8; j += 2)
            {
                for (int i = 1; i < 8; i += 2)
                {
                    long[]? shape = Topmost(shapes, 8 * x + i, 8 * y + j, out long shade);
                    red += shape == null ? pixel[0] : Math.Max(0, shape[5] - shade);
                    green += shape == null ? pixel[1] : Math.Max(0, shape[6] - shade);
                    blue += shape == null ? pixel[2] : Math.Max(0, shape[7] - shade);
                }
            }

            (pixel[0], pixel[1], pixel[2]) = (red / 16, green / 16, blue / 16);
        }

        private static long[]? Topmost(long[][] shapes, long px, long py, out long shade)
        {
            shade = 0;
            for (int s = shapes.Length - 1; s >= 0; s--)
            {
                long[] shape = shapes[s];
                long dx = shape[2] - shape[0], dy = shape[3] - shape[1], ax = px - shape[0], ay = py - shape[1];
                long length = dx * dx + dy * dy, t = ax * dx + ay * dy, numerator, denominator = 1;
                if (t <= 0 || length == 0)
                    numerator = ax * ax + ay * ay;
                else if (t >= length)
                    numerator = (px - shape[2]) * (px - shape[2]) + (py - shape[3]) * (py - shape[3]);
                else
                    (numerator, denominator) = ((ax * dy - ay * dx) * (ax * dy - ay * dx), length);
                long limit = shape[4] * shape[4] * denominator;
                if (numerator > limit)
                    continue;
                shade = shape[8] * numerator / limit;
                return shape;
            }

            return null;
        }

        private static Func<int, int, int, long> Background(JObject background, int size)
        {
            long Number(string name) => (long)background[name]!;
            long[] Numbers(string name) => background[name]!.Select(value => (long)value).ToArray();
            switch ((string?)background["kind"])
            {
                case "constant":
                    long[] rgb = Numbers("rgb");
                    return (x, y, c) => rgb[c];
                case "hash":
                    uint seed = (uint)Number("seed");
                    int cell = (int)Number("cell");
                    return (x, y, c) => Hash(seed, x / cell, y / cell, c);
                case "rings":
                    long centerX = Number("cx"), centerY = Number("cy");
                    long[] div = Numbers("div");
                    return (x, y, c) => ((x - centerX) * (x - centerX) + (y - centerY) * (y - centerY)) / div[c] % 256;
                case "ramp":
                case "rampnoise":
                    long wx = Number("wx"), wy = Number("wy"), m = (size - 1) * (wx + wy);
                    long[] from = Numbers("from"), to = Numbers("to");
                    Func<int, int, int, long> ramp = (x, y, c) => (from[c] * (m - wx * x - wy * y) + to[c] * (wx * x + wy * y)) / m;
                    if ((string?)background["kind"] == "ramp")
                        return ramp;
                    uint noiseSeed = (uint)Number("seed");
                    int noiseCell = (int)Number("cell");
                    long amplitude = Number("amp");
                    return (x, y, c) => Math.Min(255, ramp(x, y, c) + Hash(noiseSeed, x / noiseCell, y / noiseCell, 0) / amplitude);
                default:
                    throw new InvalidOperationException("unknown background " + background);
            }
        }

        private static uint Hash(uint seed, int x, int y, int c)
        {
            unchecked
            {
                uint h = seed * 0x9E3779B1u ^ (uint)x * 0x85EBCA77u ^ (uint)y * 0xC2B2AE3Du ^ (uint)c * 0x27D4EB2Fu;
                h ^= h >> 15;
                h *= 0x2C1B3C6Du;
                h ^= h >> 12;
                h *= 0x297A2D39u;
                h ^= h >> 15;
                return h >> 24;
            }
        }
    }
}
