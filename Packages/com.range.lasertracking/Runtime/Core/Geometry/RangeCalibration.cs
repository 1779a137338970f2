using System;
using System.Collections.Generic;

namespace LaserTracking.Geometry
{
    /// <summary>The geometry of one installation: the screen in camera 0's picture, and camera 1 where there is one. Immutable.</summary>
    public sealed class RangeCalibration
    {
        /// <param name="screen">Image px of camera 0 to screen m.</param>
        /// <param name="imageWidth">Width of the picture the screen was calibrated in.</param>
        /// <param name="imageHeight">Its height.</param>
        /// <param name="handCamera">Camera 1, or null.</param>
        /// <param name="isUnverified">It is known that nothing has checked it.</param>
        /// <param name="residuals">See <see cref="Residuals"/>; null: none.</param>
        public RangeCalibration(ScreenGeometry screen, int imageWidth, int imageHeight, HandCamera? handCamera, bool isUnverified = false,
            IReadOnlyList<ScreenResidual>? residuals = null)
        {
            Residuals = residuals ?? Array.Empty<ScreenResidual>();
            IsUnverified = isUnverified;
            Screen = screen;
            ImageWidth = imageWidth;
            ImageHeight = imageHeight;
            HandCamera = handCamera;
        }

        public ScreenGeometry Screen { get; }

        public int ImageWidth { get; }

        public int ImageHeight { get; }

        public HandCamera? HandCamera { get; }

        /// <summary>Its file says that no held-out point has checked it: check shots are due.</summary>
        public bool IsUnverified { get; }

        /// <summary>The points that checked it, as far as they are kept: to be looked at, not computed with.</summary>
        public IReadOnlyList<ScreenResidual> Residuals { get; }
    }
}
