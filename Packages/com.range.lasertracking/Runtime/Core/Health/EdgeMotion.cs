using System;
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

        /// <summary>Bins from which the probes follow.</summary>
        private const double FollowBins = 7;

        private readonly EdgeProfiles _profiles = new EdgeProfiles();
        private readonly EdgeShift _solver = new EdgeShift();
        private readonly double[] _shifts = new double[EdgeProfiles.Probes];
        private readonly int[] _missed = new int[EdgeProfiles.Probes];
        private bool _isAtRest;
        private readonly BinPicture _picture = new BinPicture();
        private readonly BrightOutline _outline = new BrightOutline();
        private readonly Vector2D[] _corners = new Vector2D[BrightOutline.Sides];
        private Vector2D _offset;
        private bool _isLost, _isRead;

        public int BinPx => _profiles.BinPx;

        /// <summary>Standard deviation of what the edges last agreed on, bins.</summary>
        public double SigmaBins => _solver.SigmaBins;

        public bool TryLay(Vector2D[] outlinePx, int width, int height)
        {
            Array.Clear(_missed, 0, _missed.Length);
            _isAtRest = _isLost = _isRead = false;
            _offset = default;
            bool isLaid = _profiles.TryLay(outlinePx, width, height);
            FindCorners(outlinePx);
            return isLaid;
        }

        /// <summary>Takes what this frame shows for the reference, all of it at once: a camera that moves meanwhile would tear it. False when too few edges are to be seen.</summary>
        public bool TryRefer(Image image)
        {
            int worth = 0;
            for (int probe = 0; probe < EdgeProfiles.Probes; probe++)
            {
                _missed[probe] = 0;
                _shifts[probe] = double.NaN;
                worth += _profiles.TryFill(image, probe, true, _offset) && _profiles.IsWorth(probe) ? 1 : 0;
            }

            return worth >= EdgeShift.LeastProbes;
        }

        /// <summary>Reads this frame's share of the probes.</summary>
        public void Look(Image image, int frame, int frames)
        {
            if (frame == 0)
                _isRead = _isLost;
            if (_isRead)
            {
                _picture.Fit(image);
                _picture.FillBand(image, frame, frames);
            }

            for (int probe = frame; probe < EdgeProfiles.Probes; probe += frames)
            {
                bool renews = _isAtRest && _missed[probe] >= LooksToRenew;
                _shifts[probe] = double.NaN;
                if (!_profiles.TryFill(image, probe, renews, _offset))
                    continue;
                if (renews)
                    _missed[probe] = 0;
                else if (_profiles.TryMatch(probe, out double found))
                    (_shifts[probe], _missed[probe]) = (found + Vector2D.Dot(_profiles.Normals[probe], _offset), 0);
                else
                    _missed[probe]++;
            }
        }

        /// <summary>What the edges of the last look say together, bins; the largest displacement of any of them.</summary>
        public bool TryAgree(out Vector2D shift, out double largest)
        {
            bool isKnown = _solver.TrySolve(_profiles, _shifts);
            shift = isKnown ? _solver.Shift : default;
            largest = isKnown ? _solver.LargestBins : 0;
            _isAtRest = isKnown && largest < RestBins;
            if (isKnown)
                _offset = shift.Length < FollowBins ? default : new Vector2D(Math.Round(shift.X), Math.Round(shift.Y));
            else if (_isRead)
                Search();
            _isLost = !isKnown;
            return isKnown;
        }

        /// <summary>After a knock further than a probe reaches: the bright outline, wherever it is now, says where to look.</summary>
        private void Search()
        {
            for (int side = 0; side < BrightOutline.Sides; side++)
                _outline.Look(_picture, side);
            _outline.SetRest(_picture, _corners);
            if (_outline.TryShift(_picture, out Vector2D shift))
                _offset = new Vector2D(Math.Round(shift.X), Math.Round(shift.Y));
        }

        private void FindCorners(Vector2D[] outlinePx)
        {
            double scale = 1.0 / _profiles.BinPx;
            for (int i = 0; i < BrightOutline.Sides; i++)
            {
                // Furthest towards upper left, upper right, lower right, lower left.
                double x = i == 1 || i == 2 ? 1 : -1, y = i >= 2 ? 1 : -1, furthest = double.NegativeInfinity;
                foreach (Vector2D p in outlinePx)
                {
                    if (x * p.X + y * p.Y <= furthest)
                        continue;
                    furthest = x * p.X + y * p.Y;
                    _corners[i] = p * scale;
                }
            }
        }
    }
}
