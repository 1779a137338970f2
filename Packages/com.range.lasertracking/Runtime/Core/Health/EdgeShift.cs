using System;
using LaserTracking.Geometry;

namespace LaserTracking.Health
{
    /// <summary>
    /// The displacement of the whole picture from what its screen's edges did: moved, turned, grown. Edges that somebody hides or that
    /// show something else now disagree and are left out.
    /// </summary>
    internal sealed class EdgeShift
    {
        private const int Unknowns = 4, Rounds = 5;

        /// <summary>Bins within which edges agree, and how many must.</summary>
        private const double AgreeBins = 0.8, LeastAgreement = 0.6;

        /// <summary>Edges without which nothing can be said.</summary>
        public const int LeastProbes = 8;

        private readonly double[,] _normal = new double[Unknowns, Unknowns];
        private readonly double[] _solution = new double[Unknowns];
        private readonly double[] _row = new double[Unknowns];

        /// <summary>Of the screen's middle, bins.</summary>
        public Vector2D Shift { get; private set; }

        /// <summary>How far the edge moved where it moved furthest, bins.</summary>
        public double LargestBins { get; private set; }

        /// <summary>Standard deviation of the largest displacement, from how far the edges that agree scatter, bins.</summary>
        public double SigmaBins { get; private set; }

        /// <param name="profiles">The probes' places.</param>
        /// <param name="shifts">Displacements outwards, bins; NaN: not known.</param>
        public bool TrySolve(EdgeProfiles profiles, double[] shifts)
        {
            int known = 0, used = 0;
            Vector2D middle = default;
            foreach (Vector2D place in profiles.Places)
                middle += place * (1.0 / EdgeProfiles.Probes);
            double radius = 0;
            foreach (Vector2D place in profiles.Places)
                radius = Math.Max(radius, (place - middle).Length);
            Array.Clear(_solution, 0, Unknowns);
            for (int round = 0; round < Rounds; round++)
            {
                Array.Clear(_normal, 0, _normal.Length);
                double tolerance = round == 0 ? double.PositiveInfinity : AgreeBins * (Rounds - round);
                known = used = 0;
                double a = 0, b = 0, c = 0, d = 0, squares = 0;
                for (int i = 0; i < shifts.Length; i++)
                {
                    if (double.IsNaN(shifts[i]))
                        continue;
                    known++;
                    Fill(profiles, i, middle, radius);
                    double miss = Predicted() - shifts[i];
                    if (Math.Abs(miss) > tolerance)
                        continue;
                    used++;
                    squares += miss * miss;
                    a += _row[0] * shifts[i];
                    b += _row[1] * shifts[i];
                    c += _row[2] * shifts[i];
                    d += _row[3] * shifts[i];
                    for (int row = 0; row < Unknowns; row++)
                    for (int column = 0; column < Unknowns; column++)
                        _normal[row, column] += _row[row] * _row[column];
                }

                // A little is held against turning and growing: a single pair of edges says nothing about them.
                _normal[2, 2] += 0.05 * used;
                _normal[3, 3] += 0.05 * used;
                if (used < LeastProbes || used < LeastAgreement * known || !IsFixed(used) || !Cholesky.TryFactor(_normal))
                    return false;
                (_solution[0], _solution[1], _solution[2], _solution[3]) = (a, b, c, d);
                Cholesky.Solve(_normal, _solution);

                // An edge shows one axis: each is known from half of them, the turn at the corners from about a third.
                SigmaBins = Math.Sqrt(squares / Math.Max(1, used - Unknowns)) * Math.Sqrt((2.0 + 2 + 3) / used);
            }

            Shift = new Vector2D(_solution[0], _solution[1]);
            double turn = _solution[2];
            LargestBins = 0;
            foreach (Vector2D place in profiles.Places)
            {
                Vector2D arm = (place - middle) * (1 / radius);
                LargestBins = Math.Max(LargestBins, (Shift + new Vector2D(-arm.Y, arm.X) * turn).Length);
            }

            return true;
        }

        private void Fill(EdgeProfiles profiles, int probe, Vector2D middle, double radius)
        {
            Vector2D normal = profiles.Normals[probe], arm = (profiles.Places[probe] - middle) * (1 / radius);
            _row[0] = normal.X;
            _row[1] = normal.Y;
            _row[2] = Vector2D.Dot(normal, new Vector2D(-arm.Y, arm.X));
            _row[3] = 1;
        }

        private double Predicted() => _row[0] * _solution[0] + _row[1] * _solution[1] + _row[2] * _solution[2] + _row[3] * _solution[3];

        /// <summary>Upright and level edges must both be there.</summary>
        private bool IsFixed(int used) => _normal[0, 0] > 0.08 * used && _normal[1, 1] > 0.08 * used;
    }
}
