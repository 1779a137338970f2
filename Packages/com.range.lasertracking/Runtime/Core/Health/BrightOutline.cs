using System;
using LaserTracking.Geometry;

namespace LaserTracking.Health
{
    /// <summary>
    /// The outline of a projected picture in a darker room: four long straight borders, brighter inside all along, that meet in corners.
    /// Looked for side by side, one a call, so that no frame bears all of it.
    /// </summary>
    internal sealed unsafe class BrightOutline
    {
        public const int Sides = 4;
        private const int Scans = 22, Candidates = 3, Box = 4, LeastStep = 10, LeastSides = 3, LooksStill = 3;
        private const double OnLineBins = 1.3, LeastShare = 0.35, LeastCover = 0.75, MostSlope = 0.35, LeastWidthShare = 0.3, SameBins = 2, StillBins = 0.5, FarShare = 0.05;

        private readonly double[,] _found = new double[Scans, Candidates];
        private readonly int[] _counts = new int[Scans];
        private readonly double[] _offset = new double[Sides], _slope = new double[Sides];
        private readonly bool[,] _isOn = new bool[Sides, Scans];
        private readonly bool[] _has = new bool[Sides];
        private readonly double[] _restPlace = new double[Sides], _restSlope = new double[Sides], _middleBefore = new double[Sides];
        private readonly Vector2D[] _before = new Vector2D[Sides];
        private bool _hasBefore, _hasRest;
        private readonly int[] _still = new int[Sides];

        /// <summary>Upper left, upper right, lower right, lower left, bins.</summary>
        public Vector2D[] Corners { get; } = new Vector2D[Sides];

        /// <summary>An outline at rest was found to compare with.</summary>
        public bool IsKnown { get; private set; }

        public void Reset()
        {
            _hasBefore = _hasRest = IsKnown = false;
            Array.Clear(_still, 0, Sides);
        }

        /// <summary>Looks for one border: 0 left, 1 upper, 2 right, 3 lower.</summary>
        public void Look(BinPicture picture, int side)
        {
            bool isUpright = side % 2 == 0;
            int across = isUpright ? picture.Height : picture.Width, deep = isUpright ? picture.Width : picture.Height;
            for (int scan = 0; scan < Scans; scan++)
                Scan(picture, side, scan, Place(scan, across), deep);
            _has[side] = TryLine(side, across);
        }

        /// <summary>
        /// After four looks: whether the borders make an outline that rests. In a view at rest it must be the same twice; where what it
        /// encloses moves, it must lie still for longer, which proves that it is not a part of that.
        /// </summary>
        public bool TryFinish(BinPicture picture, bool isViewAtRest)
        {
            bool isOutline = _has[0] && _has[1] && _has[2] && _has[3] && MakeCorners(picture);
            bool isSame = isOutline && _hasBefore;
            int still = 0;
            for (int i = 0; i < Sides; i++)
            {
                isSame = isSame && (Corners[i] - _before[i]).Length < SameBins;
                _still[i] = _has[i] && Math.Abs(Middle(i) - _middleBefore[i]) < StillBins ? _still[i] + 1 : 0;
                still += _still[i] >= LooksStill ? 1 : 0;
                (_before[i], _middleBefore[i]) = (Corners[i], Middle(i));
            }

            _hasBefore = isOutline;
            if (isOutline && !_hasRest)
                Rest();
            if (isViewAtRest ? !isSame : !isOutline || still < LeastSides)
                return false;

            // Where it was seen first remains the place to compare with: the camera may have moved or crept since.
            bool isFirst = TryMeasure(picture, out Vector2D shift);
            if (!isFirst && !isViewAtRest && still < Sides)
                return false;
            IsKnown = true;
            if (isFirst)
                return shift.Length < StillBins;
            Rest();
            return true;
        }

        private double Middle(int side) => _offset[side] + _slope[side] * (Scans - 1) / 2;

        private void Rest()
        {
            _hasRest = true;
            for (int side = 0; side < Sides; side++)
                (_restPlace[side], _restSlope[side]) = (Middle(side), _slope[side]);
        }

