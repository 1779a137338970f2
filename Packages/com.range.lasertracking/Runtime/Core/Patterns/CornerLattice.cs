using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Saddle points joined into the grid of a checkerboard, grown from one of them: each next corner is expected where its
    /// neighbours put it, must have its edges along the grid, and must show dark where a checkerboard does. Cell (i, j) lies i corners
    /// along the seed's edge A and j along its edge B, so that axes turn clockwise in the picture and the square between (i, j) and
    /// (i + 1, j + 1) is dark where i + j is even.
    /// </summary>
    internal sealed class CornerLattice
    {
        private const int Side = 2 * BoardSize.Most + 8;
        private const double AlongSeedEdge = 0.21;
        private const double ReachOfStep = 0.3;
        private const double ParallelSine = 0.4;
        private const double LeastContrastRatio = 0.35;
        private const double LeastQuality = 0.75;
        private const int TrustedCorners = 6;

        private readonly int[] _cells = new int[Side * Side];
        private readonly List<Corner> _corners = new List<Corner>();
        private readonly SaddlePointFinder _finder;
        private readonly PointBuckets _buckets = new PointBuckets();
        private readonly int[] _memberOf = new int[SaddlePointFinder.MaximumPoints];
        private int _generation;

        /// <param name="finder">Finds the points, and is asked again where one is expected.</param>
        public CornerLattice(SaddlePointFinder finder) => _finder = finder;

        /// <summary>Corners of the grid.</summary>
        public int Count => _corners.Count;

        public int FirstI { get; private set; }

        public int LastI { get; private set; }

        public int FirstJ { get; private set; }

        public int LastJ { get; private set; }

        /// <summary>Takes the finder's last search for the next growths.</summary>
        public void Use(int width, int height)
        {
            _buckets.Fill(_finder.Points, width, height);
            Array.Clear(_memberOf, 0, _memberOf.Length);
            _generation = 0;
        }

        /// <summary>True when a point is part of the grid last grown.</summary>
        public bool Contains(int point) => _memberOf[point] == _generation;

        public bool TryGet(int i, int j, out SaddlePoint point)
        {
            int index = Index(i, j);
            point = index >= 0 ? _corners[index].Point : default;
            return index >= 0;
        }

        public bool TryGet(int i, int j, out Vector2D positionPx)
        {
            bool isThere = TryGet(i, j, out SaddlePoint point);
            positionPx = point.PositionPx;
            return isThere;
        }

        /// <summary>Grows a grid from one of the finder's points; <see cref="Count"/> says how far it came.</summary>
        public void Grow(int seed)
        {
            foreach (Corner corner in _corners)
                _cells[corner.Cell] = 0;
            _corners.Clear();
            _generation++;
            FirstI = LastI = FirstJ = LastJ = 0;
            SaddlePoint point = _finder.Points[seed];
            Add(0, 0, point, seed);
            AddAlong(point, point.EdgeA, 1, 0);
            AddAlong(point, point.EdgeB, 0, 1);
            // Again until nothing comes: what was out of reach may have got more neighbours since.
            for (int before = 0; before < _corners.Count;)
            {
                before = _corners.Count;
                for (int next = 0; next < _corners.Count; next++)
                {
                    int i = _corners[next].I, j = _corners[next].J;
                    TryExtend(i, j, 1, 0);
                    TryExtend(i, j, -1, 0);
                    TryExtend(i, j, 0, 1);
                    TryExtend(i, j, 0, -1);
                }
            }
        }

        /// <summary>The seed's neighbours both ways along an edge; where their distances do not fit together only the nearer.</summary>
        private void AddAlong(in SaddlePoint seed, Vector2D edge, int i, int j)
        {
            int ahead = NearestAlong(seed, edge, i != 0), behind = NearestAlong(seed, edge * -1, i != 0);
            double far = ahead < 0 ? double.MaxValue : (_finder.Points[ahead].PositionPx - seed.PositionPx).Length;
            double near = behind < 0 ? double.MaxValue : (_finder.Points[behind].PositionPx - seed.PositionPx).Length;
            if (ahead >= 0 && far < 2 * near)
                Add(i, j, _finder.Points[ahead], ahead);
            if (behind >= 0 && near < 2 * far)
                Add(-i, -j, _finder.Points[behind], behind);
        }

        private int NearestAlong(in SaddlePoint seed, Vector2D direction, bool alongA)
        {
            ReadOnlySpan<SaddlePoint> points = _finder.Points;
            int best = -1;
            double least = double.MaxValue;
            for (int k = 0; k < points.Length; k++)
            {
                Vector2D way = points[k].PositionPx - seed.PositionPx;
                double along = Vector2D.Dot(way, direction);
                if (along <= 0 || along >= least || Math.Abs(Vector2D.Cross(way, direction)) > AlongSeedEdge * along || Contains(k) || points[k].Quality < LeastQuality)
                    continue;
                // The neighbour's edges have changed roles.
                Vector2D same = alongA ? points[k].EdgeB : points[k].EdgeA, other = alongA ? points[k].EdgeA : points[k].EdgeB;
                Vector2D across = alongA ? seed.EdgeB : seed.EdgeA;
                if (!AreParallel(same, direction) || !AreParallel(other, across) || !AreAlike(seed.Contrast, points[k].Contrast))
                    continue;
                least = along;
                best = k;
            }

            return best;
        }

        private void TryExtend(int i, int j, int di, int dj)
        {
            int toI = i + di, toJ = j + dj;
            if (Math.Abs(toI) >= Side / 2 || Math.Abs(toJ) >= Side / 2 || Index(toI, toJ) >= 0)
                return;
            SaddlePoint here = _corners[Index(i, j)].Point;
            Vector2D sum = default;
            int votes = 0;
            if (TryGet(i - di, j - dj, out Vector2D behind))
            {
                sum += here.PositionPx * 2 - behind;
                votes++;
            }

            for (int side = -1; side <= 1; side += 2)
            {
                if (TryGet(i + side * dj, j + side * di, out Vector2D beside) && TryGet(toI + side * dj, toJ + side * di, out Vector2D besideTarget))
                {
                    sum += here.PositionPx + besideTarget - beside;
                    votes++;
                }
            }

            if (votes == 0)
                return;
            Vector2D expected = sum * (1.0 / votes), step = expected - here.PositionPx;
            double reach = ReachOfStep * step.Length;
            int nearest = _buckets.Nearest(_finder.Points, expected, reach);
            if (nearest >= 0 && !Contains(nearest) && Fits(here, _finder.Points[nearest], step, (toI + toJ) % 2 == 0, di != 0))
                Add(toI, toJ, _finder.Points[nearest], nearest);
            else if (_corners.Count >= TrustedCorners
                && _finder.TryFindNear(expected, reach, out SaddlePoint found)
                && Fits(here, found, step, (toI + toJ) % 2 == 0, di != 0))
                Add(toI, toJ, found, -1);
        }

        private static bool Fits(in SaddlePoint here, in SaddlePoint there, Vector2D step, bool isEven, bool alongI)
        {
            // In even cells edge A runs along i, in odd ones edge B.
            Vector2D along = isEven == alongI ? there.EdgeA : there.EdgeB, across = isEven == alongI ? there.EdgeB : there.EdgeA;
            Vector2D acrossHere = isEven == alongI ? here.EdgeA : here.EdgeB;
            return there.Quality >= LeastQuality && AreParallel(along, step * (1 / step.Length)) && AreParallel(across, acrossHere) && AreAlike(here.Contrast, there.Contrast);
        }

        private static bool AreParallel(Vector2D a, Vector2D b) => Math.Abs(Vector2D.Cross(a, b)) < ParallelSine;

        private static bool AreAlike(double a, double b) => a > LeastContrastRatio * b && b > LeastContrastRatio * a;

        private void Add(int i, int j, in SaddlePoint point, int number)
        {
            int cell = (j + Side / 2) * Side + i + Side / 2;
            _corners.Add(new Corner(i, j, cell, point));
            _cells[cell] = _corners.Count;
            if (number >= 0)
                _memberOf[number] = _generation;
            FirstI = Math.Min(FirstI, i);
            LastI = Math.Max(LastI, i);
            FirstJ = Math.Min(FirstJ, j);
            LastJ = Math.Max(LastJ, j);
        }

        private int Index(int i, int j)
        {
            if (Math.Abs(i) >= Side / 2 || Math.Abs(j) >= Side / 2)
                return -1;
            return _cells[(j + Side / 2) * Side + i + Side / 2] - 1;
        }

        private readonly struct Corner
        {
            public Corner(int i, int j, int cell, in SaddlePoint point)
            {
                I = i;
                J = j;
                Cell = cell;
                Point = point;
            }

            public int I { get; }

            public int J { get; }

            public int Cell { get; }

            public SaddlePoint Point { get; }
        }
    }
}
