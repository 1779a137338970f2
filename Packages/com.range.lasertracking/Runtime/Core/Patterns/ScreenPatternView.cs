using System;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>What a camera saw of the projected boards: every point of each, measured or with the reason why not. Immutable.</summary>
    public sealed class ScreenPatternView
    {
        internal ScreenPatternView(int imageWidth, int imageHeight, int frames, int pictures, Vector2D movedPx, BoardSighting? first, BoardSighting? second)
        {
            // Two pictures of one projector: what does not agree was not projected by it now.
            if (first != null && second != null && (first.Board.CellsDown != second.Board.CellsDown || first.IsMirrored != second.IsMirrored))
                second = null;
            ImageWidth = imageWidth;
            ImageHeight = imageHeight;
            Frames = frames;
            Pictures = pictures;
            MovedPx = movedPx;
            IsMirrored = (first ?? second)?.IsMirrored ?? false;
            First = first?.Points ?? Array.Empty<ScreenPoint>();
            Second = second?.Points ?? Array.Empty<ScreenPoint>();
            CellsDown = (first ?? second)?.Board.CellsDown ?? 0;
        }

        public int ImageWidth { get; }

        public int ImageHeight { get; }

        /// <summary>Frames looked at.</summary>
        public int Frames { get; }

        /// <summary>Different pictures among them that stood still.</summary>
        public int Pictures { get; }

        /// <summary>By how much the pattern in one of the pictures lies displaced against the rest, px; zero for a camera that stood still.</summary>
        public Vector2D MovedPx { get; }

        /// <summary>Seen from behind the screen, or through a mirror.</summary>
        public bool IsMirrored { get; }

        /// <summary>Rows of cells of the boards found: tells the shape of the projected picture; 0 when none was.</summary>
        public int CellsDown { get; }

        /// <summary>All points of the first board, row by row; none when it was not found.</summary>
        public ScreenPoint[] First { get; }

        /// <summary>All points of the shifted board; none when it was not found.</summary>
        public ScreenPoint[] Second { get; }
    }
}
