using System;
using LaserTracking.Detection;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Dual
{
    /// <summary>Counts what the ambient study saw, laser by laser.</summary>
    internal sealed class AmbientTally
    {
        private const double TolerancePx = 3;
        private const int FirstCountedFrame = 5;
        private const double FoundShare = 0.95;
        private int[] _seen = Array.Empty<int>();
        private int _frames;
        private double _errorPx;

        public int Lasers { get; private set; }

        public int Found { get; private set; }

        /// <summary>Laser and frame pairs that were seen.</summary>
        public int Seen { get; private set; }

        public int RightColor { get; private set; }

        public int Frames { get; private set; }

        public int FalseDots { get; private set; }

        public int FalseShots { get; private set; }

        public double MeanErrorPx => _errorPx / Math.Max(1, Seen);

        public void Begin(int lasers)
        {
            _seen = new int[lasers];
            _frames = 0;
            Lasers += lasers;
        }

        public void Add(int frame, ReadOnlySpan<TrueDot> truth, ReadOnlySpan<Dot> dots, ReadOnlySpan<Shot> shots, LaserColor color)
        {
            Frames++;
            foreach (Dot dot in dots)
                FalseDots += Nearest(truth, dot) < 0 ? 1 : 0;
            foreach (Shot shot in shots)
                FalseShots += Nearest(truth, shot.Dot) < 0 ? 1 : 0;
            if (frame < FirstCountedFrame)
                return;
            _frames++;
            for (int i = 0; i < truth.Length; i++)
            {
                foreach (Dot dot in dots)
                {
                    if (Nearest(truth, dot) != i)
                        continue;
                    _seen[i]++;
                    Seen++;
                    RightColor += dot.Color == color ? 1 : 0;
                    _errorPx += (dot.PositionPx - truth[i].PositionPx).Length;
                    break;
                }
            }
        }

        public void End()
        {
            foreach (int seen in _seen)
                Found += seen >= FoundShare * _frames ? 1 : 0;
        }

        private static int Nearest(ReadOnlySpan<TrueDot> truth, in Dot dot)
        {
            int nearest = -1;
            for (int i = 0; i < truth.Length; i++)
            {
                double distance = (truth[i].PositionPx - dot.PositionPx).Length;
                if (distance <= TolerancePx && (nearest < 0 || distance < (truth[nearest].PositionPx - dot.PositionPx).Length))
                    nearest = i;
            }

            return nearest;
        }
    }
}
