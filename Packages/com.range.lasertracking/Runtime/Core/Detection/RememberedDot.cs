using System;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>A dot of the last frame, in working pixels: what keeps its place from being learned as background.</summary>
    internal unsafe struct RememberedDot
    {
        /// <summary>What compression leaves behind in the blocks of a light that has gone, levels.</summary>
        private const int CompressionLevels = 2;

        /// <summary>Microseconds from which a light rests: most flashes are shorter.</summary>
        private const long RestUs = 90_000;

        /// <summary>Working px: smaller areas are as good as this one, as a single bright speckle decides how much stands at half of its height.</summary>
        private const double SpeckleArea = 8;

        /// <summary>Samples along each side of the place as it was before the light.</summary>
        public const int PlaceSide = 10;

        /// <summary>Levels in the frame before the light, on a grid over the first frame's box, in the plane of that frame: later ones may show it better in the other.</summary>
        public fixed byte Place[PlaceSide * PlaceSide];
        public DetectionPlane PlacePlane;
        public int PlaceLeft;
        public int PlaceTop;
        public int PlaceWidth;
        public int PlaceHeight;

        /// <summary>Rise in its first frame, levels.</summary>
        public int FirstRise;

        /// <summary>Mean rise over the place in its first frame, through the largest.</summary>
        public double FirstLight;

        public int Left;
        public int Top;
        public int Right;
        public int Bottom;
        public int Frames;
        public long FirstTimeUs;
        public long LastTimeUs;
        public bool IsConclusive;
        public LaserColor Color;

        /// <summary>What has spoken for it so far.</summary>
        public double LogOdds;

        /// <summary>Of the sighting that <see cref="LogOdds"/> was weighed at.</summary>
        public double Vividness;

        public int PeakRise;

        /// <summary>The largest of its frames so far.</summary>
        public int HighestRise;
        public double PeakRelativeRise;
        public double Area;

        /// <summary>Longer side of its light.</summary>
        public double Length;
        public DetectionPlane Plane;
        public Vector2D PositionPx;

        /// <summary>No brighter than the projected picture can be.</summary>
        public bool MayBeContent;

        /// <summary>It was brighter than the projected picture can be: what is not any more is what lies there now, not the dot.</summary>
        public bool WasAboveContent;

        /// <summary>On for longer than most flashes.</summary>
        public bool IsResting => LastTimeUs - FirstTimeUs >= RestUs;

        /// <summary>Found again in the frame being processed.</summary>
        public bool IsContinued;

        /// <summary>Was not to be seen in the last frame but may be there: its place has learned its light by now.</summary>
        public bool IsHidden;

        /// <summary>Holds the place of a candidate that waits, against parts of it in the same plane.</summary>
        public bool IsProvisional;

        /// <summary>Keeps what the frame before shows at the candidate.</summary>
        public void RememberPlace(in FrameView view, in Candidate c)
        {
            PlacePlane = c.Plane;
            PlaceLeft = c.Left;
            PlaceTop = c.Top;
            PlaceWidth = c.Right - c.Left + 1;
            PlaceHeight = c.Bottom - c.Top + 1;
            FirstRise = HighestRise = c.PeakRise;
            for (int i = 0; i < PlaceSide * PlaceSide; i++)
                Place[i] = (byte)FrameView.Level(view.Before[PlaceIndex(view, i)], PlacePlane);
            CompareWithPlace(view, 0, out FirstLight, out double _);
        }

        /// <summary>Where a candidate's light reaches, nothing else.</summary>
        public static RememberedDot PlaceOf(in Candidate candidate)
        {
            int length = LengthOf(candidate), margin = 2 + length / 2;
            return new RememberedDot
            {
                Length = length,
                Left = candidate.Left - margin,
                Top = candidate.Top - margin,
                Right = candidate.Right + margin,
                Bottom = candidate.Bottom + margin,
            };
        }

        /// <summary>What is known of a candidate, and where its light reaches.</summary>
        public static RememberedDot Of(in Candidate candidate)
        {
            RememberedDot dot = PlaceOf(candidate);
            dot.IsConclusive = candidate.IsConclusive;
            dot.LogOdds = candidate.LogOdds;
            dot.Vividness = candidate.Vividness;
            dot.PeakRise = candidate.PeakRise;
            dot.PeakRelativeRise = candidate.PeakRelativeRise;
            dot.Area = candidate.Area;
            dot.Plane = candidate.Plane;
            dot.MayBeContent = candidate.MayBeContent;
            return dot;
        }

        /// <summary>The light goes on: its place was that of its first frame.</summary>
        public void TakePlaceOf(in RememberedDot earlier)
        {
            HighestRise = Math.Max(earlier.HighestRise, PeakRise);
            if (earlier.IsResting)
                Rest(earlier);
            PlacePlane = earlier.PlacePlane;
            PlaceLeft = earlier.PlaceLeft;
            PlaceTop = earlier.PlaceTop;
            PlaceWidth = earlier.PlaceWidth;
            PlaceHeight = earlier.PlaceHeight;
            FirstRise = earlier.FirstRise;
            FirstTimeUs = earlier.FirstTimeUs;
            FirstLight = earlier.FirstLight;
            for (int i = 0; i < PlaceSide * PlaceSide; i++)
                Place[i] = earlier.Place[i];
        }

        /// <summary>Mean difference of the place from what it was, through the rise: brighter (still lit) or darker.</summary>
        public void CompareWithPlace(in FrameView view, double noise, out double brighter, out double darker)
        {
            double up = 0, down = 0, tolerance = 2 * noise + CompressionLevels;
            for (int i = 0; i < PlaceSide * PlaceSide; i++)
            {
                int difference = FrameView.Level(view.Now[PlaceIndex(view, i)], PlacePlane) - Place[i];
                up += Math.Max(0, difference - tolerance);
                down += Math.Max(0, -difference - tolerance);
            }

            brighter = up / (PlaceSide * PlaceSide * (double)FirstRise);
            darker = down / (PlaceSide * PlaceSide * (double)FirstRise);
        }

        private int PlaceIndex(in FrameView view, int sample) =>
            (PlaceTop + sample / PlaceSide * PlaceHeight / PlaceSide) * view.Width + PlaceLeft + sample % PlaceSide * PlaceWidth / PlaceSide;

        /// <summary>What it is recognised by follows slowly: step by step a dot must not grow into a thing that passes behind it.</summary>
        private void Rest(in RememberedDot earlier)
        {
            bool isSame = Plane == earlier.Plane;
            Plane = earlier.Plane;
            Area = isSame ? 0.75 * earlier.Area + 0.25 * Area : earlier.Area;
            Length = isSame ? 0.75 * earlier.Length + 0.25 * Length : earlier.Length;
            PeakRelativeRise = isSame ? 0.75 * earlier.PeakRelativeRise + 0.25 * PeakRelativeRise : earlier.PeakRelativeRise;
            PeakRise = isSame ? PeakRise : earlier.PeakRise;
        }

        /// <summary>The same with a wider box around.</summary>
        public RememberedDot Within(int px)
        {
            RememberedDot wider = this;
            wider.Left -= px;
            wider.Top -= px;
            wider.Right += px;
            wider.Bottom += px;
            return wider;
        }

        private static int LengthOf(in Candidate c) => Math.Max(c.Right - c.Left, c.Bottom - c.Top) + 1;

        public bool Covers(double x, double y) => x >= Left && x <= Right && y >= Top && y <= Bottom;

        /// <summary>
        /// It lies in the same place and is not a mere remainder of it, nor a thing that the light lies on. Through the other plane the
        /// same light looks larger or smaller.
        /// </summary>
        public bool GoesOnAs(in Candidate c)
        {
            if (!Covers(c.CenterX, c.CenterY) || (WasAboveContent && c.MayBeContent))
                return false;
            double area = Math.Max(SpeckleArea, c.Area), before = Math.Max(SpeckleArea, Area);
            if (!IsResting || !IsConclusive)
            {
                // A light whose first frame saw only its beginning grows, and clipped it grows in area alone; what is left of one that has gone is none.
                int growth = Frames == 1 && c.IsOnset ? 5 : 3;
                return 3 * c.PeakRise >= HighestRise && 2 * c.PeakRelativeRise >= PeakRelativeRise && 3 * area >= before && area <= growth * before;
            }

            int more = c.Plane == Plane ? 1 : 2;
            return 2 * LengthOf(c) <= 3 * Length + 4 && 2 * more * c.PeakRelativeRise >= PeakRelativeRise && 3 * area >= before && area <= 3 * more * before;
        }
    }
}
