using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Looks for heads over an arm's shoulder: the topmost surface in a box above it that belongs to no arm, of a head's width, then the
    /// next beside it: of neighbours who stand close the smaller one's head is no less theirs.
    /// Bounded work: only the cells in whose picture that box lies.
    /// </summary>
    internal sealed class HeadFinder
    {
        /// <summary>The box, from the arm's root: heads are at most so far beside, behind and above a shoulder.</summary>
        private const double AsideMm = 330;
        private const double BeforeMm = 150;
        private const double BehindMm = 550;
        private const double BelowMm = 60;
        private const double AboveMm = 480;

        private const double BinMm = 20;
        private const int Bins = (int)((BelowMm + AboveMm) / BinMm);

        /// <summary>Visible surface above the height that counts as the crown: no stray cell.</summary>
        private const double CrownAreaMm2 = 1500;

        /// <summary>A crown is at least so high above where an arm begins; else it is the shoulder itself.</summary>
        private const double MinAboveRootMm = 120;

        /// <summary>A camera below the heads does not see their crowns, and the edge of what it sees is lost. Measured.</summary>
        private const double HiddenCrownMm = 60;

        /// <summary>Neighbours' heads are at least so far apart; what is nearer to a head and lower is its shoulder.</summary>
        private const double NeighbourMm = 330;

        private const double HeadHeightMm = 200;
        private const double HeadRadiusMm = 130;

        /// <summary>From the front of the head as seen to between the eyes' sockets and the middle.</summary>
        private const double EyeDepthMm = 20;

        private readonly DepthHandSettings _settings;
        private readonly UprightFrame _upright;
        private readonly double[] _area = new double[Bins];
        private Vector3D[] _points = new Vector3D[1024];
        private double[] _areas = new double[1024];
        private int _count;

        public HeadFinder(DepthHandSettings settings, UprightFrame upright)
        {
            _settings = settings;
            _upright = upright;
        }

        /// <summary>The heads seen over an arm, highest first: its own person's and those of neighbours who stand close.</summary>
        /// <param name="grid">Depth.</param>
        /// <param name="owner">Which arm each cell belongs to, as of <see cref="BodySegmenter.Owner"/>.</param>
        /// <param name="arm">The arm's number: it is not its own head.</param>
        /// <param name="rootMm">The arm's rear end, camera space.</param>
        /// <param name="eyesMm">Room for the points between the eyes, upright space.</param>
        /// <returns>How many were found.</returns>
        public int Find(DepthGrid grid, byte[] owner, int arm, Vector3D rootMm, Span<Vector3D> eyesMm)
        {
            Vector3D root = _upright.ToUpright(rootMm);
            Gather(grid, owner, arm, root);
            int found = 0;
            while (found < eyesMm.Length && TryHead(root.Y, out Vector3D eye))
            {
                // Lower ones near a head are that person's shoulders.
                bool isWhole = Math.Abs(eye.X - root.X) <= AsideMm;
                for (int i = 0; i < found; i++)
                    isWhole &= Math.Abs(eyesMm[i].X - eye.X) >= NeighbourMm;
                if (isWhole)
                    eyesMm[found++] = eye;
                Remove(eye.X);
            }

            return found;
        }

        private bool TryCrown(double rootY, double x, double radius, out double crown)
        {
            Array.Clear(_area, 0, Bins);
            for (int i = 0; i < _count; i++)
            {
                if (Math.Abs(_points[i].X - x) <= radius)
                    _area[(int)((_points[i].Y - rootY + BelowMm) / BinMm)] += _areas[i];
            }

            double gathered = 0;
            int bin = Bins - 1;
            while (bin > 0 && (gathered += _area[bin]) < CrownAreaMm2)
                bin--;
            crown = rootY - BelowMm + (bin + 1) * BinMm;
            return crown - rootY >= MinAboveRootMm && bin < Bins - 1;
        }

        private bool TryHead(double rootY, out Vector3D eye)
        {
            eye = default;
            Vector3D middle = default;
            double near = 0, radius = double.MaxValue, deep = 2 * BinMm;
            double crown = 0;
            for (int step = 0; step < 4; step++)
            {
                // What else is as high beside it is somebody else's.
                if (!TryCrown(rootY, middle.X, radius, out crown) || !TryMean(crown - deep, crown + BinMm, middle.X, radius, out middle, out near))
                    return false;
                radius = HeadRadiusMm;
                deep = HeadHeightMm;
            }

            eye = new Vector3D(middle.X, crown + HiddenCrownMm - _settings.EyeBelowCrownMm, near + EyeDepthMm);
            return true;
        }

        /// <summary>Takes out what is at a head and below it.</summary>
        private void Remove(double x)
        {
            int kept = 0;
            for (int i = 0; i < _count; i++)
            {
                if (Math.Abs(_points[i].X - x) <= NeighbourMm - HeadRadiusMm)
                    continue;
                _points[kept] = _points[i];
                _areas[kept++] = _areas[i];
            }

            _count = kept;
        }

        private void Gather(DepthGrid grid, byte[] owner, int arm, Vector3D root)
        {
            _count = 0;
            Vector3D centre = _upright.ToCamera(root + new Vector3D(0, (AboveMm - BelowMm) / 2, (BehindMm - BeforeMm) / 2));
            if (centre.Z < 100)
                return;
            double cellRad = Math.Sqrt(grid.UnitArea), half = Math.Max(AsideMm + HeadRadiusMm, (AboveMm + BelowMm + BehindMm) / 2) / centre.Z;
            int reach = (int)(half / cellRad) + 1;
            int cx = (int)((centre.X / centre.Z - grid.RayX[0]) / cellRad), cy = (int)((centre.Y / centre.Z - grid.RayY[0]) / cellRad);
            int left = Math.Max(0, cx - reach), right = Math.Min(grid.Width - 1, cx + reach);
            for (int row = Math.Max(0, cy - reach); row <= Math.Min(grid.Height - 1, cy + reach); row++)
            {
                for (int column = left; column <= right; column++)
                {
                    int cell = row * grid.Width + column;
                    byte part = owner[cell];
                    if (grid.Z[cell] == 0 || (part > 0 && part < BodySegmenter.MaybeHead) || part == BodySegmenter.MaybeHead + arm)
                        continue;
                    Vector3D d = _upright.ToUpright(grid.Point(cell)) - root;
                    if (Math.Abs(d.X) > AsideMm + HeadRadiusMm || d.Y < -BelowMm || d.Y >= AboveMm || d.Z < -BeforeMm || d.Z > BehindMm)
                        continue;
                    if (_count == _points.Length)
                        return;
                    _points[_count] = d + root;
                    _areas[_count++] = grid.Area(cell);
                }
            }
        }

        private bool TryMean(double low, double high, double x, double radius, out Vector3D mean, out double near)
        {
            Vector3D sum = default;
            double area = 0, zz = 0;
            for (int i = 0; i < _count; i++)
            {
                Vector3D p = _points[i];
                if (p.Y < low || p.Y > high || Math.Abs(p.X - x) > radius)
                    continue;
                sum += p * _areas[i];
                zz += p.Z * p.Z * _areas[i];
                area += _areas[i];
            }

            mean = area > 0 ? sum * (1 / area) : default;
            // Front of the head: noise-proof, unlike the nearest cell.
            near = area > 0 ? mean.Z - Math.Sqrt(Math.Max(0, zz / area - mean.Z * mean.Z)) : 0;
            return area > 0;
        }
    }
}
