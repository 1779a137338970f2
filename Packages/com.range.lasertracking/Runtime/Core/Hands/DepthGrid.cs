using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands
{
    /// <summary>A depth picture gathered into cells of about one size in space, each with its ray; holes bridged.</summary>
    internal sealed unsafe class DepthGrid
    {
        private readonly PinholeCamera _camera;
        private readonly DepthHandSettings _settings;
        private readonly KernelRunner _kernels;
        private int _imageWidth;
        private int _imageHeight;

        public DepthGrid(PinholeCamera camera, DepthHandSettings settings, KernelRunner kernels)
        {
            _kernels = kernels;
            _camera = View = camera;
            _settings = settings;
        }

        public int Width { get; private set; }

        public int Height { get; private set; }

        /// <summary>Pixels along a cell's side.</summary>
        public int StepPx { get; private set; }

        /// <summary>Distance along z in mm; 0 outside the gate and where nothing was measured.</summary>
        public float[] Z { get; private set; } = Array.Empty<float>();

        /// <summary>x/z of the ray through a column of cells.</summary>
        public float[] RayX { get; private set; } = Array.Empty<float>();

        /// <summary>y/z of the ray through a row of cells.</summary>
        public float[] RayY { get; private set; } = Array.Empty<float>();

        /// <summary>True where no pixel of the cell had a depth, also after bridging.</summary>
        public bool[] Lost { get; private set; } = Array.Empty<bool>();

        /// <summary>The picture last filled from, and how it sees; null before the first.</summary>
        public Image? Source { get; private set; }

        public PinholeCamera View { get; private set; }

        /// <summary>Surface that a cell covers at distance 1, seen straight on.</summary>
        public double UnitArea { get; private set; }

        public Vector3D Point(int cell)
        {
            double z = Z[cell];
            return new Vector3D(RayX[cell % Width] * z, RayY[cell / Width] * z, z);
        }

        public double Area(int cell) => UnitArea * Z[cell] * Z[cell];

        /// <summary>The cell in whose picture a point lies, or -1.</summary>
        public int CellOf(Vector3D point)
        {
            if (!_camera.TryProject(point, out Vector2D px))
                return -1;
            double scaleX = (double)_imageWidth / _camera.Width, scaleY = (double)_imageHeight / _camera.Height;
            int column = (int)Math.Floor((px.X + 0.5) * scaleX / StepPx), row = (int)Math.Floor((px.Y + 0.5) * scaleY / StepPx);
            return column < 0 || row < 0 || column >= Width || row >= Height ? -1 : row * Width + column;
        }

        public void Fill(Image depth)
        {
            if (depth.Width != _imageWidth || depth.Height != _imageHeight)
                Allocate(depth.Width, depth.Height);
            Source = depth;
            int first = StepPx >= 4 ? StepPx / 4 : 0, second = StepPx >= 4 ? StepPx - 1 - StepPx / 4 : StepPx - 1;
            fixed (float* z = Z)
            fixed (bool* lost = Lost)
            {
                var work = new DepthGridBands
                {
                    Source = depth,
                    Width = Width,
                    StepPx = StepPx,
                    FirstPx = first,
                    SecondPx = second,
                    NearMm = (float)_settings.NearMm,
                    FarMm = (float)_settings.FarMm,
                    SurfaceStepMm = (float)_settings.SurfaceStepMm,
                    Z = z,
                    Lost = lost,
                };
                _kernels.Run(&work, Height);
                BridgeHoles(z, lost);
            }
        }

        /// <summary>Fills short holes between two cells of one surface, along rows first, then along columns.</summary>
        private void BridgeHoles(float* z, bool* lost)
        {
            float cellRad = (float)Math.Sqrt(UnitArea), reach = (float)_settings.HoleMm / cellRad, step = (float)_settings.SurfaceStepMm;
            var rows = new BridgeBands { Z = z, Lost = lost, Length = Width, Stride = 1, LineStride = Width, Reach = reach, SurfaceStepMm = step };
            _kernels.Run(&rows, Height);
            var columns = new BridgeBands { Z = z, Lost = lost, Length = Height, Stride = Width, LineStride = 1, Reach = reach, SurfaceStepMm = step };
            _kernels.Run(&columns, Width);
        }

        private void Allocate(int imageWidth, int imageHeight)
        {
            _imageWidth = imageWidth;
            _imageHeight = imageHeight;
            double fx = _camera.FocalXPx * imageWidth / _camera.Width, fy = _camera.FocalYPx * imageHeight / _camera.Height;
            StepPx = Math.Max(1, (int)Math.Round(Math.Sqrt(fx * fy) * _settings.CellRad));
            StepPx = Math.Min(StepPx, Math.Min(imageWidth, imageHeight));
            Width = imageWidth / StepPx;
            Height = imageHeight / StepPx;
            UnitArea = StepPx / fx * (StepPx / fy);
            Z = new float[Width * Height];
            Lost = new bool[Width * Height];
            RayX = new float[Width];
            RayY = new float[Height];
            // A pixel of a smaller mode covers several of the calibrated one; centres are integers in both.
            double scaleX = (double)_camera.Width / imageWidth, scaleY = (double)_camera.Height / imageHeight;
            View = new PinholeCamera(fx, fy, (_camera.CenterXPx + 0.5) / scaleX - 0.5, (_camera.CenterYPx + 0.5) / scaleY - 0.5, imageWidth, imageHeight);
            double middle = (StepPx - 1) / 2.0;
            for (int column = 0; column < Width; column++)
                RayX[column] = (float)_camera.Unproject((column * StepPx + middle + 0.5) * scaleX - 0.5, 0, 1).X;
            for (int row = 0; row < Height; row++)
                RayY[row] = (float)_camera.Unproject(0, (row * StepPx + middle + 0.5) * scaleY - 0.5, 1).Y;
        }
    }
}
