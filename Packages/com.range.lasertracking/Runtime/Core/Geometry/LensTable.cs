using System;
using System.Runtime.CompilerServices;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Pixels to rays by look-up: exact rays at the nodes of a square grid over the picture, straight lines between. For many pixels
    /// a frame; a single one is better asked of <see cref="LensCamera"/>. Immutable; looking up allocates nothing.
    /// </summary>
    public sealed class LensTable
    {
        private const int WidestCell = 16;

        // Every how many cells along each axis the error is measured when a cell size is chosen, and what is left for those between.
        private const int ProbeStep = 4;
        private const double ProbeShare = 0.7;

        private readonly float[] _rays;
        private readonly int _columns;
        private readonly int _rows;
        private readonly double _perPixel;

        /// <param name="camera">Whose pixels.</param>
        /// <param name="cellPx">Distance of the nodes, 1 or more. With 1 every pixel's own centre is exact.</param>
        public LensTable(LensCamera camera, int cellPx)
        {
            if (cellPx < 1)
                throw new ArgumentOutOfRangeException(nameof(cellPx));
            Camera = camera;
            CellPx = cellPx;
            _perPixel = 1.0 / cellPx;
            _columns = (camera.Pinhole.Width + cellPx) / cellPx + 1;
            _rows = (camera.Pinhole.Height + cellPx) / cellPx + 1;
            _rays = new float[2 * _columns * _rows];
            Fill();
        }

        public LensCamera Camera { get; }

        /// <summary>Distance of the nodes.</summary>
        public int CellPx { get; }

        /// <summary>The coarsest table whose rays, projected again, miss their pixel by no more than this (a cell of 1 px if none does).</summary>
        public static LensTable Within(LensCamera camera, double errorPx = 0.01)
        {
            for (int cell = WidestCell; ; cell /= 2)
            {
                if (cell == 1 || Probe(camera, cell) <= ProbeShare * errorPx)
                    return new LensTable(camera, cell);
            }
        }

        /// <summary>The ray seen at a pixel; false outside the picture or where the lens model gives none.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool TryRay(Vector2D pixel, out Vector2D ray)
        {
            // The first node lies one pixel outside the picture, so that its outermost pixels lie inside the grid whole.
            double u = (pixel.X + 1) * _perPixel, v = (pixel.Y + 1) * _perPixel;
            if (!(u >= 0 && v >= 0 && u < _columns - 1 && v < _rows - 1))
            {
                ray = default;
                return false;
            }

            int column = (int)u, row = (int)v;
            double x = u - column, y = v - row;
            ReadOnlySpan<float> above = _rays.AsSpan(2 * (row * _columns + column), 4), below = _rays.AsSpan(2 * ((row + 1) * _columns + column), 4);
            double left = above[0] + y * (below[0] - above[0]), right = above[2] + y * (below[2] - above[2]);
            double top = above[1] + x * (above[3] - above[1]), bottom = below[1] + x * (below[3] - below[1]);
            ray = new Vector2D(left + x * (right - left), top + y * (bottom - top));
            return !double.IsNaN(ray.X);
        }

        /// <summary>The rays of many pixels; not a number where <see cref="TryRay"/> gives false.</summary>
        public void Rays(ReadOnlySpan<Vector2D> pixels, Span<Vector2D> rays)
        {
            rays = rays.Slice(0, pixels.Length);
            for (int i = 0; i < pixels.Length; i++)
                rays[i] = TryRay(pixels[i], out Vector2D ray) ? ray : new Vector2D(double.NaN, double.NaN);
        }

        /// <summary>The exact ray of a pixel's centre, without look-up between nodes; for cells of one pixel only. Not a number where there is none.</summary>
        internal Vector2D At(int x, int y)
        {
            int at = 2 * ((y + 1) * _columns + x + 1);
            return new Vector2D(_rays[at], _rays[at + 1]);
        }

        private void Fill()
        {
            for (int row = 0; row < _rows; row++)
            {
                bool isNear = false;
                Vector2D last = default, step = default;
                for (int column = 0; column < _columns; column++)
                {
                    var pixel = new Vector2D(column * CellPx - 1, row * CellPx - 1);
                    Vector2D ray;
                    bool isFound = isNear && Camera.TryUnproject(pixel, last + step, out ray) || Camera.TryUnproject(pixel, out ray);
                    step = isNear && isFound ? ray - last : default;
                    last = ray;
                    isNear = isFound;
                    int at = 2 * (row * _columns + column);
                    _rays[at] = isFound ? (float)ray.X : float.NaN;
                    _rays[at + 1] = isFound ? (float)ray.Y : float.NaN;
                }
            }
        }

        /// <summary>Worst distance, px, in the middle of some cells, where straight lines miss a curve by most.</summary>
        private static double Probe(LensCamera camera, int cell)
        {
            double worst = 0;
            for (int y = 0; y + cell <= camera.Pinhole.Height; y += ProbeStep * WidestCell)
            for (int x = 0; x + cell <= camera.Pinhole.Width; x += ProbeStep * WidestCell)
            {
                Vector2D middle = default;
                bool isCovered = true;
                for (int corner = 0; corner < 4; corner++)
                {
                    isCovered &= camera.TryUnproject(new Vector2D(x + corner % 2 * cell, y + corner / 2 * cell), out Vector2D ray);
                    middle += ray * 0.25;
                }

                if (isCovered && camera.TryProject(middle, out Vector2D pixel))
                    worst = Math.Max(worst, (pixel - new Vector2D(x + cell / 2.0, y + cell / 2.0)).Length);
            }

            return worst;
        }
    }
}