        /// <summary>The borders to compare with, by corners in the order of <see cref="Corners"/>, bins.</summary>
        public void SetRest(BinPicture picture, Vector2D[] corners)
        {
            IsKnown = _hasRest = true;
            for (int side = 0; side < Sides; side++)
            {
                Vector2D from = corners[(side + Sides - 1) % Sides], way = corners[side] - from;
                bool isUpright = side % 2 == 0;
                int across = isUpright ? picture.Height : picture.Width;
                double per = isUpright ? way.X / way.Y : way.Y / way.X, middle = (Place(0, across) + Place(Scans - 1, across)) / 2;
                _restSlope[side] = per * across * 0.92 / (Scans - 1);
                _restPlace[side] = isUpright ? from.X + per * (middle - from.Y) : from.Y + per * (middle - from.X);
            }
        }

        /// <summary>After four looks: how far the borders that are seen went since, bins; false when fewer than three are seen or they disagree.</summary>
        public bool TryShift(BinPicture picture, out Vector2D shift)
        {
            shift = default;
            return IsKnown && TryMeasure(picture, out shift);
        }

        private bool TryMeasure(BinPicture picture, out Vector2D shift)
        {
            shift = default;
            double xx = 0, xy = 0, yy = 0, bx = 0, by = 0;
            int count = 0;
            for (int side = 0; side < Sides; side++)
            {
                if (!TryMiss(picture, side, shift, out double went, out double x, out double y))
                    continue;
                count++;
                xx += x * x;
                xy += x * y;
                yy += y * y;
                bx += x * went;
                by += y * went;
            }

            double determinant = xx * yy - xy * xy;
            if (count < LeastSides || determinant < 0.1)
                return false;
            shift = new Vector2D((yy * bx - xy * by) / determinant, (xx * by - xy * bx) / determinant);
            for (int side = 0; side < Sides; side++)
            {
                if (TryMiss(picture, side, shift, out double miss, out _, out _) && Math.Abs(miss) > OnLineBins + FarShare * shift.Length)
                    return false;
            }

            return true;
        }

        /// <summary>The borders are compared with where they are after a displacement from now on.</summary>
        public void Displace(BinPicture picture, Vector2D shift)
        {
            _hasBefore = false;
            for (int side = 0; side < Sides; side++)
                _restPlace[side] += side % 2 == 0 ? shift.X - Per(picture, side) * shift.Y : shift.Y - Per(picture, side) * shift.X;
        }

        /// <summary>How far a border's middle lies, along its short way, from where it rested and a displacement takes it; the coefficients of the displacement.</summary>
        private bool TryMiss(BinPicture picture, int side, Vector2D shift, out double miss, out double x, out double y)
        {
            double per = Per(picture, side);
            (x, y) = side % 2 == 0 ? (1.0, -per) : (-per, 1.0);
            miss = Middle(side) - _restPlace[side] - x * shift.X - y * shift.Y;
            return _has[side] && Math.Abs(_slope[side] - _restSlope[side]) * (Scans - 1) < 3 * OnLineBins;
        }

        private double Per(BinPicture picture, int side) => _restSlope[side] / ((side % 2 == 0 ? picture.Height : picture.Width) * 0.92 / (Scans - 1));

        private static double Place(int scan, int across) => across * (0.04 + 0.92 * scan / (Scans - 1));

        /// <summary>The first few places, from outside, at which one line of the picture grows brighter.</summary>
        private void Scan(BinPicture picture, int side, int scan, double place, int deep)
        {
            int width = picture.Width, end = deep * 3 / 5;
            bool isUpright = side % 2 == 0, isFar = side >= 2;
            int along = isUpright ? 1 : width, start = isUpright ? (int)place * width : (int)place;
            if (isFar)
            {
                start += (deep - 1) * along;
                along = -along;
            }

            int count = 0;
            double before = 0, last = 0, lastAt = 0;
            fixed (byte* levels = picture.Levels)
            {
                byte* p = levels + start;
                for (int i = Box; i < end && count < Candidates; i++)
                {
                    int step = 0;
                    for (int k = 0; k < Box; k++)
                        step += p[(i + k) * along] - p[(i - 1 - k) * along];

                    // A place between two bins: before bin i.
                    if (last >= Box * LeastStep && last >= before && last > step)
                    {
                        double bend = before - 2 * last + step;
                        _found[scan, count++] = lastAt - 0.5 + (bend < 0 ? 0.5 * (before - step) / bend : 0);
                    }

                    (before, last, lastAt) = (last, step, i);
                }
            }

            for (int i = 0; i < count && isFar; i++)
                _found[scan, i] = deep - 1 - _found[scan, i];
            _counts[scan] = count;
        }

