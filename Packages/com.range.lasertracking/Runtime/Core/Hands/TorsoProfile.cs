using System;
using LaserTracking.Kernels;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Where the torsos are, per column of space. The distance in one surface is the median over a shoulder's width, weighted by area,
    /// so that several people who touch each other keep their own; what is not an arm is gathered over all surfaces of a frame.
    /// </summary>
    internal sealed unsafe class TorsoProfile
    {
        private readonly double _depthBinMm;
        private readonly int _reach;
        private readonly float _forwardMm;
        private readonly KernelRunner _kernels;
        private readonly int[] _histogram = new int[TorsoKernel.ColumnBins * TorsoKernel.DepthBins];
        private readonly int[] _window = new int[TorsoKernel.DepthBins];
        private readonly TorsoColumn[] _columns = new TorsoColumn[TorsoKernel.ColumnBins];

        public TorsoProfile(DepthHandSettings settings, KernelRunner kernels)
        {
            _kernels = kernels;
            _depthBinMm = (settings.FarMm + 2 * TorsoKernel.SlackMm) / (TorsoKernel.DepthBins - 1);
            _reach = Math.Max(1, (int)Math.Round(settings.TorsoHalfWidthMm / TorsoKernel.BinMm));
            _forwardMm = (float)settings.ForwardMm;
        }

        /// <summary>Forgets all torsos of the frame before.</summary>
        public void Clear()
        {
            for (int column = 0; column < _columns.Length; column++)
                _columns[column] = new TorsoColumn { Top = float.MaxValue };
        }

        /// <summary>Finds the body in one surface: what stands out before it goes to the next level, the rest is torso.</summary>
        public void Split(in SurfaceBands surface, int* cells, int count, float* rayY)
        {
            fixed (TorsoColumn* columns = _columns)
            fixed (int* histogram = _histogram, window = _window)
            {
                var work = new TorsoBands
                {
                    Width = surface.Width,
                    Z = surface.Z,
                    RayX = surface.RayX,
                    RayY = rayY,
                    Cells = cells,
                    CellCount = count,
                    Reach = _reach,
                    DepthBinMm = _depthBinMm,
                    Columns = columns,
                    Histogram = histogram,
                    Window = window,
                    ForwardMm = _forwardMm,
                    NextLevel = (byte)(surface.Level + 1),
                    Levels = surface.Levels,
                    Before = surface.Before,
                };
                _kernels.Run(&work, 1);
            }
        }

        /// <summary>Counts a cell as part of a person without counting it for where the torso is: a head that seems to float.</summary>
        public void AddTop(double xMm, double yMm)
        {
            ref TorsoColumn column = ref _columns[TorsoKernel.ColumnOf(xMm)];
            column.Top = Math.Min(column.Top, (float)yMm);
        }

        /// <summary>Height (y) of the crown above the torso's middle; false when nothing is seen there.</summary>
        public bool TryTop(double middleXMm, out double yMm)
        {
            int centre = TorsoKernel.ColumnOf(middleXMm);
            float top = float.MaxValue;
            for (int k = Math.Max(0, centre - 2); k <= Math.Min(_columns.Length - 1, centre + 2); k++)
                top = Math.Min(top, _columns[k].Top);
            yMm = top;
            return top < float.MaxValue;
        }

        /// <summary>Middle and distance of the torso nearest to x, by three steps of mean shift over a body's width; false when there is none.</summary>
        public bool TryTorso(double xMm, out double middleXMm, out double zMm)
        {
            middleXMm = xMm;
            zMm = 0;
            for (int step = 0; step < 3; step++)
            {
                int centre = TorsoKernel.ColumnOf(middleXMm), reach = _reach + _reach / 2;
                double sum = 0, weights = 0, sumZ = 0;
                for (int k = Math.Max(0, centre - reach); k <= Math.Min(_columns.Length - 1, centre + reach); k++)
                {
                    sum += _columns[k].TorsoWeight * ((k - TorsoKernel.ColumnBins / 2 + 0.5) * TorsoKernel.BinMm);
                    weights += _columns[k].TorsoWeight;
                    sumZ += _columns[k].TorsoZ;
                }

                if (!(weights > 0))
                    return step > 0;
                middleXMm = sum / weights;
                zMm = sumZ / weights;
            }

            return true;
        }
    }
}
