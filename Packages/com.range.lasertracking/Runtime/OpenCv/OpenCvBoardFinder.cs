using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Patterns;
using OpenCvSharp;

namespace LaserTracking.OpenCv
{
    /// <summary>
    /// A second opinion on board corners: OpenCV's findChessboardCornersSB (Duda and Frese 2018), brought into our order of corners. Where it
    /// and <see cref="CheckerboardFinder"/> differ by more than a tenth of a pixel, look at the picture.
    /// </summary>
    public sealed class OpenCvBoardFinder : IBoardFinder
    {
        private readonly Image _gray = new Image();

        public unsafe bool TryFind(Image picture, BoardSize board, Span<Vector2D> cornersPx, out string reason)
        {
            if (board.Count == 0 || cornersPx.Length < board.Count)
                throw new ArgumentException($"{cornersPx.Length} places for {board.Count} corners", nameof(cornersPx));
            GrayConversion.ToGray(picture, _gray);
            Point2f[] found;
            try
            {
                using Mat mat = Mat.FromPixelData(_gray.Height, _gray.Width, MatType.CV_8UC1, (IntPtr)_gray.Pixels, _gray.Stride);
                bool isFound = Cv2.FindChessboardCornersSB(mat, new Size(board.Columns, board.Rows), out found, ChessboardFlags.NormalizeImage | ChessboardFlags.Accuracy);
                reason = isFound && found.Length == board.Count ? string.Empty : "OpenCV finds no board of " + board + " inner corners";
            }
            catch (OpenCVException problem)
            {
                found = Array.Empty<Point2f>();
                reason = "OpenCV refuses the picture (" + problem.Message.Split('\n')[0].TrimEnd('\r', '.') + ")";
            }

            if (reason.Length > 0)
                return false;
            for (int i = 0; i < found.Length; i++)
                cornersPx[i] = new Vector2D(found[i].X, found[i].Y);
            Order(board, cornersPx.Slice(0, board.Count));
            return true;
        }

        public void Dispose() => _gray.Dispose();

        /// <summary>OpenCV may begin at any corner and go round either way.</summary>
        private void Order(BoardSize board, Span<Vector2D> corners)
        {
            Vector2D right = corners[board.Columns - 1] - corners[0], down = corners[board.Count - board.Columns] - corners[0];
            if (Vector2D.Cross(right, down) < 0)
            {
                for (int row = 0; row < board.Rows; row++)
                    corners.Slice(row * board.Columns, board.Columns).Reverse();
                down = corners[board.Count - board.Columns] - corners[0];
            }

            bool isTurned = board.IsSymmetric ? down.Y < 0 : Brightness(corners, 0, board) > Brightness(corners, 1, board);
            if (isTurned)
                corners.Reverse();
        }

        /// <summary>In the middle of a square of the first row, whose colours alternate.</summary>
        private unsafe int Brightness(ReadOnlySpan<Vector2D> corners, int column, BoardSize board)
        {
            Vector2D middle = (corners[column] + corners[column + 1] + corners[board.Columns + column] + corners[board.Columns + column + 1]) * 0.25;
            int x = Math.Min(Math.Max((int)Math.Round(middle.X), 0), _gray.Width - 1), y = Math.Min(Math.Max((int)Math.Round(middle.Y), 0), _gray.Height - 1);
            return _gray.Pixels[(long)y * _gray.Stride + x];
        }
    }
}