        /// <summary>The straight line through most of the places: place = offset + slope × scan.</summary>
        private bool TryLine(int side, int across)
        {
            int most = 0;
            double spacing = across * 0.92 / (Scans - 1);
            for (int i = 0; i < Scans; i++)
            for (int a = 0; a < _counts[i]; a++)
            for (int k = i + 5; k < Scans; k++)
            for (int b = 0; b < _counts[k]; b++)
            {
                double slope = (_found[k, b] - _found[i, a]) / (k - i), offset = _found[i, a] - slope * i;
                if (Math.Abs(slope) > MostSlope * spacing)
                    continue;
                int on = 0;
                for (int j = 0; j < Scans; j++)
                    on += Math.Abs(Nearest(j, offset + slope * j)) <= OnLineBins ? 1 : 0;
                if (on > most)
                    (most, _offset[side], _slope[side]) = (on, offset, slope);
            }

            double n = 0, sj = 0, sjj = 0, sp = 0, sjp = 0;
            for (int j = 0; j < Scans && most > 0; j++)
            {
                double miss = Nearest(j, _offset[side] + _slope[side] * j);
                _isOn[side, j] = Math.Abs(miss) <= OnLineBins;
                if (!_isOn[side, j])
                    continue;
                double place = _offset[side] + _slope[side] * j + miss;
                n++;
                sj += j;
                sjj += j * j;
                sp += place;
                sjp += j * place;
            }

            // Two points made the line; all that lie on it mend it.
            if (n * sjj - sj * sj > 0)
            {
                _slope[side] = (n * sjp - sj * sp) / (n * sjj - sj * sj);
                _offset[side] = (sp - _slope[side] * sj) / n;
            }

            return most >= LeastShare * Scans;
        }

        /// <summary>From a place to the nearest that was found in a scan.</summary>
        private double Nearest(int scan, double place)
        {
            double nearest = double.PositiveInfinity;
            for (int i = 0; i < _counts[scan]; i++)
            {
                if (Math.Abs(_found[scan, i] - place) < Math.Abs(nearest))
                    nearest = _found[scan, i] - place;
            }

            return nearest;
        }

        private bool MakeCorners(BinPicture picture)
        {
            for (int i = 0; i < Sides; i++)
            {
                // Corner i lies between side i and the next one; an upright side gives x from y, a level one y from x.
                int upright = i % 2 == 0 ? i : (i + 1) % Sides, level = i % 2 == 0 ? (i + 1) % Sides : i;
                Line(upright, picture.Height, out double xAt0, out double xPerY);
                Line(level, picture.Width, out double yAt0, out double yPerX);
                double y = (yAt0 + yPerX * xAt0) / (1 - yPerX * xPerY);
                Corners[i] = new Vector2D(xAt0 + xPerY * y, y);
            }

            for (int i = 0; i < Sides; i++)
            {
                Vector2D from = Corners[(i + Sides - 1) % Sides], to = Corners[i];
                bool isUpright = i % 2 == 0;
                double a = isUpright ? from.Y : from.X, b = isUpright ? to.Y : to.X, length = Math.Abs(b - a), low = Math.Min(a, b), margin = 0.05 * length;
                int inside = 0, on = 0;
                for (int j = 0; j < Scans; j++)
                {
                    double place = Place(j, isUpright ? picture.Height : picture.Width);
                    if (place < low + margin || place > low + length - margin)
                        continue;
                    inside++;
                    on += _isOn[i, j] ? 1 : 0;
                }

                if (length < LeastWidthShare * (isUpright ? picture.Height : picture.Width) || on < LeastCover * inside)
                    return false;
            }

            return Corners[0].X < Corners[1].X && Corners[3].X < Corners[2].X && Corners[0].Y < Corners[3].Y && Corners[1].Y < Corners[2].Y;
        }

        private void Line(int side, int across, out double at0, out double per)
        {
            per = _slope[side] / (across * 0.92 / (Scans - 1));
            at0 = _offset[side] - per * Place(0, across);
        }
    }
}
