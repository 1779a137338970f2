using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Health
{
    /// <summary>Displacement of the picture by the edges of its screen, whatever is projected on it.</summary>
    internal sealed class EdgeMotion
    {
        /// <summary>Looks without an answer after which a probe at rest takes what it sees for its reference: the edge was dark before.</summary>
        private const int LooksToRenew = 5;

        /// <summary>Bins within which the camera counts as at rest.</summary>
        private const double RestBins = 0.35;

        private readonly EdgeProfiles _profiles = new EdgeProfiles();
        private readonly EdgeShift _solver = new EdgeShift();
        private readonly double[] _shifts = new double[EdgeProfiles.Probes];
        private readonly int[] _missed = new int[EdgeProfiles.Probes];
        private bool _isAtRest;

        public int BinPx => _profiles.BinPx;

        public bool TryLay(Vector2D[] outlinePx, int width, int height)
        {
            System.Array.Clear(_missed, 0, _missed.Length);
            _isAtRest = false;
            return _profiles.TryLay(outlinePx, width, height);
        }

        /// <summary>Reads this frame's share of the probes.</summary>
        public bool Look(Image image, int frame, int frames, bool isReference)
        {
            for (int probe = frame; probe < EdgeProfiles.Probes; probe += frames)
            {
                bool renews = isReference || (_isAtRest && _missed[probe] >= LooksToRenew);
                _shifts[probe] = double.NaN;
                if (!_profiles.TryFill(image, probe, renews))
                    continue;
                if (renews)
                    _missed[probe] = 0;
                else if (_profiles.TryMatch(probe, out double found))
                    (_shifts[probe], _missed[probe]) = (found, 0);
                else
                    _missed[probe]++;
            }

            return true;
        }

        /// <summary>What the edges of the last look say together, bins; the largest displacement of any of them.</summary>
        public bool TryAgree(out Vector2D shift, out double largest)
        {
            bool isKnown = _solver.TrySolve(_profiles, _shifts);
            shift = isKnown ? _solver.Shift : default;
            largest = isKnown ? _solver.LargestBins : 0;
            _isAtRest = isKnown && largest < RestBins;
            return isKnown;
        }
    }
}
