using System;
using System.Numerics;

namespace LaserTracking.Simulation
{
    /// <summary>Gathers light over the sensor and spreads it by the lens's Gaussian, rectangle by rectangle.</summary>
    internal sealed class SensorBlur
    {
        private readonly Vector4[] _gathered, _across, _result;
        private readonly float[] _kernel;
        private readonly int _width, _height;
        private int _left, _right;

        public SensorBlur(int width, int height, double sigmaPx)
        {
            _width = width;
            _height = height;
            Radius = sigmaPx > 0.05 ? (int)Math.Ceiling(3 * sigmaPx) : 0;
            _kernel = new float[2 * Radius + 1];
            double sum = 0;
            for (int i = -Radius; i <= Radius; i++)
                sum += Math.Exp(-i * i / (2 * Math.Max(1e-9, sigmaPx * sigmaPx)));
            for (int i = -Radius; i <= Radius; i++)
                _kernel[i + Radius] = (float)(Math.Exp(-i * i / (2 * Math.Max(1e-9, sigmaPx * sigmaPx))) / sum);
            _gathered = new Vector4[width * height];
            _across = new Vector4[width * height];
            _result = new Vector4[width];
        }

        public int Radius { get; }

        /// <summary>The part of a gathered rectangle whose blurred light is complete; beyond the sensor's edge the last pixel is repeated.</summary>
        public PixelRect Complete(PixelRect gathered) => new PixelRect(
            gathered.Left == 0 ? 0 : gathered.Left + Radius, gathered.Top == 0 ? 0 : gathered.Top + Radius,
            gathered.Right == _width ? _width : gathered.Right - Radius, gathered.Bottom == _height ? _height : gathered.Bottom - Radius);

        public void Clear(PixelRect rect)
        {
            for (int y = rect.Top; y < rect.Bottom; y++)
                Array.Clear(_gathered, y * _width + rect.Left, rect.Right - rect.Left);
        }

        /// <summary>Light gathered so far in a row, to be added to.</summary>
        public Span<Vector4> Row(int y) => new Span<Vector4>(_gathered, y * _width, _width);

        /// <summary>Blurs along the rows; <see cref="Result"/> does the columns.</summary>
        public void Run(PixelRect rect)
        {
            _left = rect.Left;
            _right = rect.Right;
            PixelRect grown = rect.Grow(Radius).Intersect(new PixelRect(0, 0, _width, _height));
            for (int y = grown.Top; y < grown.Bottom; y++)
            {
                int row = y * _width;
                for (int x = rect.Left; x < rect.Right; x++)
                {
                    Vector4 sum = default;
                    if (x >= Radius && x + Radius < _width)
                    {
                        for (int i = 0; i < _kernel.Length; i++)
                            sum += _gathered[row + x - Radius + i] * _kernel[i];
                    }
                    else
                    {
                        for (int i = -Radius; i <= Radius; i++)
                            sum += _gathered[row + Math.Max(0, Math.Min(_width - 1, x + i))] * _kernel[i + Radius];
                    }

                    _across[row + x] = sum;
                }
            }
        }

        /// <summary>A finished row of the rectangle last run; valid until the next call.</summary>
        public ReadOnlySpan<Vector4> Result(int y)
        {
            for (int x = _left; x < _right; x++)
                _result[x] = default;
            for (int i = -Radius; i <= Radius; i++)
            {
                int row = Math.Max(0, Math.Min(_height - 1, y + i)) * _width;
                float weight = _kernel[i + Radius];
                for (int x = _left; x < _right; x++)
                    _result[x] += _across[row + x] * weight;
            }

            return _result;
        }
    }
}
