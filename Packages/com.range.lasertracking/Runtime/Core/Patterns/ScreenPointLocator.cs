using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Measures every point of a board in the full picture once some of its points are known: each is looked for where its neighbours
    /// say that it must be, and tells why when it is not there.
    /// </summary>
    internal sealed class ScreenPointLocator
    {
        private const int Rounds = 3;

        /// <summary>Shares of a cell: how far a point may lie from where it is expected, and where its four cells' colours are read.</summary>
        private const double LargestMiss = 0.2, Aside = 0.22;

        /// <summary>Radius of the window in which the edges' model is fitted: a share of a cell, and at most so many pixels.</summary>
        private const double Window = 0.25, LargestWindowPx = 20;

        /// <summary>Rings around a corner, shares of a cell, and places looked at on both together.</summary>
        private const double InnerRing = 0.13, OuterRing = 0.26;
        private const int RingSteps = 24;

        /// <summary>Above it something is half in the way: such corners lie off by pixels. In small cells the pixels' own grain adds to it.</summary>
        private const double LargestAsymmetry = 0.015, CoarseCellPx = 30;

        /// <summary>Levels of contrast below which there is nothing to measure.</summary>
        private const double LeastContrast = 1.5;

        /// <summary>Contrast of a point as a share of that around it: less is no screen, or not all of the time.</summary>
        private const double LeastRelativeContrast = 0.72;

        /// <summary>Points along both ways from whose contrasts their growth is taken, how many of them it takes, and how alike they must be.</summary>
        private const int GrowthReach = 3, LeastForGrowth = 12;
        private const double MostUnlike = 0.3;

        private readonly ScreenBoard _board;
        private readonly SignalPicture _signal;
        private readonly double _sign;
        private readonly ScreenPoint[] _points;
        private readonly Vector2D[] _known;
        private readonly bool[] _isKnown;

        /// <param name="board">What is seen.</param>
        /// <param name="signal">Where.</param>
        /// <param name="isUpright">White cells are the bright ones.</param>
        public ScreenPointLocator(ScreenBoard board, SignalPicture signal, bool isUpright)
        {
            _board = board;
            _signal = signal;
            _sign = isUpright ? 1 : -1;
            _points = new ScreenPoint[board.Count];
            _known = new Vector2D[board.Count];
            _isKnown = new bool[board.Count];
        }

        /// <summary>All points of the board, row by row; null when the known ones do not fix the plane.</summary>
        public ScreenPoint[]? Locate(Dictionary<(int Column, int Row), Vector2D> known)
        {
            foreach (KeyValuePair<(int Column, int Row), Vector2D> point in known)
                Know(point.Key.Row * _board.Columns + point.Key.Column, point.Value);
            for (int round = 0; round < Rounds; round++)
            {
                if (!TryFit(out Homography toImage))
                    return null;
                for (int i = 0; i < _points.Length; i++)
                    _points[i] = Measure(i, toImage);
                for (int i = 0; i < _points.Length; i++)
                {
                    _isKnown[i] = false;
                    if (_points[i].State == ScreenPointState.Measured && _points[i].Contrast < LeastRelativeContrast * Around(i))
                        _points[i] = new ScreenPoint(_points[i].Place, ScreenPointState.Covered, _points[i].ImagePx, _points[i].Contrast, _points[i].Symmetry, 0);
                }

                for (int i = 0; i < _points.Length; i++)
                {
                    if (_points[i].State == ScreenPointState.Measured)
                        Know(i, _points[i].ImagePx);
                }
            }

            return _points;
        }

        private void Know(int index, Vector2D px)
        {
            _known[index] = px;
            _isKnown[index] = true;
        }

        private Vector2D PlaceOf(int index) => _board.Place(index % _board.Columns, index / _board.Columns);

        private bool TryFit(out Homography toImage)
        {
            var from = new List<Vector2D>();
            var to = new List<Vector2D>();
            for (int i = 0; i < _known.Length; i++)
            {
                if (!_isKnown[i])
                    continue;
                from.Add(PlaceOf(i));
                to.Add(_known[i]);
            }

            return HomographyEstimator.TryFit(from.ToArray(), to.ToArray(), out toImage, out _);
        }

        private ScreenPoint Measure(int index, Homography toImage)
        {
            Vector2D place = PlaceOf(index);
            Vector2D expected = toImage.Map(place) + Correction(index, toImage);
            toImage.Jacobian(place, out double xx, out double xy, out double yx, out double yy);
            var along = new Vector2D(xx / ScreenBoard.CellsAcross, yx / ScreenBoard.CellsAcross);
            var across = new Vector2D(xy / _board.CellsDown, yy / _board.CellsDown);
            double cell = Math.Min(along.Length, across.Length);
            int window = CornerRefiner.HalfWindow(cell);
            double room = Math.Max(window + 3, 0.3 * cell);
            if (!(expected.X >= room && expected.Y >= room && expected.X < _signal.Full.Width - room && expected.Y < _signal.Full.Height - room))
                return new ScreenPoint(place, ScreenPointState.OutOfPicture, expected, 0, 0, 0);
            bool isWhite = ScreenBoard.IsWhite(index % _board.Columns, index / _board.Columns);
            double sign = isWhite ? _sign : -_sign;
            Vector2D corner = expected;
            bool isFound = CornerRefiner.TryRefine(_signal.Full, window, SignalPicture.Middle, Growth(index), ref corner) && (corner - expected).Length <= LargestMiss * cell;
            if (isFound)
                corner = Cross(corner, along, across, sign, cell, Growth(index));
            double contrast = sign * Contrast(isFound ? corner : expected, along, across, out double least);
            if (contrast < LeastContrast || least * sign < 0)
                return new ScreenPoint(place, ScreenPointState.Covered, expected, contrast, 0, 0);
            double symmetry = isFound ? Symmetry(corner, along, across) : 0;
            double grain = Math.Max(1, CoarseCellPx / cell);
            return symmetry >= 1 - LargestAsymmetry * grain * grain
                ? new ScreenPoint(place, ScreenPointState.Measured, corner, contrast, symmetry, Blur(corner, along, across, contrast))
                : new ScreenPoint(place, ScreenPointState.Unclear, expected, contrast, symmetry, 0);
        }

        /// <summary>
        /// The place where the two blurred edges cross, by their model: steepness, which the refiner goes by, is drawn aside by uneven
        /// light with the square of the blur. Where the model does not fit the corner stays.
        /// </summary>
        private Vector2D Cross(Vector2D corner, Vector2D along, Vector2D across, double sign, double cell, Vector2D growth)
        {
            Vector2D a = along * (1 / along.Length), b = across * (1 / across.Length);
            bool isMirrored = Vector2D.Cross(a, b) < 0;
            if (isMirrored)
                (a, b) = (b, a);

            // The model is bright where a point lies before one edge and behind the other.
            if (sign > 0)
                (a, b) = (b, a * -1);
            double radius = Math.Max(SaddlePointRefiner.SmallestRadiusPx, Math.Min(LargestWindowPx, Window * cell));
            var start = new SaddlePoint(corner, a, b, 2 * SignalPicture.Swing, 1);
            return SaddlePointRefiner.TryRefine(_signal.Full, start, radius, SignalPicture.Middle, growth, out SaddlePoint refined) ? refined.PositionPx : corner;
        }

        /// <summary>What the nearest known points lie beside the plane's fit: lenses bend, walls are uneven.</summary>
        private Vector2D Correction(int index, Homography toImage)
        {
            int column = index % _board.Columns, row = index / _board.Columns;
            Vector2D sum = default;
            double weights = 0;
            for (int i = 0; i < _known.Length; i++)
            {
                int dc = i % _board.Columns - column, dr = i / _board.Columns - row, squared = dc * dc + dr * dr;
                if (!_isKnown[i] || squared == 0 || squared > 18)
                    continue;
                double weight = 1.0 / (squared * squared);
                sum += (_known[i] - toImage.Map(PlaceOf(i))) * weight;
                weights += weight;
            }

            return weights > 0 ? sum * (1 / weights) : default;
        }

        /// <summary>Half of white minus black over the four cells, above zero where the one right and below is bright; and the weakest cell's share.</summary>
        private double Contrast(Vector2D corner, Vector2D along, Vector2D across, out double least)
        {
            double sum = 0, weakest = double.PositiveInfinity, mean = 0;
            Span<double> cells = stackalloc double[4];
            for (int i = 0; i < 4; i++)
            {
                Vector2D p = corner + along * (i % 2 == 0 ? Aside : -Aside) + across * (i / 2 == 0 ? Aside : -Aside);
                cells[i] = _signal.At(p);
                mean += cells[i] / 4;
            }

            for (int i = 0; i < 4; i++)
                sum += (i == 0 || i == 3 ? 1 : -1) * (cells[i] - mean) / 4;
            for (int i = 0; i < 4; i++)
                weakest = Math.Min(weakest, (i == 0 || i == 3 ? 1 : -1) * (cells[i] - mean) * Math.Sign(sum));
            least = weakest * Math.Sign(sum);
            return sum;
        }

        /// <summary>On two rings around a corner: what is the same on opposite sides, through all that is not the mean.</summary>
        private double Symmetry(Vector2D corner, Vector2D along, Vector2D across)
        {
            double even = 0, odd = 0, mean = 0;
            Span<double> sums = stackalloc double[RingSteps];
            for (int i = 0; i < RingSteps; i++)
            {
                double angle = 2 * Math.PI * i / RingSteps, radius = i % 2 == 0 ? OuterRing : InnerRing;
                Vector2D arm = along * (radius * Math.Cos(angle)) + across * (radius * Math.Sin(angle));
                double here = _signal.At(corner + arm), there = _signal.At(corner - arm);
                sums[i] = here + there;
                odd += (here - there) * (here - there);
                mean += sums[i] / RingSteps;
            }

            foreach (double sum in sums)
                even += (sum - mean) * (sum - mean);
            return even / (even + odd);
        }

        /// <summary>Steepness of the four edges near the corner against their height, as the standard deviation of a Gaussian blur.</summary>
        private double Blur(Vector2D corner, Vector2D along, Vector2D across, double contrast)
        {
            double slope = 0;
            for (int i = 0; i < 4; i++)
            {
                Vector2D way = i < 2 ? along : across, side = i < 2 ? across : along, p = corner + way * (i % 2 == 0 ? Aside : -Aside), step = side * (1 / side.Length);
                Vector2D a = p - step, b = p + step;
                slope += Math.Abs(_signal.At(b) - _signal.At(a)) / 8;
            }

            double sigma = 2 * contrast / (Math.Sqrt(2 * Math.PI) * Math.Max(1e-9, slope));

            // The slope over two pixels, read between pixels, has a blur of its own.
            return Math.Sqrt(Math.Max(0, sigma * sigma - 0.5));
        }

        /// <summary>
        /// By which share the contrast grows a pixel at a point, after the last round: a plane through the logarithms around it. Lamps and
        /// vignetting change it over the picture, by the camera's gamma. Zero where too little is known.
        /// </summary>
        private Vector2D Growth(int index)
        {
            ScreenPoint here = _points[index];
            if (!(here.Contrast > 0))
                return default;
            int column = index % _board.Columns, row = index / _board.Columns, count = 0;
            double x = 0, y = 0, level = 0, xx = 0, xy = 0, yy = 0, xLevel = 0, yLevel = 0;
            for (int r = Math.Max(0, row - GrowthReach); r <= Math.Min(_board.Rows - 1, row + GrowthReach); r++)
            {
                for (int c = Math.Max(0, column - GrowthReach); c <= Math.Min(_board.Columns - 1, column + GrowthReach); c++)
                {
                    ScreenPoint point = _points[r * _board.Columns + c];
                    if (point.State != ScreenPointState.Measured || !(point.Contrast > 0) || !(Math.Abs(Math.Log(point.Contrast / here.Contrast)) < MostUnlike))
                        continue;
                    Vector2D off = point.ImagePx - here.ImagePx;
                    double logarithm = Math.Log(point.Contrast);
                    count++;
                    (x, y, level) = (x + off.X, y + off.Y, level + logarithm);
                    (xx, xy, yy) = (xx + off.X * off.X, xy + off.X * off.Y, yy + off.Y * off.Y);
                    (xLevel, yLevel) = (xLevel + off.X * logarithm, yLevel + off.Y * logarithm);
                }
            }

            if (count < LeastForGrowth)
                return default;
            (xx, xy, yy) = (xx - x * x / count, xy - x * y / count, yy - y * y / count);
            (xLevel, yLevel) = (xLevel - x * level / count, yLevel - y * level / count);
            double determinant = xx * yy - xy * xy;
            return determinant > 0.01 * xx * yy ? new Vector2D((yy * xLevel - xy * yLevel) / determinant, (xx * yLevel - xy * xLevel) / determinant) : default;
        }

        private double Around(int index)
        {
            int column = index % _board.Columns, row = index / _board.Columns, count = 0;
            Span<double> around = stackalloc double[25];
            for (int r = Math.Max(0, row - 2); r <= Math.Min(_board.Rows - 1, row + 2); r++)
            {
                for (int c = Math.Max(0, column - 2); c <= Math.Min(_board.Columns - 1, column + 2); c++)
                {
                    ScreenPoint point = _points[r * _board.Columns + c];
                    if (point.State == ScreenPointState.Measured && (r != row || c != column))
                        around[count++] = point.Contrast;
                }
            }

            if (count < 3)
                return 0;
            double[] sorted = around.Slice(0, count).ToArray();
            Array.Sort(sorted);
            return sorted[count / 2];
        }
    }
}
