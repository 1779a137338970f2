using System;

namespace LaserTracking.Detection
{
    /// <summary>A spot that rose above its own past, with everything that the tests measure. Lengths in working pixels.</summary>
    internal struct Candidate
    {
        /// <summary>Levels that a dot of the recorded clips gains where it has room: less than most of them.</summary>
        private const double OrdinaryRise = 64;

        public DetectionPlane Plane;
        public int SeedX;
        public int SeedY;

        /// <summary>Largest rise, levels.</summary>
        public int PeakRise;

        /// <summary>Largest rise as a share of the headroom, 0…255.</summary>
        public int PeakRelativeRise;

        /// <summary>Pixels at half of the largest relative rise or more, connected to the seed.</summary>
        public int Area;

        public int Left;
        public int Top;
        public int Right;
        public int Bottom;

        /// <summary>Unweighted centre of the area.</summary>
        public double CenterX;
        public double CenterY;

        /// <summary>Standard deviations of the area along its long and its short axis.</summary>
        public double LongSigma;
        public double ShortSigma;

        /// <summary>Area through that of the ellipse with these deviations: 1 for a filled ellipse, less for anything ragged.</summary>
        public double Compactness;

        /// <summary>Share of the ring around the area that rose at least half as far.</summary>
        public double RingShare;

        /// <summary>Relative rise that a tenth of the ring exceeds, through the candidate's own: diffuse changes have no quiet ring.</summary>
        public double RingLevel;

        /// <summary>The strongest channel's rise since the last frame, per pixel of area, through the peak relative rise.</summary>
        public double Freshness;

        /// <summary>The same of red and green alone: lasers exceed one, grey things reach it.</summary>
        public double Vividness;

        /// <summary>Recent ordinary onset of the tile, levels.</summary>
        public double Activity;

        /// <summary>The same of the liveliest tile among its own and the eight around it.</summary>
        public double ActivityAround;

        /// <summary>Share of the surroundings that changed since the last frame by a sixth of the rise.</summary>
        public double MotionShare;

        /// <summary>The light was not there in the frame before.</summary>
        public bool IsOnset;

        /// <summary>Rises of the channels as shares of their headrooms, summed over the dot and its rim.</summary>
        public double RedRise;
        public double GreenRise;
        public double BlueRise;

        /// <summary>Mean room that red and green had left in the frame before, levels: without any, its silence says nothing.</summary>
        public double RedHeadroom;
        public double GreenHeadroom;

        /// <summary>How much of all red-green difference points one way: +1 all green, -1 all red, 0 as much of either.</summary>
        public double GreenCoherence;

        /// <summary>Rise times the root of the area, levels·px: what the eye integrates.</summary>
        public double Strength;

        /// <summary>What speaks for a laser's light, all measures together; 0 = even odds.</summary>
        public double LogOdds;

        public bool IsConclusive;

        /// <summary>Brighter than anything that the projected picture has shown: grown and measured by what exceeds that.</summary>
        public bool IsAboveContent;

        /// <summary>Brighter than the rendered pictures explain: measured by what exceeds the expected view.</summary>
        public bool IsAboveExpected;

        /// <summary>Its brightest pixel exceeds anything that the projected picture has shown.</summary>
        public bool ExceedsContent;

        /// <summary>The brightest pixel of the box; of candidates that are weighed.</summary>
        public int PeakLevel;

        /// <summary>Brightness of the projected picture's brightest parts, levels; from it light is measured when above content.</summary>
        public int ContentLevel;

        /// <summary>Not brighter than the projected picture can be, where that is known.</summary>
        public bool MayBeContent;

        /// <summary>
        /// Largest rise had there been room, levels: what reached full brightness rose by at least what it shows, an ordinary dot by more,
        /// the surer the more of the room it took. Movement nearby, where there is room, is held against this.
        /// </summary>
        public double UnclippedRise(in FrameView view) =>
            IsClipped(view) ? Math.Max(PeakRise, OrdinaryRise * PeakRelativeRise * PeakRelativeRise / (255.0 * 255.0)) : PeakRise;

        private bool IsClipped(in FrameView view) => view.IsClipped(SeedY * view.Width + SeedX, Plane);

        /// <summary>
        /// By how many levels a pixel must have risen beside half of the share of the room, to have risen as the candidate has. Near
        /// full brightness a few levels are half of the room: noise is no rise there, and beside a clipped dot a pixel that is not clipped itself must have risen by half of what the dot would have.
        /// </summary>
        public int LeastRise(in FrameView view, double noise, out int leastUnclipped)
        {
            int beyondNoise = (int)(4 * noise) + 3;
            if (!IsClipped(view))
                return leastUnclipped = Math.Min(PeakRise / 2, beyondNoise);
            double unclipped = UnclippedRise(view);
            int least = Math.Min(PeakRise / 2, Math.Max(beyondNoise, (int)(unclipped / 3)));
            leastUnclipped = Math.Max(least, (int)(unclipped / 2));
            return least;
        }

        /// <summary>Whatever a rejected spot's shape is, if it grows dimmer it is a light that is going out.</summary>
        public bool Fade(in FrameView view)
        {
            double fresh = view.Change(SeedY * view.Width + SeedX, Plane) / (double)PeakRise;
            if (fresh >= -0.2)
                return false;
            Reason = RejectionReason.NotNew;
            Value = fresh;
            Limit = 0.5;
            return true;
        }

        /// <summary>None: it is a dot.</summary>
        public RejectionReason Reason;
        public double Value;
        public double Limit;
    }
}
