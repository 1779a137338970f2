using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Simulation;

namespace LaserTracking.Patterns
{
    /// <summary>A simulated board before a small camera with a barrel lens: the picture, and where its corners truly are.</summary>
    internal sealed class BoardView : IDisposable
    {
        public const int Width = 400;
        public const int Height = 300;

        public static readonly BoardSize NineBySix = new BoardSize(9, 6);

        public BoardView(BoardSize size)
        {
            Board = new SimulatedBoard(size, 30) { BlurPx = 1 };
            Corners = new Vector2D[size.Count];
            Truth = new Vector2D[size.Count];
            Place(0.25, -0.2, 0.1);
        }

        public SimulatedBoard Board { get; }

        public LensCamera Camera { get; } = new LensCamera(
            new PinholeCamera(360, 362, 201.3, 148.2, Width, Height), new BrownDistortion(new[] { -0.2, 0.06, 0.0 }, 0.001, -0.0007));

        public Image Picture { get; } = new Image();

        public CheckerboardFinder Finder { get; } = new CheckerboardFinder();

        public Vector2D[] Truth { get; }

        public Vector2D[] Corners { get; }

        public string Reason { get; private set; } = string.Empty;

        /// <summary>Worst distance of a corner from the truth, px.</summary>
        public double WorstPx { get; private set; }

        /// <summary>Where to put the board; the distance follows its size so that it fills much of the picture.</summary>
        public void Place(double tiltXRad, double tiltYRad, double rollRad, double nearer = 1)
        {
            double diagonal = new Vector2D(Board.Size.Columns + 1, Board.Size.Rows + 1).Length * Board.SquareMm;
            Board.Pose = Board.Centered(1.45 * diagonal / nearer, tiltXRad, tiltYRad, rollRad);
        }

        /// <summary>Moves the board sideways, in squares.</summary>
        public void Shift(double rightSquares, double downSquares)
        {
            var move = new Vector3D(rightSquares * Board.SquareMm, downSquares * Board.SquareMm, 0);
            Board.Pose = new Pose(Board.Pose.Position + move, Board.Pose.Rotation);
        }

        public void Paint(byte background = 90)
        {
            Picture.Reset(PixelFormat.Gray8, Width, Height, 0);
            Picture.Bytes.Fill(background);
            PaintOver();
        }

        public void PaintOver()
        {
            if (!Board.TryProject(Camera, Truth))
                throw new InvalidOperationException("the board is not before the camera");
            Board.Paint(Camera, Picture);
        }

        public bool TryFind() => TryFind(Board.Size);

        public bool TryFind(BoardSize size) => TryFind(Picture, size, Corners.Length == size.Count ? Corners : new Vector2D[size.Count]);

        public bool TryFind(Image picture) => TryFind(picture, Board.Size, Corners);

        public void Dispose()
        {
            Picture.Dispose();
            Finder.Dispose();
        }

        private bool TryFind(Image picture, BoardSize size, Vector2D[] corners)
        {
            bool isFound = Finder.TryFind(picture, size, corners, out string reason);
            Reason = reason;
            WorstPx = 0;
            for (int i = 0; i < corners.Length && corners.Length == Truth.Length; i++)
                WorstPx = Math.Max(WorstPx, (corners[i] - Truth[i]).Length);
            return isFound;
        }
    }
}
