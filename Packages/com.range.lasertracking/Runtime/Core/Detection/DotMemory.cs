using System;

namespace LaserTracking.Detection
{
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
            if (_hiddenCount == Capacity)
                return;
            _hidden[_hiddenCount] = dot;
            _hidden[_hiddenCount++].IsHidden = true;
        }

        /// <summary>The dot of the last frame that shone here.</summary>
        public bool TryFind(in Candidate candidate, out RememberedDot dot)
        {
            int found = Find(candidate);
            dot = found < 0 ? default : _last[found];
            if (found < 0)
                return false;
            _last[found].IsContinued = true;
            return true;
        }

        /// <summary>Whether a dot of the last frame that is not decided yet goes on as this candidate.</summary>
        public bool IsWaiting(in Candidate candidate)
        {
            int found = Find(candidate);
            return found >= 0 && !_last[found].IsConclusive;
        }

        private int Find(in Candidate candidate)
        {
            for (int i = 0; i < _lastCount; i++)
            {
                if (!_last[i].IsContinued && _last[i].GoesOnAs(candidate))
                    return i;
            }

            return -1;
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

        /// <summary>This frame's dots raise no threshold in their tiles.</summary>
        public void Exempt(TileGrid tiles)
        {
            for (int i = 0; i < _nowCount; i++)
                tiles.Exempt(_now[i].Left, _now[i].Top, _now[i].Right, _now[i].Bottom);
        }

        /// <summary>Gives the places of this frame's dots their background of before back, and makes this frame the last one.</summary>
        public void Protect(in FrameView view, TileGrid smallest, TileGrid largest)
        {
            Exempt(smallest);
            Exempt(largest);
            for (int i = 0; i < _nowCount; i++)
            {
                RememberedDot dot = _now[i];
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
