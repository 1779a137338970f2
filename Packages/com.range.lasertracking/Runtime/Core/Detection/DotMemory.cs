using System;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>A dot of the last frame, in working pixels: what keeps its place from being learned as background.</summary>
    internal unsafe struct RememberedDot
    {
        /// <summary>What compression leaves behind in the blocks of a light that has gone, levels.</summary>
        private const int CompressionLevels = 2;

        /// <summary>Microseconds from which a light rests: nearly all flashes are shorter.</summary>
        private const long RestUs = 150_000;

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

        public int PeakRise;
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

        public bool IsResting => LastTimeUs - FirstTimeUs >= RestUs;

        /// <summary>Found again in the frame being processed.</summary>
        public bool IsContinued;

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
            FirstRise = c.PeakRise;
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

        /// <summary>The light goes on: its place was that of its first frame.</summary>
        public void TakePlaceOf(in RememberedDot earlier)
        {
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
            if (!IsResting)
                return 2 * c.PeakRelativeRise >= PeakRelativeRise && 3 * c.Area >= Area && c.Area <= 3 * Area;
            int more = c.Plane == Plane ? 1 : 2;
            return 2 * LengthOf(c) <= 3 * Length + 4 && 2 * more * c.PeakRelativeRise >= PeakRelativeRise && 3 * c.Area >= Area && c.Area <= 3 * more * Area;
        }
    }

    /// <summary>
    /// The dots of the last frame. Where a dot shines the background must not learn, so that it stays a dot while it rests there, its
    /// end is seen, and the next shot at the same spot finds the wall as it was.
    /// </summary>
    internal sealed unsafe class DotMemory
    {
        private const int Capacity = 64;

        /// <summary>What may be left of the light when it goes out during an exposure, share of its first frame's.</summary>
        private const double MaxBrighterAfter = 0.6;

        /// <summary>How much darker than before the place may be, share of the rise.</summary>
        private const double MaxDarkerAfter = 0.15;

        /// <summary>Area through a resting dot's, up to which what rises inside it is a part of it.</summary>
        public const double MaxPartShare = 0.5;

        private RememberedDot[] _last = new RememberedDot[Capacity];
        private RememberedDot[] _now = new RememberedDot[Capacity];
        private readonly RememberedDot[] _hidden = new RememberedDot[Capacity];
        private int _lastCount;
        private int _nowCount;
        private int _hiddenCount;

        public void Clear() => _lastCount = _nowCount = _hiddenCount = 0;

        /// <summary>The next dot of the last frame, from the given one on, that has not been found in this frame.</summary>
        public bool TryNextLost(ref int index, out RememberedDot dot)
        {
            while (index < _lastCount)
            {
                dot = _last[index++];
                if (!dot.IsContinued && !IsFoundAgain(dot))
                    return true;
            }

            dot = default;
            return false;
        }

        /// <summary>Keeps a dot of the last frame that may be there although nothing shows it: it protects nothing and hides nothing.</summary>
        public void AddHidden(in RememberedDot dot)
        {
            if (_hiddenCount < Capacity)
                _hidden[_hiddenCount++] = dot;
        }

        /// <summary>The dot of the last frame that shone here.</summary>
        public bool TryFind(in Candidate candidate, out RememberedDot dot)
        {
            for (int i = 0; i < _lastCount; i++)
            {
                if (!_last[i].IsContinued && _last[i].GoesOnAs(candidate))
                {
                    dot = _last[i];
                    _last[i].IsContinued = true;
                    return true;
                }
            }

            dot = default;
            return false;
        }

        /// <summary>
        /// Inside a resting dot's light and much smaller than it: where noise lets the middle of the dot rise in the other plane, that
        /// is not another light. The share of its area.
        /// </summary>
        public bool IsPartOfResting(in Candidate candidate, out double areaShare)
        {
            for (int i = 0; i < _lastCount; i++)
            {
                ref RememberedDot dot = ref _last[i];
                areaShare = candidate.Area / dot.Area;
                if (dot.IsResting && dot.Plane != candidate.Plane && dot.Covers(candidate.CenterX, candidate.CenterY) && areaShare <= MaxPartShare)
                    return true;
            }

            areaShare = 0;
            return false;
        }

        /// <summary>True beside a dot already found in this frame, within one and a half of its size and a little: part of its halo.</summary>
        public bool IsHaloOf(in Candidate candidate, out double distance, out double reach)
        {
            distance = reach = 0;
            for (int i = 0; i < _nowCount; i++)
            {
                double dx = candidate.CenterX - 0.5 * (_now[i].Left + _now[i].Right), dy = candidate.CenterY - 0.5 * (_now[i].Top + _now[i].Bottom);
                distance = Math.Sqrt(dx * dx + dy * dy);
                reach = 4 + 0.75 * Math.Max(_now[i].Right - _now[i].Left, _now[i].Bottom - _now[i].Top);
                if (distance < reach)
                    return true;
            }

            return false;
        }

        /// <summary>True inside the light of a dot already found in this frame.</summary>
        public bool IsLit(int x, int y)
        {
            for (int i = 0; i < _nowCount; i++)
            {
                if (x >= _now[i].Left && x <= _now[i].Right && y >= _now[i].Top && y <= _now[i].Bottom)
                    return true;
            }

            return false;
        }

        public void ForgetProvisional()
        {
            int kept = 0;
            for (int i = 0; i < _nowCount; i++)
            {
                if (!_now[i].IsProvisional)
                    _now[kept++] = _now[i];
            }

            _nowCount = kept;
        }

        public void Add(in RememberedDot dot)
        {
            if (_nowCount < Capacity)
                _now[_nowCount++] = dot;
        }

        /// <summary>
        /// What light leaves behind is the wall as it was. A dot of the last frame that is none any more, but whose place does not look
        /// as it did before, has not gone out: something moved, or came from behind something else.
        /// </summary>
        public void ReportTraces(in FrameView view, double noise, Detections detections)
        {
            for (int i = 0; i < _lastCount; i++)
            {
                ref RememberedDot dot = ref _last[i];
                if ((dot.IsConclusive && !dot.MayBeContent) || IsFoundAgain(dot))
                    continue;
                dot.CompareWithPlace(view, noise, out double brighter, out double darker);
                brighter /= Math.Max(0.1, dot.FirstLight);
                bool isBrighter = brighter > MaxBrighterAfter;
                if (isBrighter || darker > MaxDarkerAfter)
                {
                    detections.Reject(new RejectedCandidate
                    {
                        PositionPx = dot.PositionPx,
                        Reason = RejectionReason.NotConfirmed,
                        Value = isBrighter ? brighter : darker,
                        Limit = isBrighter ? MaxBrighterAfter : MaxDarkerAfter,
                    });
                }
            }
        }

        private bool IsFoundAgain(in RememberedDot dot)
        {
            for (int i = 0; i < _nowCount; i++)
            {
                if (dot.Covers(0.5 * (_now[i].Left + _now[i].Right), 0.5 * (_now[i].Top + _now[i].Bottom)))
                    return true;
            }

            return false;
        }

        /// <summary>Gives the places of this frame's dots their background of before back, and makes this frame the last one.</summary>
        public void Protect(in FrameView view, TileGrid smallest, TileGrid largest)
        {
            for (int i = 0; i < _nowCount; i++)
            {
                RememberedDot dot = _now[i];
                smallest.Exempt(dot.Left, dot.Top, dot.Right, dot.Bottom);
                largest.Exempt(dot.Left, dot.Top, dot.Right, dot.Bottom);
                int x0 = Math.Max(0, dot.Left), count = Math.Min(view.Width - 1, dot.Right) - x0 + 1;
                for (int y = Math.Max(0, dot.Top); y <= Math.Min(view.Height - 1, dot.Bottom) && count > 0; y++)
                {
                    long row = (long)y * view.Width + x0;
                    Buffer.MemoryCopy(view.OldSmallest + row, view.NewSmallest + row, count, count);
                    Buffer.MemoryCopy(view.OldLargest + row, view.NewLargest + row, count, count);
                }
            }

            while (_hiddenCount > 0 && _nowCount < Capacity)
                _now[_nowCount++] = _hidden[--_hiddenCount];
            _hiddenCount = 0;
            (_last, _now) = (_now, _last);
            _lastCount = _nowCount;
            _nowCount = 0;
        }
    }
}
