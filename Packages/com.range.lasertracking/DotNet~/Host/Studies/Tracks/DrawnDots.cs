using System;
using System.Collections.Generic;
using LaserTracking.Host.Tracks;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Tracks
{
    /// <summary>
    /// Dots of several lasers as a detector would deliver them, with the truth: they sweep over a 1920×1080 picture at 30 frames a second
    /// (sums of slow sines), tremble at 4.5–11.5 Hz, cross, are hidden for a while, missed now and then, and stray light comes in between.
    /// Seeded.
    /// </summary>
    internal sealed class DrawnDots
    {
        /// <summary>For how long a dot is hidden, frames; all alike often.</summary>
        public static readonly int[] HiddenFrames = { 3, 8, 15, 24 };

        private const double FramesPerSecond = 30;
        private const double WidthPx = 1920, HeightPx = 1080, DotPx = 16;
        private const double NoisePx = 0.6;
        private const double HideChance = 0.006, MissChance = 0.06, StrayPerFrame = 0.12;
        private const int LeastVisibleFrames = 20;

        private readonly Random _random;

        public DrawnDots(int seed, int dots, int frames)
        {
            _random = new Random(seed);
            for (int id = 1; id <= dots; id++)
                Draw(id, frames);
            for (int frame = 1; frame <= frames; frame++)
            {
                if (_random.NextDouble() < StrayPerFrame)
                    Detections.Add(Row(frame, -1, _random.NextDouble() * WidthPx, _random.NextDouble() * HeightPx));
            }

            Detections.Sort((a, b) => a.Frame != b.Frame ? a.Frame.CompareTo(b.Frame) : a.Box.X.CompareTo(b.Box.X));
            Truth.Sort((a, b) => a.Frame != b.Frame ? a.Frame.CompareTo(b.Frame) : a.Id.CompareTo(b.Id));
        }

        /// <summary>Visible dots, by frame.</summary>
        public List<MotRow> Truth { get; } = new();

        /// <summary>By frame, from left to right.</summary>
        public List<MotRow> Detections { get; } = new();

        private void Draw(int id, int frames)
        {
            Func<int, double> x = Way(WidthPx, frames), y = Way(HeightPx, frames);
            int hiddenUntil = 0, visibleUntil = LeastVisibleFrames;
            for (int frame = 1; frame <= frames; frame++)
            {
                if (frame > visibleUntil && _random.NextDouble() < HideChance)
                {
                    hiddenUntil = frame + HiddenFrames[_random.Next(HiddenFrames.Length)];
                    visibleUntil = hiddenUntil + LeastVisibleFrames;
                }

                if (frame < hiddenUntil)
                    continue;
                Truth.Add(Row(frame, id, x(frame), y(frame)));
                if (_random.NextDouble() >= MissChance)
                    Detections.Add(Row(frame, -1, x(frame) + NoisePx * Gaussian(), y(frame) + NoisePx * Gaussian()));
            }
        }

        private Func<int, double> Way(double length, int frames)
        {
            double slow = length * Between(0.1, 0.22), slowHz = Between(0.08, 0.25), slowPhase = Between(0, 2 * Math.PI);
            double quick = slow / 2, quickHz = Between(0.2, 0.5), quickPhase = Between(0, 2 * Math.PI);
            double tremor = Between(1, 4), tremorHz = Between(4.5, 11.5);
            var phases = new double[frames + 1];
            phases[0] = Between(0, 2 * Math.PI);
            for (int i = 1; i < phases.Length; i++)
                phases[i] = phases[i - 1] + 2 * Math.PI * tremorHz / FramesPerSecond + 0.15 * Gaussian();
            return frame => length / 2 + slow * Math.Sin(2 * Math.PI * slowHz * frame / FramesPerSecond + slowPhase)
                + quick * Math.Sin(2 * Math.PI * quickHz * frame / FramesPerSecond + quickPhase) + tremor * Math.Sin(phases[frame]);
        }

        private double Between(double low, double high) => low + (high - low) * _random.NextDouble();

        private double Gaussian() => Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());

        private static MotRow Row(int frame, int id, double x, double y) => new(frame, id, new BoundingBox(x - DotPx / 2, y - DotPx / 2, DotPx, DotPx), 1);
    }
}
