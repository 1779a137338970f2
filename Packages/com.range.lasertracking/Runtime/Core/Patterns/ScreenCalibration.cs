using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>A calibration of the screen with its proof: errors on points that the fit did not use, by region. Immutable.</summary>
    public sealed class ScreenCalibration
    {
        internal ScreenCalibration(ScreenPatternView view, ScreenGeometry? screen, bool isLensFound, IReadOnlyList<ScreenCheckPoint> points, ScreenRegion[] regions, IReadOnlyList<string> refusals, IReadOnlyList<string> notes)
        {
            View = view;
            Screen = screen;
            IsLensFound = isLensFound;
            Points = points;
            Regions = regions;
            Refusals = refusals;
            Notes = notes;
        }

        /// <summary>What it was made from.</summary>
        public ScreenPatternView View { get; }

        /// <summary>The fit; null when there was too little for one.</summary>
        public ScreenGeometry? Screen { get; }

        /// <summary>The screen's lens was found from these very points.</summary>
        public bool IsLensFound { get; }

        /// <summary>All measured points of both boards.</summary>
        public IReadOnlyList<ScreenCheckPoint> Points { get; }

        /// <summary>Nine, row by row.</summary>
        public ScreenRegion[] Regions { get; }

        /// <summary>Why it must not be used, each with what to do; empty: it holds.</summary>
        public IReadOnlyList<string> Refusals { get; }

        /// <summary>What to know about it although it holds.</summary>
        public IReadOnlyList<string> Notes { get; }

        public bool IsAccepted => Refusals.Count == 0;

        /// <summary>The points held out, for a calibration's file.</summary>
        public ScreenResidual[] Residuals()
        {
            var residuals = new List<ScreenResidual>();
            foreach (ScreenCheckPoint point in Points)
            {
                if (point.IsHeldOut && !point.IsLeftOut && Screen != null)
                    residuals.Add(new ScreenResidual(new Vector2D(point.Point.Place.X * Screen.ScreenSizeM.X, point.Point.Place.Y * Screen.ScreenSizeM.Y), point.OffMm));
            }

            return residuals.ToArray();
        }

        /// <summary>Errors of the fitted points, or of those held out.</summary>
        /// <param name="isHeldOut">Which.</param>
        /// <param name="inMm">On the screen in mm; else in the image in px.</param>
        public PointErrors Errors(bool isHeldOut, bool inMm)
        {
            var errors = new List<double>();
            foreach (ScreenCheckPoint point in Points)
            {
                if (point.IsHeldOut == isHeldOut && !point.IsLeftOut)
                    errors.Add((inMm ? point.OffMm : point.OffPx).Length);
            }

            return PointErrors.Of(errors.ToArray());
        }
    }
}
