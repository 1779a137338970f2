using System;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Where the camera's working picture and the rendered picture meet: a grid of 32×18 cells over the screen with 3×3 looks each,
    /// and for every 2×2 block of working pixels the rendered pixel that it shows.
    /// </summary>
    internal sealed unsafe class ScreenGrid
    {
        public const int Columns = 32;
        public const int Rows = 18;
        public const int CellCount = Columns * Rows;
        public const int LooksPerCell = 9;
        public const int LookCount = CellCount * LooksPerCell;

        /// <param name="screen">From camera 0's pixels to the screen.</param>
        /// <param name="width">Of the working picture.</param>
        /// <param name="height">Of the working picture.</param>
        /// <param name="factor">Camera pixels per working pixel.</param>
        /// <param name="renderedWidth">Of the rendered pictures.</param>
        /// <param name="renderedHeight">Of the rendered pictures.</param>
        public ScreenGrid(ScreenGeometry screen, int width, int height, int factor, int renderedWidth, int renderedHeight)
        {
            RenderedLooks = Looks(renderedWidth, renderedHeight);
            BlockColumns = (width + 1) / 2;
            Blocks = new int[BlockColumns * ((height + 1) / 2)];
            Vector2D size = screen.ScreenSizeM;
            for (int i = 0; i < LookCount; i++)
            {
                Share(i, out double u, out double v);
                Vector2D image = screen.ToImagePx(new Vector2D(u * size.X, v * size.Y));
                int x = (int)Math.Floor((image.X + 0.5) / factor), y = (int)Math.Floor((image.Y + 0.5) / factor);
                bool isInside = image.IsFinite && x >= 0 && y >= 0 && x < width && y < height;
                CameraLooks[i] = isInside ? y * width + x : -1;
                IsHidden[i / LooksPerCell] |= !isInside;
            }

            for (int i = 0; i < Blocks.Length; i++)
            {
                // The middle of the block's four working pixels.
                double x = (i % BlockColumns * 2 + 1) * factor - 0.5, y = (i / BlockColumns * 2 + 1) * factor - 0.5;
                Vector2D at = screen.ToScreenM(new Vector2D(x, y));
                double column = Math.Floor(at.X / size.X * renderedWidth), row = Math.Floor(at.Y / size.Y * renderedHeight);
                bool isOnScreen = column >= 0 && row >= 0 && column < renderedWidth && row < renderedHeight;
                Blocks[i] = isOnScreen ? (int)row * renderedWidth + (int)column : renderedWidth * renderedHeight;
                BlocksOnScreen += isOnScreen ? 1 : 0;
            }
        }

        public int BlockColumns { get; }

        /// <summary>Index of the rendered pixel, or one past the last where there is no screen.</summary>
        public int[] Blocks { get; }

        public int BlocksOnScreen { get; }

        /// <summary>Index of the working pixel of each look, or -1; the looks of a cell follow one another.</summary>
        public int[] CameraLooks { get; } = new int[LookCount];

        /// <summary>Index of the rendered pixel of each look.</summary>
        public int[] RenderedLooks { get; }

        /// <summary>Cells that the camera does not see whole.</summary>
        public bool[] IsHidden { get; } = new bool[CellCount];

        /// <summary>The looks' indices in a rendered picture of this size.</summary>
        public static int[] Looks(int width, int height)
        {
            var looks = new int[LookCount];
            for (int i = 0; i < LookCount; i++)
            {
                Share(i, out double u, out double v);
                looks[i] = (int)(v * height) * width + (int)(u * width);
            }

            return looks;
        }

        /// <summary>Brightness of each cell: blue + 2 green + red over its looks, 0…9180. Looks that are nowhere count as black.</summary>
        public static void SumCells(uint* pixels, int* looks, short* cells)
        {
            for (int cell = 0; cell < CellCount; cell++)
            {
                int sum = 0;
                for (int i = 0; i < LooksPerCell; i++)
                {
                    int look = *looks++;
                    if (look < 0)
                        continue;
                    uint pixel = pixels[look];
                    sum += (int)((pixel & 255) + (pixel >> 7 & 510) + (pixel >> 16 & 255));
                }

                cells[cell] = (short)sum;
            }
        }

        /// <summary>Place of a look as shares of the screen.</summary>
        private static void Share(int look, out double u, out double v)
        {
            int cell = look / LooksPerCell, inner = look % LooksPerCell;
            u = (cell % Columns + (inner % 3 + 0.5) / 3) / Columns;
            v = (cell / Columns + (inner / 3 + 0.5) / 3) / Rows;
        }
    }
}
