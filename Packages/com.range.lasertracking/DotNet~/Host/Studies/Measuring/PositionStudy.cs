using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>Painted Gaussian dots through the whole detector: how far the measured centre lies from the true one, beside the bound.</summary>
    internal sealed class PositionStudy : IStudy
    {
        private const int Rounds = 6;
        private static readonly double[] Widths = { 0.8, 1.3, 2, 2.6 };

        private static readonly SpotCase[] Cases =
        {
            new("amplitude 60, noise 1", 60, 1),
            new("amplitude 60, noise 2", 60, 2),
            new("amplitude 60, noise 3", 60, 3),
            new("amplitude 120, noise 3", 120, 3),
            new("amplitude 200, noise 2", 200, 2),
            new("amplitude 60, bright", 60, 2, 0, SpotBackground.Bright),
            new("amplitude 60, textured", 60, 2, 0, SpotBackground.Textured),
            new("amplitude 60, NV12", 60, 2, 0, SpotBackground.Dark, 1280, PixelFormat.Nv12),
            new("amplitude 60, 640", 60, 2, 0, SpotBackground.Dark, 640),
            new("amplitude 60, 1920 NV12", 60, 2, 0, SpotBackground.Dark, 1920, PixelFormat.Nv12),
            new("amplitude 60, 1920 textured", 60, 2, 0, SpotBackground.Textured, 1920),
            new("saturated 2.4x", 255 * 2.4),
            new("saturated 12x", 255 * 12),
            new("saturated 12x, bright", 255 * 12, 2, 0, SpotBackground.Bright),
            new("saturated 12x, textured", 255 * 12, 2, 0, SpotBackground.Textured),
            new("amplitude 60, 640 textured", 60, 2, 0, SpotBackground.Textured, 640),
            new("saturated 12x, 640 textured", 255 * 12, 2, 0, SpotBackground.Textured, 640),
            new("saturated 12x, NV12", 255 * 12, 2, 0, SpotBackground.Dark, 1280, PixelFormat.Nv12),
            new("speckle 0.25, amplitude 120", 120, 2, 0.25),
            new("speckle 0.5, amplitude 120", 120, 2, 0.5),
            new("speckle 0.5, amplitude 120, NV12", 120, 2, 0.5, SpotBackground.Dark, 1280, PixelFormat.Nv12),
            new("speckle 0.5, saturated 12x", 255 * 12, 2, 0.5),
        };

        public string Name => "position";

        public string What => "error of the measured centre of painted dots (widths, sub-pixel phases, noise, saturation, speckle, backgrounds, formats)";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable("Distance of the measured from the true centre, px; dots of sigma 0.8, 1.3, 2 and 2.6 px",
                "case", "found", "mean px", "p95 px", "bound of the mean px", "in the 90 % ellipse");
            foreach (SpotCase what in Cases.Where(c => options.Includes(c.Name)))
            {
                var errors = new List<double>();
                int painted = 0, inside = 0;
                for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
                {
                    options.Progress.Show(what.Name + ", seed " + seed);
                    painted += Measure(what, seed, errors, ref inside);
                }

                errors.Sort();
                bool isBounded = what.Amplitude < 200 && what.Speckle == 0;
                table.Add(what.Name, new Proportion(errors.Count, painted), errors.Count == 0 ? double.NaN : errors.Average(),
                    errors.Count == 0 ? double.NaN : errors[(int)(0.95 * (errors.Count - 1))],
                    isBounded ? what.Noise / (what.Amplitude * SpotPainter.ChannelGain) : "–", new Proportion(inside, errors.Count));
            }

            table.Notes.Add("Bound: a Gaussian in white noise allows no better than sqrt(2/pi) noise/amplitude an axis (three channels as one); for NV12 chroma carries less.");
            return table;
        }

        /// <summary>Every third frame shows a dozen dots, the others none. Gives the number painted.</summary>
        private static int Measure(SpotCase what, int seed, List<double> errors, ref int inside)
        {
            var painter = new SpotPainter(what, seed);
            var detector = new ShotDetector();
            var detections = new Detections();
            using var frame = new Frame();
            int index = 0, painted = 0;
            var centers = new List<Vector2D>();
            void Show()
            {
                painter.Write(frame, index++);
                detections.Begin(frame.Index, frame.TimeUs);
                detector.Process(frame, detections);
            }

            for (int i = 0; i < 5; i++)
                Show();
            for (int round = 0; round < Rounds; round++)
            {
                painter.Clear();
                centers.Clear();
                for (int i = 0; i < 12; i++)
                {
                    var center = new Vector2D(what.Width * (i % 4 * 2 + 1) / 8.0 + painter.Uniform(-3, 3), what.Height * (i / 4 * 2 + 1) / 6.0 + painter.Uniform(-3, 3));
                    centers.Add(center);
                    painter.Add(center, Widths[(i + round) % Widths.Length]);
                }

                Show();
                painted += centers.Count;
                foreach (Dot dot in detections.Dots)
                    Compare(dot, centers, errors, ref inside);
                painter.Clear();
                Show();
                Show();
            }

            return painted;
        }

        private static void Compare(in Dot dot, List<Vector2D> centers, List<double> errors, ref int inside)
        {
            foreach (Vector2D center in centers)
            {
                Vector2D error = dot.PositionPx - center;
                if (error.Length > 4)
                    continue;
                errors.Add(error.Length);
                if (Ellipses.Holds(dot.CovariancePx, error, 0.9))
                    inside++;
            }
        }
    }
}
