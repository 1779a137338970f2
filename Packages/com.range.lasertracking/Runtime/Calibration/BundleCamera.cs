using System;

namespace LaserTracking.Calibration
{
    /// <summary>What is known of a camera's picture, and which of its numbers are sought.</summary>
    internal sealed class BundleCamera
    {
        /// <param name="width">Picture width in pixels.</param>
        /// <param name="height">Picture height in pixels.</param>
        /// <param name="freeLens">Indices of <see cref="CameraParameters"/> that are sought; empty: the camera is known.</param>
        /// <param name="isPoseFree">Whether its pose beside camera 0 is sought; never for camera 0.</param>
        public BundleCamera(int width, int height, int[] freeLens, bool isPoseFree)
        {
            Width = width;
            Height = height;
            FreeLens = freeLens;
            IsPoseFree = isPoseFree;
        }

        public int Width { get; }

        public int Height { get; }

        public int[] FreeLens { get; }

        public bool IsPoseFree { get; }

        /// <summary>Number of unknowns: lens first, then three of rotation and three of translation.</summary>
        public int Unknowns => FreeLens.Length + (IsPoseFree ? 6 : 0);

        /// <summary>A known camera in a known place.</summary>
        public static BundleCamera Known(int width, int height) => new BundleCamera(width, height, Array.Empty<int>(), false);
    }
}
