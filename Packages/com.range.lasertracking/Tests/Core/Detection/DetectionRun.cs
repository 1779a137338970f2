using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Imaging;
using LaserTracking.Tracking;

namespace LaserTracking.Detection
{
    /// <summary>Runs drawn frames through a detector and the tracker and collects what comes out.</summary>
    internal sealed class DetectionRun
    {
        public DetectionRun(IShotDetector? detector = null, int width = 320, int height = 240, int framesPerSecond = 30, uint seed = 12345)
        {
            Detector = detector ?? new ShotDetector();
            Builder = new FrameBuilder(width, height, seed);
            IntervalUs = 1_000_000 / framesPerSecond;
        }

        public IShotDetector Detector { get; }

        public FrameBuilder Builder { get; }

        public ShotTracker Tracker { get; } = new ShotTracker();

        public Detections Detections { get; } = new Detections();

        public Frame Frame { get; } = new Frame();

        public List<Shot> Shots { get; } = new List<Shot>();

        public List<RejectedCandidate> Rejected { get; } = new List<RejectedCandidate>();

        public long IntervalUs { get; }

        public PixelFormat Format { get; set; } = PixelFormat.Bgra32;

        /// <summary>Draws and processes frames first … first + count - 1; returns the dots tracked in the last one.</summary>
        public int Play(int first, int count, Action<FrameBuilder, int> draw)
        {
            for (int i = first; i < first + count; i++)
            {
                draw(Builder, i);
                Builder.Write(Frame, i, i * IntervalUs, Format);
                Detector.Process(Frame, Detections);
                Tracker.Process(Detections);
                foreach (Shot shot in Tracker.Shots)
                    Shots.Add(shot);
                foreach (RejectedCandidate candidate in Detections.Rejected)
                    Rejected.Add(candidate);
            }

            return Tracker.Dots.Length;
        }
    }
}
