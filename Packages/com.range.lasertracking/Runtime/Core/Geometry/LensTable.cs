using System;
using System.Numerics;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Pixels to rays by look-up: exact rays at the nodes of a square grid over the picture, straight lines between. For many pixels
    /// a frame; a single one is better asked of <see cref="LensCamera"/>. Immutable; looking up allocates nothing.
    /// </summary>
    public sealed unsafe class LensTable
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
        public bool TryRay(Vector2D pixel, out Vector2D ray)
        {
            fixed (float* nodes = _rays)
                ray = Ray(nodes, pixel);
            return !double.IsNaN(ray.X);
        }

        /// <summary>The rays of many pixels; not a number where <see cref="TryRay"/> gives false.</summary>
        public void Rays(ReadOnlySpan<Vector2D> pixels, Span<Vector2D> rays)
        {
            rays = rays.Slice(0, pixels.Length);
            fixed (float* nodes = _rays)
            {
#if NET8_0_OR_GREATER
                if (Vector128.IsHardwareAccelerated)
                {
                    RaysByVector(nodes, pixels, rays);
                    return;
                }
#endif
                for (int i = 0; i < pixels.Length; i++)
                    rays[i] = Ray(nodes, pixels[i]);
            }
        }

#if NET8_0_OR_GREATER
        /// <summary>The same operations, x and y side by side; equal to the last bit.</summary>
        private void RaysByVector(float* nodes, ReadOnlySpan<Vector2D> pixels, Span<Vector2D> rays)
        {
            Vector128<double> perPixel = Vector128.Create(_perPixel), limit = Vector128.Create((double)(_columns - 1), _rows - 1);
            int stride = 2 * _columns;
            fixed (Vector2D* from = pixels, to = rays)
            {
                for (int i = 0; i < pixels.Length; i++)
                {
                    Vector128<double> place = (Vector128.Load((double*)(from + i)) + Vector128<double>.One) * perPixel;
                    Vector128<double> isInside = Vector128.GreaterThanOrEqual(place, Vector128<double>.Zero) & Vector128.LessThan(place, limit);
                    if (isInside.ExtractMostSignificantBits() != 3)
                    {
                        to[i] = new Vector2D(double.NaN, double.NaN);
                        continue;
                    }

                    int column = double.ConvertToIntegerNative<int>(place[0]), row = double.ConvertToIntegerNative<int>(place[1]);
                    Vector128<double> share = place - Vector128.Create((double)column, row);
                    float* above = nodes + row * stride + 2 * column;
                    Vector128<float> top = Vector128.Load(above), both = top + (Vector128.Load(above + stride) - top) * (float)share[1];
                    Vector128<float> right = Vector128.Shuffle(both, Vector128.Create(2, 3, 2, 3));
                    Vector128.WidenLower(both + (right - both) * (float)share[0]).Store((double*)(to + i));
                }
            }
        }
#endif

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private Vector2D Ray(float* nodes, Vector2D pixel)
        {
            // The first node lies one pixel outside the picture, so that its outermost pixels lie inside the grid whole.
            double u = (pixel.X + 1) * _perPixel, v = (pixel.Y + 1) * _perPixel;
            if (!(u >= 0 && v >= 0 && u < _columns - 1 && v < _rows - 1))
                return new Vector2D(double.NaN, double.NaN);
            int column = (int)u, row = (int)v;
            float x = (float)(u - column), y = (float)(v - row);
            float* above = nodes + 2 * (row * _columns + column);
            Vector4 top = *(Vector4*)above, bottom = *(Vector4*)(above + 2 * _columns);
            Vector4 both = top + (bottom - top) * y;
            return new Vector2D(both.X + x * (both.Z - both.X), both.Y + x * (both.W - both.Y));
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
