using System;
using LaserTracking.Geometry;

namespace LaserTracking.Health
{
    /// <summary>
    /// The one displacement that most cells of a picture agree with. A straight edge says nothing of the way along it: each cell counts
    /// with its structure tensor.
    /// </summary>
    internal sealed class ViewShift
    {
        private const double AgreeBins = 0.75, LeastShare = 0.6, LeastEigenShare = 0.08;
        private const int LeastCells = 5, Rounds = 3;

        private readonly Vector2D[] _shifts;
        private readonly double[] _xx, _xy, _yy;
        private int _count;

        /// <param name="capacity">Cells at most.</param>
        public ViewShift(int capacity)
        {
            _shifts = new Vector2D[capacity];
            _xx = new double[capacity];
            _xy = new double[capacity];
            _yy = new double[capacity];
        }

        public void Clear() => _count = 0;

        /// <summary>One cell's displacement, bins, with its structure tensor.</summary>
        public void Add(Vector2D shift, double xx, double xy, double yy)
        {
            double trace = xx + yy;
            if (!(trace > 0))
                return;
            _shifts[_count] = shift;
            (_xx[_count], _xy[_count], _yy[_count]) = (xx / trace, xy / trace, yy / trace);
            _count++;
        }

        /// <param name="expected">About where it is looked for, bins.</param>
        /// <param name="shift">Bins.</param>
        public bool TrySolve(Vector2D expected, out Vector2D shift)
        {
            shift = expected;
            if (_count < LeastCells)
                return false;
            double best = -1;
            Vector2D middle = new Vector2D(Math.Round(expected.X), Math.Round(expected.Y)), at = middle;
            for (int y = -CellMatch.Reach; y <= CellMatch.Reach; y++)
            for (int x = -CellMatch.Reach; x <= CellMatch.Reach; x++)
            {
                Vector2D tried = middle + new Vector2D(x, y);
                double score = 0;
                for (int i = 0; i < _count; i++)
                    score += Math.Max(0, 1 - Miss(i, tried) / (4 * AgreeBins * AgreeBins));

                // Of equals, as a grid of straight lines has many, the one that moves less.
                if (score > best + 1e-9 || (score > best - 1e-9 && (tried - expected).LengthSquared < (at - expected).LengthSquared))
                    (best, at) = (score, tried);
            }

            shift = at;
            int agreed = 0;
            for (int round = 0; round < Rounds; round++)
            {
                double xx = 0, xy = 0, yy = 0, bx = 0, by = 0, limit = AgreeBins * AgreeBins * (round == 0 ? 2 : 1);
                agreed = 0;
                for (int i = 0; i < _count; i++)
                {
                    if (Miss(i, shift) > limit)
                        continue;
                    agreed++;
                    xx += _xx[i];
                    xy += _xy[i];
                    yy += _yy[i];
                    bx += _xx[i] * _shifts[i].X + _xy[i] * _shifts[i].Y;
                    by += _xy[i] * _shifts[i].X + _yy[i] * _shifts[i].Y;
                }

                double determinant = xx * yy - xy * xy;
                if (agreed < LeastCells || agreed < LeastShare * _count || determinant < LeastEigenShare * (xx + yy) * (xx + yy) / 2)
                    return false;
                shift = new Vector2D((yy * bx - xy * by) / determinant, (xx * by - xy * bx) / determinant);
            }

            return true;
        }

        /// <summary>Squared distance that counts: across the cell's edges.</summary>
        private double Miss(int i, Vector2D tried)
        {
            Vector2D d = tried - _shifts[i];
            return _xx[i] * d.X * d.X + 2 * _xy[i] * d.X * d.Y + _yy[i] * d.Y * d.Y;
        }
    }
}
