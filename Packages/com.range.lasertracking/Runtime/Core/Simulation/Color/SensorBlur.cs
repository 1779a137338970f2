using System;
using System.Numerics;

namespace LaserTracking.Simulation
{
    /// <summary>Gathers light over the sensor and spreads it by the lens's Gaussian, rectangle by rectangle. Not thread-safe.</summary>
    internal sealed unsafe class SensorBlur
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
            _kernel = new float[Radius + 1];
            double sum = 0, scale = 2 * Math.Max(1e-9, sigmaPx * sigmaPx);
            for (int i = -Radius; i <= Radius; i++)
                sum += Math.Exp(-i * i / scale);
            for (int i = 0; i <= Radius; i++)
                _kernel[i] = (float)(Math.Exp(-i * i / scale) / sum);
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
            int top = Math.Max(0, rect.Top - Radius), bottom = Math.Min(_height, rect.Bottom + Radius);
            int safeLeft = Math.Max(rect.Left, Radius), safeRight = Math.Max(safeLeft, Math.Min(rect.Right, _width - Radius));
            fixed (Vector4* gathered = _gathered, across = _across)
            fixed (float* kernel = _kernel)
            {
                for (int y = top; y < bottom; y++)
                {
                    Vector4* source = gathered + (long)y * _width;
                    Vector4* target = across + (long)y * _width;
                    for (int x = rect.Left; x < Math.Min(safeLeft, rect.Right); x++)
                        target[x] = AtBorder(source, x);
                    for (int x = safeLeft; x < safeRight; x++)
                    {
                        Vector4* p = source + x;
                        Vector4 sum = p[0] * kernel[0];
                        for (int i = 1; i <= Radius; i++)
                            sum += (p[-i] + p[i]) * kernel[i];
                        target[x] = sum;
                    }

                    for (int x = safeRight; x < rect.Right; x++)
                        target[x] = AtBorder(source, x);
                }
            }
        }

        /// <summary>A finished row of the rectangle last run; valid until the next call.</summary>
        public ReadOnlySpan<Vector4> Result(int y)
        {
            fixed (Vector4* across = _across, result = _result)
            {
                Vector4* middle = across + (long)y * _width;
                for (int x = _left; x < _right; x++)
                    result[x] = middle[x] * _kernel[0];
                for (int i = 1; i <= Radius; i++)
                {
                    Vector4* above = across + (long)Math.Max(0, y - i) * _width;
                    Vector4* below = across + (long)Math.Min(_height - 1, y + i) * _width;
                    float weight = _kernel[i];
                    for (int x = _left; x < _right; x++)
                        result[x] += (above[x] + below[x]) * weight;
                }
            }

            return _result;
        }

        private Vector4 AtBorder(Vector4* source, int x)
        {
            Vector4 sum = source[x] * _kernel[0];
            for (int i = 1; i <= Radius; i++)
                sum += (source[Math.Max(0, x - i)] + source[Math.Min(_width - 1, x + i)]) * _kernel[i];
            return sum;
        }
    }
}
