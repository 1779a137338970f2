using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Finds a checkerboard of known size in a picture: saddle points on a pyramid of scales, grown into a grid, then each corner
    /// placed at full resolution in a window that follows the squares' size. Squares of 11 px and more, blur up to a third of a square,
    /// outer corners 7 px inside the picture. Not thread-safe; once warm only a refusal's reason is allocated.
    /// </summary>
    /// <remarks>
    /// Order of the corners: row by row, columns fastest, rows following clockwise upon columns in the picture (a board seen from its
    /// front; a mirrored picture of a checkerboard is a picture of a checkerboard, which nothing can tell). The first corner is the one
    /// whose square, between the first four corners, is dark: unambiguous where one of columns and rows is even and the other odd.
    /// Else half a turn changes nothing (with as many columns as rows and both even not even a quarter turn does), and of the orders
    /// that are left the one whose first column runs most nearly down the picture is taken. OpenCV's findChessboardCorners gives the
    /// same order where columns and rows differ in number.
    /// </remarks>
    public sealed class CheckerboardFinder : IBoardFinder
    {
        private const int SearchedPixels = 800_000;
        private const int LeastSide = 60;
        private const int MostLevels = 8;
        private const int MostSeeds = 400;
        private const int MostGrowthsOfPoint = 2;
        private const double LeastSeedQuality = 0.85;
        private const double LargestBend = 0.3;

        private readonly Image _gray = new Image();
        private readonly Image[] _smaller = new Image[MostLevels];
        private readonly SaddlePointFinder _finder = new SaddlePointFinder();
        private readonly CornerLattice _lattice;
        private readonly int[] _growths = new int[SaddlePointFinder.MaximumPoints];
        private readonly LatticeSummary _best = new LatticeSummary();
        private int _halvings;

        public CheckerboardFinder()
        {
            _lattice = new CornerLattice(_finder);
            for (int i = 0; i < MostLevels; i++)
                _smaller[i] = new Image();
        }

        /// <remarks>A refusal says how many corners were found, or that there is no board.</remarks>
        public bool TryFind(Image picture, BoardSize board, Span<Vector2D> cornersPx, out string reason)
        {
            if (board.Count == 0 || cornersPx.Length < board.Count)
                throw new ArgumentException($"{cornersPx.Length} places for {board.Count} corners", nameof(cornersPx));
            GrayConversion.ToGray(picture, _gray);
            _best.Clear();
            _halvings = 0;
            int first = 0;
            while ((long)(_gray.Width >> first) * (_gray.Height >> first) > SearchedPixels && first < MostLevels)
                first++;
            bool isFound = false;
            for (int level = first; level >= 0 && !isFound; level--)
                isFound = TryFindOnLevel(level, board, cornersPx);
            for (int level = first + 1; level <= MostLevels && Math.Min(_gray.Width, _gray.Height) >> level >= LeastSide && !isFound; level++)
                isFound = TryFindOnLevel(level, board, cornersPx);
            reason = isFound ? string.Empty : _best.Explain(board);
            return isFound;
        }

        public void Dispose()
        {
            _gray.Dispose();
            foreach (Image image in _smaller)
                image.Dispose();
        }

        private bool TryFindOnLevel(int level, BoardSize board, Span<Vector2D> cornersPx)
        {
            Image picture = Level(level);
            int count = _finder.Find(picture).Length;
            _lattice.Use(picture.Width, picture.Height);
            Array.Clear(_growths, 0, count);
            for (int seed = 0, tried = 0; seed < count && tried < MostSeeds; seed++)
            {
                if (_growths[seed] >= MostGrowthsOfPoint || _finder.Points[seed].Quality < LeastSeedQuality)
                    continue;
                tried++;
                _lattice.Grow(seed);
                for (int i = 0; i < count && _lattice.Count > 3; i++)
                    _growths[i] += _lattice.Contains(i) ? 1 : 0;
                _best.Consider(_lattice, picture.Width, picture.Height);
                if (_lattice.Count >= board.Count
                    && BoardWindow.TryFind(_lattice, board, out BoardWindow window)
                    && TryRefine(window, level, cornersPx))
                    return true;
            }

            return false;
        }

        /// <summary>The picture halved so many times.</summary>
        private Image Level(int level)
        {
            for (; _halvings < level; _halvings++)
                GrayConversion.Halve(_halvings == 0 ? _gray : _smaller[_halvings - 1], _smaller[_halvings]);
            return level == 0 ? _gray : _smaller[level - 1];
        }

        private bool TryRefine(in BoardWindow window, int level, Span<Vector2D> cornersPx)
        {
            BoardSize size = window.Size;
            double scale = 1 << level;
            for (int row = 0, k = 0; row < size.Rows; row++)
            for (int column = 0; column < size.Columns; column++, k++)
            {
                window.TryGet(_lattice, column, row, out SaddlePoint p);
                var position = new Vector2D((p.PositionPx.X + 0.5) * scale - 0.5, (p.PositionPx.Y + 0.5) * scale - 0.5);
                var start = new SaddlePoint(position, p.EdgeA, p.EdgeB, p.Contrast, p.Quality);
                double radius = SaddlePointRefiner.RadiusFor(scale * Spacing(window, column, row, p));
                if (!SaddlePointRefiner.TryRefine(_gray, start, radius, out SaddlePoint refined))
                    return false;
                cornersPx[k] = refined.PositionPx;
            }

            return IsSmooth(cornersPx, size);
        }

        /// <summary>Distance from a corner to the nearest edge that is not its own: through a neighbour, across the way to it.</summary>
        private double Spacing(in BoardWindow window, int column, int row, in SaddlePoint corner)
        {
            double least = double.MaxValue;
            for (int side = 0; side < 4; side++)
            {
                int dx = side == 0 ? 1 : side == 1 ? -1 : 0, dy = side == 2 ? 1 : side == 3 ? -1 : 0;
                if (window.TryGet(_lattice, column + dx, row + dy, out SaddlePoint next))
                    least = Math.Min(least, (next.PositionPx - corner.PositionPx).Length);
            }

            return least * Vector2D.Cross(corner.EdgeA, corner.EdgeB);
        }

        /// <summary>Every inner corner lies near the middle of its neighbours, along rows and along columns.</summary>
        private static bool IsSmooth(ReadOnlySpan<Vector2D> corners, BoardSize size)
        {
            for (int row = 0, k = 0; row < size.Rows; row++)
            for (int column = 0; column < size.Columns; column++, k++)
            {
                if (column > 0 && column < size.Columns - 1 && !IsBetween(corners[k - 1], corners[k], corners[k + 1]))
                    return false;
                if (row > 0 && row < size.Rows - 1 && !IsBetween(corners[k - size.Columns], corners[k], corners[k + size.Columns]))
                    return false;
            }

            return true;
        }

        private static bool IsBetween(Vector2D before, Vector2D middle, Vector2D after) =>
            (before + after - middle * 2).Length < LargestBend * (after - before).Length / 2;
    }
}
