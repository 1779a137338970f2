using System;
using LaserTracking.Geometry;

namespace LaserTracking.Health
{
    /// <summary>
    /// What the displacement of a whole picture looked like over time: a knocked camera steps from rest to rest, a picture that pans goes
    /// on and on. No allocation.
    /// </summary>
    internal sealed class StepEvidence
    {
        /// <summary>Bins within which the picture rests where it was, and looks that it must have done so for a step to count.</summary>
        private const double RestBins = 0.3;
        private const int LooksOfRest = 5;

        /// <summary>A knock is over within this time, or two looks where those are further apart: the one in between is blurred by it; most of the displacement lies in it.</summary>
        private const long KnockUs = 450_000;
        private const double KnockShare = 0.85;

        /// <summary>Motion that has gone on for so long is no knock.</summary>
        private const long ContinuingUs = 1_600_000;

        private const int Kept = 64;

        private readonly Vector2D[] _shifts = new Vector2D[Kept];
        private readonly long[] _times = new long[Kept];
        private int _count;
        private int _rested;
        private long _leftUs;
        private long _lastUs;
        private long _lookUs = long.MaxValue / 4;
        private bool _wasResting;

        /// <summary>Nothing is known of what was before: the next look compares with a new picture.</summary>
        public void Reset() => _count = _rested = 0;

        /// <param name="timeUs">Of this look.</param>
        /// <param name="shift">Against the picture that all looks compare with, bins.</param>
        public void Add(long timeUs, Vector2D shift)
        {
            if (timeUs > _lastUs && _count > 0)
                _lookUs = Math.Min(_lookUs, timeUs - _lastUs);
            _lastUs = timeUs;
            if (shift.Length <= RestBins)
            {
                _rested++;
                _count = 0;
                Push(timeUs, shift);
                return;
            }

            if (_count <= 1 || _rested > 0)
            {
                _wasResting = _rested >= LooksOfRest;
                _leftUs = timeUs;
                _rested = 0;
            }

            if (_count == Kept)
            {
                Array.Copy(_shifts, 1, _shifts, 0, Kept - 1);
                Array.Copy(_times, 1, _times, 0, Kept - 1);
                _count--;
            }

            Push(timeUs, shift);
        }

        /// <summary>It rested, and most of the way to where it is now it went at once.</summary>
        public bool IsStep
        {
            get
            {
                if (!_wasResting || _count < 2)
                    return false;
                double within = Math.Max(KnockUs, 2.2 * _lookUs), whole = _shifts[_count - 1].Length, most = 0;
                for (int i = 1; i < _count; i++)
                for (int k = i - 1; k >= 0 && _times[i] - _times[k] <= within; k--)
                    most = Math.Max(most, Vector2D.Dot(_shifts[i] - _shifts[k], _shifts[_count - 1]) / whole);
                return most >= KnockShare * whole;
            }
        }

        /// <summary>It has been on its way for long, and not by a step.</summary>
        public bool IsContinuing => _count > 1 && _rested == 0 && _times[_count - 1] - _leftUs >= ContinuingUs && !IsStep;

        private void Push(long timeUs, Vector2D shift)
        {
            _shifts[_count] = shift;
            _times[_count++] = timeUs;
        }
    }
}
