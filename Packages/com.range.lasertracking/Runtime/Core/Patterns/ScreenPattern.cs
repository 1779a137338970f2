using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// What the projector shows for calibration: a coded checkerboard, its inverse, a second board half a cell beside it, and its
    /// inverse. The difference of a picture and its inverse is the projector's light alone: lamps, posters and furniture cancel. Half
    /// of each picture is white, so that a camera's automatic exposure has nothing to follow. Immutable.
    /// </summary>
    public sealed class ScreenPattern
    {
        /// <summary>How many pictures there are, in the order in which they are best shown.</summary>
        public const int Pictures = 4;

        private const int Samples = 4;
        private const double DisplayGamma = 2.2;

        private readonly ScreenBoard[] _boards;

        /// <param name="widthPx">Of the projector's picture, 160…16384.</param>
        /// <param name="heightPx">The same for its height; between 6/16 and 14/16 of the width.</param>
        /// <exception cref="ArgumentOutOfRangeException">Another size.</exception>
        public ScreenPattern(int widthPx, int heightPx)
        {
            if (!CanDraw(widthPx, heightPx))
                throw new ArgumentOutOfRangeException(nameof(widthPx));
            WidthPx = widthPx;
            HeightPx = heightPx;
            int down = ScreenBoard.CellsDownFor(widthPx / (double)heightPx);
            _boards = new[] { new ScreenBoard(down, false), new ScreenBoard(down, true) };
        }

        public int WidthPx { get; }

        public int HeightPx { get; }

        /// <summary>A picture that can hold the boards.</summary>
        public static bool CanDraw(int widthPx, int heightPx)
        {
            double down = ScreenBoard.CellsAcross * (double)heightPx / Math.Max(1, widthPx);
            return widthPx >= 160 && widthPx <= 16384 && down > ScreenBoard.LeastCellsDown - 0.5 && down < ScreenBoard.MostCellsDown + 0.5;
        }

        /// <summary>The board of a picture: 0 and 1 show the first, 2 and 3 the shifted one.</summary>
        public ScreenBoard Board(int picture) => _boards[picture / 2];

        /// <summary>Pictures 1 and 3 are the inverses of those before them.</summary>
        public static bool IsInverse(int picture) => picture % 2 != 0;

        /// <summary>Draws a picture as Gray8. Pixels that an edge crosses have the edge's share of light, so that it lies in its exact place.</summary>
        public void Draw(int picture, Image image)
        {
            image.Reset(PixelFormat.Gray8, WidthPx, HeightPx, 0);
            ScreenBoard board = Board(picture);
            byte white = 255, black = 0;
            if (IsInverse(picture))
                (white, black) = (black, white);
            double cellX = WidthPx / (double)ScreenBoard.CellsAcross, cellY = HeightPx / (double)board.CellsDown;
            for (int y = 0; y < HeightPx; y++)
            {
                Span<byte> row = image.Bytes.Slice(y * image.Stride, WidthPx);
                for (int x = 0; x < WidthPx; x++)
                {
                    bool isWhite = IsWhite(board, (x + 0.5) / cellX, (y + 0.5) / cellY);
                    row[x] = IsPlain(board, x / cellX, y / cellY, (x + 1) / cellX, (y + 1) / cellY, cellY)
                        ? isWhite ? white : black
                        : Mixed(board, x, y, cellX, cellY, IsInverse(picture));
                }
            }
        }

        private static bool IsWhite(ScreenBoard board, double x, double y)
        {
            double first = board.IsShifted ? 0.5 : 1;
            int column = (int)Math.Floor(x - first), row = (int)Math.Floor(y - first);
            bool isWhite = ScreenBoard.IsWhite(column, row);
            if (column < 0 || row < 0 || column >= board.Columns - 1 || row >= board.Rows - 1 || !board.HasDot(column, row))
                return isWhite;
            double dx = x - first - column - 0.5, dy = y - first - row - 0.5;
            return dx * dx + dy * dy < ScreenBoard.DotRadius * ScreenBoard.DotRadius ? !isWhite : isWhite;
        }

        /// <summary>No edge runs through a pixel: it lies within one cell and away from a dot's rim.</summary>
        private static bool IsPlain(ScreenBoard board, double left, double top, double right, double bottom, double cellPx)
        {
            double first = board.IsShifted ? 0.5 : 1;
            if (Math.Floor(left - first) != Math.Floor(right - first - 1e-9) || Math.Floor(top - first) != Math.Floor(bottom - first - 1e-9))
                return false;
            double dx = (left + right) / 2 - first, dy = (top + bottom) / 2 - first;
            dx -= Math.Floor(dx) + 0.5;
            dy -= Math.Floor(dy) + 0.5;
            return Math.Abs(Math.Sqrt(dx * dx + dy * dy) - ScreenBoard.DotRadius) > 1.5 / cellPx;
        }

        private static byte Mixed(ScreenBoard board, int x, int y, double cellX, double cellY, bool isInverse)
        {
            int whites = 0;
            for (int i = 0; i < Samples * Samples; i++)
            {
                if (IsWhite(board, (x + (i % Samples + 0.5) / Samples) / cellX, (y + (i / Samples + 0.5) / Samples) / cellY))
                    whites++;
            }

            double share = whites / (double)(Samples * Samples);
            return (byte)Math.Round(255 * Math.Pow(isInverse ? 1 - share : share, 1 / DisplayGamma));
        }
    }
}
