using System;

namespace LaserTracking.Hands.Model
{
    /// <summary>How a window goes over a picture along both axes.</summary>
    internal readonly struct SlidingWindow
    {
        public const int MaxSide = 64;

        /// <param name="isPadded">Padding "same": zeros around the picture, the odd one behind it; else "valid": none.</param>
        /// <param name="height">Of the window, 1 … <see cref="MaxSide"/>.</param>
        /// <param name="width">Of the window, 1 … <see cref="MaxSide"/>.</param>
        /// <param name="strideY">From one output to the next.</param>
        /// <param name="strideX">From one output to the next.</param>
        public SlidingWindow(bool isPadded, int height, int width, int strideY, int strideX)
        {
            IsPadded = isPadded;
            Height = height;
            Width = width;
            StrideY = strideY;
            StrideX = strideX;
        }

        public bool IsPadded { get; }

        public int Height { get; }

        public int Width { get; }

        public int StrideY { get; }

        public int StrideX { get; }

        public int OutputHeight(int height) => Output(height, Height, StrideY);

        public int OutputWidth(int width) => Output(width, Width, StrideX);

        /// <summary>Rows of zeros above a picture of this height.</summary>
        public int PaddingAbove(int height) => Before(height, Height, StrideY);

        /// <summary>Columns of zeros left of a picture of this width.</summary>
        public int PaddingLeft(int width) => Before(width, Width, StrideX);

        private int Output(int side, int window, int stride) => IsPadded ? (side + stride - 1) / stride : side < window ? 0 : (side - window) / stride + 1;

        private int Before(int side, int window, int stride) => IsPadded ? Math.Max(0, (Output(side, window, stride) - 1) * stride + window - side) / 2 : 0;
    }
}
