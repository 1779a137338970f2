using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Host.Scoring;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>The light of a real dot, cut out: what it added to the picture of the frame before, levels a channel.</summary>
    internal sealed unsafe class DotTemplate
    {
        private const int Radius = 18;
        private const int Side = 2 * Radius + 1;

        /// <summary>Light outside this radius is a halo cut off at the patch's border: it fades to nothing from here.</summary>
        private const double FadeFrom = 12;

        private readonly float[] _light = new float[Side * Side * 3];

        private DotTemplate(string color) => Color = color;

        public string Color { get; }

        /// <summary>Levels that the brightest pixel gains in its weakest channel.</summary>
        public double PeakLevels { get; private set; }

        /// <summary>Null when the dot lies too near to the border, or adds too little to be told from noise.</summary>
        public static DotTemplate? TryCut(Image now, Image before, TruthShot shot)
        {
            int centerX = (int)Math.Round(shot.PlacesPx[0].X), centerY = (int)Math.Round(shot.PlacesPx[0].Y);
            if (centerX < Radius || centerY < Radius || centerX >= now.Width - Radius || centerY >= now.Height - Radius)
                return null;
            var template = new DotTemplate(shot.Color ?? "unknown");
            for (int y = 0; y < Side; y++)
            {
                byte* a = now.Pixels + (centerY + y - Radius) * (long)now.Stride + 4 * (centerX - Radius);
                byte* b = before.Pixels + (centerY + y - Radius) * (long)before.Stride + 4 * (centerX - Radius);
                for (int x = 0; x < Side; x++)
                {
                    double distance = Math.Sqrt((x - Radius) * (x - Radius) + (y - Radius) * (y - Radius));
                    double share = Math.Clamp((Radius - distance) / (Radius - FadeFrom), 0, 1);
                    double weakest = double.MaxValue;
                    for (int c = 0; c < 3; c++)
                    {
                        double rise = Math.Max(0, a[4 * x + c] - b[4 * x + c] - 2) * share;
                        weakest = Math.Min(weakest, rise);
                        template._light[(y * Side + x) * 3 + c] = (float)rise;
                    }

                    template.PeakLevels = Math.Max(template.PeakLevels, weakest);
                }
            }

            return template;
        }

        /// <summary>Adds the light to a Bgra32 picture.</summary>
        public void Paste(Image target, int centerX, int centerY, double strength)
        {
            for (int y = 0; y < Side; y++)
            {
                int ty = centerY + y - Radius;
                if (ty < 0 || ty >= target.Height)
                    continue;
                byte* row = target.Pixels + ty * (long)target.Stride;
                for (int x = 0; x < Side; x++)
                {
                    int tx = centerX + x - Radius;
                    if (tx < 0 || tx >= target.Width)
                        continue;
                    for (int c = 0; c < 3; c++)
                        row[4 * tx + c] = (byte)Math.Min(255, row[4 * tx + c] + strength * _light[(y * Side + x) * 3 + c] + 0.5);
                }
            }
        }

        /// <summary>All dots of the clips whose first frame has light enough, in the clips' order.</summary>
        public static List<DotTemplate> CutAll(ClipSet clips, Action<string> progress)
        {
            var templates = new List<DotTemplate>();
            foreach (TruthClip clip in clips.Clips.Where(c => c.Shots.Count > 0))
            {
                progress("cutting dots out of " + clip.File);
                using var before = new Capture.Frame();
                using var now = new Capture.Frame();
                using Capture.IFrameSource source = new Capture.PrefetchingFrameSource(Sources.FrameSources.OpenScreenCamera(clips.PathOf(clip)));
                while (source.TryRead(now))
                {
                    foreach (TruthShot shot in clip.Shots.Where(s => s.FirstVisibleFrame == now.Index && now.Index > 0))
                    {
                        if (TryCut(now.Color, before.Color, shot) is { PeakLevels: >= MinPeakLevels } template)
                            templates.Add(template);
                    }

                    before.SwapWith(now);
                }
            }

            return templates;
        }

        private const double MinPeakLevels = 100;
    }
}
