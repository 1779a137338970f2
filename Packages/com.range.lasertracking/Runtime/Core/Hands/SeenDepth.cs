using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Hands
{
    /// <summary>
    /// How far camera 1 saw in one frame, one pixel of each cell of <see cref="DepthGrid"/>: tells of any place whether something is there,
    /// before it, or nothing. Filled again for every frame; room is taken with the first. One thread at a time.
    /// </summary>
    public sealed unsafe class SeenDepth
    {
        private ushort[] _cells = Array.Empty<ushort>();
        private PinholeCamera? _view;
        private int _width;
        private int _height;
        private int _stepPx;

        /// <summary>The view's focal lengths and centre in cells.</summary>
        private Vector2D _focal;
        private Vector2D _origin;

        /// <summary>False where the frame had no depth picture, or whoever found the hands keeps none.</summary>
        public bool IsPresent { get; private set; }

        public void Clear() => IsPresent = false;

        public void CopyFrom(SeenDepth other)
        {
            IsPresent = other.IsPresent;
            if (!IsPresent)
                return;
            Take(other._width, other._height, other._stepPx, other._view);
            Array.Copy(other._cells, _cells, _width * _height);
        }

        /// <summary>Distance along z of what is seen in the direction of a point in camera space, mm; 0 outside the picture and where nothing was measured.</summary>
        public int TowardsMm(Vector3D pointMm)
        {
            if (!IsPresent || !(pointMm.Z > 0))
                return 0;
            double perZ = 1 / pointMm.Z, column = _focal.X * pointMm.X * perZ + _origin.X, row = _focal.Y * pointMm.Y * perZ + _origin.Y;
            return column >= 0 && row >= 0 && column < _width && row < _height ? _cells[(int)row * _width + (int)column] : 0;
        }

        internal void Fill(DepthGrid grid)
        {
            IsPresent = grid.Source is Image;
            if (!(grid.Source is Image depth))
                return;
            Take(grid.Width, grid.Height, grid.StepPx, grid.View);
            for (int row = 0; row < _height; row++)
            {
                var line = (ushort*)(depth.Pixels + (long)(row * _stepPx + _stepPx / 2) * depth.Stride) + _stepPx / 2;
                int first = row * _width;
                for (int column = 0; column < _width; column++)
                    _cells[first + column] = line[column * _stepPx];
            }
        }

        private void Take(int width, int height, int stepPx, PinholeCamera? view)
        {
            if (_cells.Length < width * height)
                _cells = new ushort[width * height];
            _width = width;
            _height = height;
            _stepPx = stepPx;
            _view = view;
            _focal = view == null ? default : new Vector2D(view.FocalXPx, view.FocalYPx) * (1.0 / stepPx);
            _origin = view == null ? new Vector2D(-1, -1) : new Vector2D(view.CenterXPx + 0.5, view.CenterYPx + 0.5) * (1.0 / stepPx);
        }
    }
}
