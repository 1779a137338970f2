using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>Something that makes a clip harder. Bgra32 only; the same frame number gives the same picture.</summary>
    /// <param name="Name">Of the case.</param>
    /// <param name="Apply">Source, frame number, target (already a copy of the source) → by how much the picture was displaced, px.</param>
    internal sealed unsafe record PictureStress(string Name, Func<Image, int, Image, Vector2D> Apply)
    {
        private const int StepFrames = 10;

        /// <summary>The cases that the detector's figures are given for.</summary>
        public static IEnumerable<PictureStress> All()
        {
            yield return new PictureStress("as-is", (_, _, _) => default);
            foreach (int sigma in new[] { 4, 8 })
                yield return new PictureStress("noise-" + sigma, (_, frame, target) => Noise(target, frame, sigma));
            foreach (int percent in new[] { 5, 15, 40 })
                yield return new PictureStress("step-" + percent, (_, frame, target) => Gain(target, StepGain(frame, percent / 100.0)));
            foreach (int pixels in new[] { 1, 2 })
                yield return new PictureStress("shake-" + pixels, (source, frame, target) => Shake(source, target, frame, pixels));
            foreach (int pixels in new[] { 1, 2 })
                yield return new PictureStress("shake-smooth-" + pixels, (source, frame, target) => SmoothShake(source, target, frame, pixels));
            foreach (double gain in new[] { 1.3, 1.7, 0.4 })
                yield return new PictureStress(FormattableString.Invariant($"gain-{gain}"), (_, _, target) => Gain(target, gain));
        }

        /// <summary>Ten frames as they are, ten brighter, ten as they are, ten darker.</summary>
        private static double StepGain(int frame, double step) => (frame / StepFrames % 4) switch
        {
            1 => 1 + step,
            3 => 1 - step,
            _ => 1,
        };

        private static Vector2D Gain(Image target, double gain)
        {
            byte* table = stackalloc byte[256];
            for (int i = 0; i < 256; i++)
                table[i] = (byte)Math.Min(255, Math.Round(i * gain));
            foreach (ref byte value in target.Bytes)
                value = table[value];
            return default;
        }

        private static Vector2D Noise(Image target, int frame, double sigma)
        {
            // Gaussian values from a table by a fast generator; a frame of 300,000 pixels takes a few milliseconds.
            sbyte* table = stackalloc sbyte[4096];
            var random = new Random(17);
            for (int i = 0; i < 4096; i++)
                table[i] = (sbyte)Math.Clamp(Math.Round(sigma * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble())), -127, 127);
            ulong state = (ulong)frame * 0x9E3779B97F4A7C15 + 0x1234567;
            foreach (ref byte value in target.Bytes)
            {
                state ^= state << 13;
                state ^= state >> 7;
                state ^= state << 17;
                value = (byte)Math.Clamp(value + table[state >> 40 & 4095], 0, 255);
            }

            return default;
        }

        private static Vector2D Shake(Image source, Image target, int frame, int pixels)
        {
            var random = new Random(1000 + frame);
            int dx = random.Next(-pixels, pixels + 1), dy = random.Next(-pixels, pixels + 1);
            Displace(source, target, dx, dy);
            return new Vector2D(dx, dy);
        }

        /// <summary>By whole pixels; what comes into view repeats the border.</summary>
        public static void Displace(Image source, Image target, int dx, int dy)
        {
            for (int y = 0; y < target.Height; y++)
            {
                uint* from = (uint*)(source.Pixels + Math.Clamp(y - dy, 0, source.Height - 1) * (long)source.Stride);
                uint* to = (uint*)(target.Pixels + y * (long)target.Stride);
                for (int x = 0; x < target.Width; x++)
                    to[x] = from[Math.Clamp(x - dx, 0, source.Width - 1)];
            }
        }

        /// <summary>Fractions of a pixel, by linear interpolation.</summary>
        private static Vector2D SmoothShake(Image source, Image target, int frame, int pixels)
        {
            var random = new Random(2000 + frame);
            double dx = (2 * random.NextDouble() - 1) * pixels, dy = (2 * random.NextDouble() - 1) * pixels;
            for (int y = 0; y < target.Height; y++)
            {
                double sy = Math.Clamp(y - dy, 0, source.Height - 1);
                int y0 = (int)sy, y1 = Math.Min(y0 + 1, source.Height - 1);
                int fy = (int)((sy - y0) * 256);
                byte* upper = source.Pixels + y0 * (long)source.Stride, lower = source.Pixels + y1 * (long)source.Stride;
                byte* to = target.Pixels + y * (long)target.Stride;
                for (int x = 0; x < target.Width; x++)
                {
                    double sx = Math.Clamp(x - dx, 0, source.Width - 1);
                    int x0 = (int)sx, x1 = Math.Min(x0 + 1, source.Width - 1), fx = (int)((sx - x0) * 256);
                    for (int c = 0; c < 3; c++)
                    {
                        int top = upper[4 * x0 + c] * (256 - fx) + upper[4 * x1 + c] * fx;
                        int bottom = lower[4 * x0 + c] * (256 - fx) + lower[4 * x1 + c] * fx;
                        to[4 * x + c] = (byte)((top * (256 - fy) + bottom * fy + 32768) >> 16);
                    }
                }
            }

            return new Vector2D(dx, dy);
        }
    }
}
