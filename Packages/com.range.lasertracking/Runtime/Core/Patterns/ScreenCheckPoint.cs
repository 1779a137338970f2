using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>A measured point beside where the calibration says that it must be.</summary>
    public readonly struct ScreenCheckPoint
    {
        public ScreenCheckPoint(ScreenPoint point, Vector2D offPx, Vector2D offMm, bool isHeldOut, bool isLeftOut)
        {
            Point = point;
            OffPx = offPx;
            OffMm = offMm;
            IsHeldOut = isHeldOut;
            IsLeftOut = isLeftOut;
        }

        public ScreenPoint Point { get; }

        /// <summary>Measured less expected, px of the image.</summary>
        public Vector2D OffPx { get; }

        /// <summary>Where the calibration puts it less where it was projected, mm on the screen.</summary>
        public Vector2D OffMm { get; }

        /// <summary>The fit did not use it: its distance proves something.</summary>
        public bool IsHeldOut { get; }

        /// <summary>Left out of the fit, or of its proof, because it does not lie on the screen: far off, and if held out dimmer than the screen.</summary>
        public bool IsLeftOut { get; }
    }
}
