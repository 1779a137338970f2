using System;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>The twelve numbers of a camera as a solver sees them: fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6.</summary>
    public static class CameraParameters
    {
        public const int Count = 12;

        private static readonly string[] AllNames = { "fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6" };

        /// <summary>Name of a parameter by its index, 0 to 11.</summary>
        public static string NameOf(int index) => AllNames[index];

        /// <summary>The parameters of a camera whose lens is of the common form.</summary>
        public static double[] Of(LensCamera camera)
        {
            var parameters = new double[Count];
            parameters[0] = camera.Pinhole.FocalXPx;
            parameters[1] = camera.Pinhole.FocalYPx;
            parameters[2] = camera.Pinhole.CenterXPx;
            parameters[3] = camera.Pinhole.CenterYPx;
            camera.Distortion.ToOpenCv().CopyTo(parameters, 4);
            return parameters;
        }

        /// <summary>False when the numbers make no camera: a focal length that is not above zero, or not finite.</summary>
        internal static bool TryMakeCamera(double[] parameters, int width, int height, out LensCamera? camera)
        {
            camera = null;
            foreach (double value in parameters)
            {
                if (double.IsNaN(value) || double.IsInfinity(value))
                    return false;
            }

            if (!(parameters[0] > 0 && parameters[1] > 0))
                return false;
            var pinhole = new PinholeCamera(parameters[0], parameters[1], parameters[2], parameters[3], width, height);
            camera = new LensCamera(pinhole, BrownDistortion.FromOpenCv(parameters.AsSpan(4, 8)));
            return true;
        }

        /// <summary>Indices of the parameters that a model determines.</summary>
        internal static int[] Free(LensModel model) => model switch
        {
            LensModel.Radial2 => new[] { 0, 1, 2, 3, 4, 5 },
            LensModel.Brown5 => new[] { 0, 1, 2, 3, 4, 5, 6, 7, 8 },
            _ => new[] { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 },
        };
    }
}
