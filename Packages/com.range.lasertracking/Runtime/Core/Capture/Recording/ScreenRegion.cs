using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.Recording
{
    /// <summary>The part of camera 0's picture that shows the screen: all that is worth keeping of a webcam's frames.</summary>
    public static class ScreenRegion
    {
        /// <summary>What detection looks at around a dot at the screen's edge, and how far a bumped camera may move, px.</summary>
        public const int DefaultMarginPx = 32;

        /// <summary>False when the screen lies outside the picture, or its sides are odd.</summary>
        /// <param name="calibration">Where the screen lies.</param>
        /// <param name="marginPx">Kept around the screen's outline.</param>
        /// <param name="region">The result.</param>
        public static bool TryFind(RangeCalibration calibration, int marginPx, out PixelRegion region)
        {
            double left = double.MaxValue, top = double.MaxValue, right = double.MinValue, bottom = double.MinValue;
            foreach (Vector2D point in calibration.Screen.OutlinePx)
            {
                left = System.Math.Min(left, point.X);
                top = System.Math.Min(top, point.Y);
                right = System.Math.Max(right, point.X);
                bottom = System.Math.Max(bottom, point.Y);
            }

            return PixelRegion.TryCreate(left - marginPx, top - marginPx, right + marginPx + 1, bottom + marginPx + 1, calibration.ImageWidth, calibration.ImageHeight, out region);
        }
    }
}
