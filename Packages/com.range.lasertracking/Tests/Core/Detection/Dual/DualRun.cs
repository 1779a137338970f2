using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Tracking;

namespace LaserTracking.Detection
{
    /// <summary>Plays drawn frames of 640×360 colour and 320×320 infrared to the dual detector and a tracker. Seeded.</summary>
    internal sealed unsafe class DualRun
    {
        public const int Side = 320;
        private readonly double[] _counts = new double[Side * Side];
        private uint _random = 4711;
        private int _next;

        public DualRun(DualDetectorSettings? settings = null, InfraredMapping? mapping = null) => Detector = new DualShotDetector(settings, mapping);

        public DualShotDetector Detector { get; }

        public FrameBuilder Color { get; } = new FrameBuilder(640, 360);

        public ShotTracker Tracker { get; } = new ShotTracker();

        public Detections Detections { get; } = new Detections();

        public Frame Frame { get; } = new Frame();

        public List<Shot> Shots { get; } = new List<Shot>();

        public List<RejectedCandidate> Rejected { get; } = new List<RejectedCandidate>();

        public double InfraredNoise { get; set; } = 2;

        public bool HasColor { get; set; } = true;

        public bool HasInfrared { get; set; } = true;

        /// <summary>Where the fields of view are equal: the infrared place of a colour place.</summary>
        public static Vector2D ToInfrared(double x, double y) => new Vector2D((x + 0.5) * Side / 640 - 0.5, (y + 0.5) * Side / 360 - 0.5);

        /// <summary>A wall of one brightness in both pictures.</summary>
        public DualRun Wall(double level)
        {
            Color.Wall((float)level, (float)level, (float)level);
            for (int i = 0; i < _counts.Length; i++)
                _counts[i] = level;
            return this;
        }

        /// <summary>Infrared light at a place given in colour px.</summary>
        public DualRun Infrared(double x, double y, double counts = 132, double sigma = 1.3)
        {
            Vector2D p = ToInfrared(x, y);
            for (int py = 0; py < Side; py++)
            {
                for (int px = 0; px < Side; px++)
                {
                    double r2 = (px - p.X) * (px - p.X) + (py - p.Y) * (py - p.Y);
                    if (r2 < 36 * sigma * sigma)
                        _counts[py * Side + px] += counts * Math.Exp(-0.5 * r2 / (sigma * sigma));
                }
            }

            return this;
        }

        /// <summary>A bright rectangle of infrared px.</summary>
        public DualRun InfraredBox(int x, int y, int width, int height, double counts)
        {
            for (int py = y; py < Math.Min(Side, y + height); py++)
            {
                for (int px = x; px < Math.Min(Side, x + width); px++)
                    _counts[py * Side + px] += counts;
            }

            return this;
        }

        /// <summary>A laser as the published system has it: green, and seen by the infrared camera too.</summary>
        public DualRun GreenInBoth(double x, double y)
        {
            Color.GreenDot(x, y, 1.5, 0.3);
            return Infrared(x, y);
        }

        public DualRun Play(int count, Action<DualRun, int> draw)
        {
            for (int i = 0; i < count; i++, _next++)
            {
                draw(this, _next);
                Write();
                Detector.Process(Frame, Detections);
                Tracker.Process(Detections);
                foreach (Shot shot in Tracker.Shots)
                    Shots.Add(shot);
                foreach (RejectedCandidate candidate in Detections.Rejected)
                    Rejected.Add(candidate);
            }

            return this;
        }

        public bool WasRejected(RejectionReason reason, double x, double y, double within = 3) =>
            Rejected.Exists(r => r.Reason == reason && (r.PositionPx - new Vector2D(x, y)).Length <= within);

        private void Write()
        {
            long timeUs = _next * 33_333L;
            Color.Write(Frame, _next, timeUs);
            if (!HasColor)
                Frame.Color.Clear();
            if (!HasInfrared)
                return;
            Frame.Infrared.Reset(PixelFormat.Infrared16, Side, Side, timeUs);
            for (int y = 0; y < Side; y++)
            {
                ushort* row = (ushort*)(Frame.Infrared.Pixels + (long)y * Frame.Infrared.Stride);
                for (int x = 0; x < Side; x++)
                    row[x] = (ushort)Math.Max(0, Math.Min(65535, Math.Round(_counts[y * Side + x] + InfraredNoise * Gaussian())));
            }
        }

        /// <summary>Sum of four uniform numbers, as wide as a normal one.</summary>
        private double Gaussian()
        {
            double sum = -2;
            for (int i = 0; i < 4; i++)
            {
                _random = _random * 1664525 + 1013904223;
                sum += (_random >> 8) / 16777216.0;
            }

            return sum * Math.Sqrt(3);
        }
    }
}
