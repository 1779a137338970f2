// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
using System;
using OpenCvSharp;

namespace OpenCvStandIn
{
    /// <summary>What OpenCV's search for a checkerboard says, in the hands of tests.</summary>
    public static class FakeBoard
    {
        public static Point2f[] Corners { get; set; } = new Point2f[0];

        /// <summary>Thrown instead.</summary>
        public static Exception Problem { get; set; }

        /// <summary>The picture that it was given, row by row without padding.</summary>
        public static byte[] Seen { get; internal set; } = new byte[0];

        internal static unsafe byte[] Copy(Mat picture)
        {
            var pixels = new byte[picture.Rows * picture.Cols];
            for (int y = 0; y < picture.Rows; y++)
                new ReadOnlySpan<byte>(picture.DataPointer + y * picture.Step(), picture.Cols).CopyTo(pixels.AsSpan(y * picture.Cols));
            return pixels;
        }
    }
}
