using LaserTracking.Geometry;
using LaserTracking.Unity;
using UnityEditor;
using UnityEngine;

namespace LaserTracking.Editor
{
    /// <summary>In the Scene view, for a selected LaserRange: from the viewpoint through the screen's corners, how sure the calibration is, and what its check points said.</summary>
    public static class RangeGizmos
    {
        private const int Columns = 5;
        private const int Rows = 3;

        /// <summary>Uncertainties and errors of millimetres would be invisible.</summary>
        private const double Magnification = 10;

        [DrawGizmo(GizmoType.Selected | GizmoType.Active)]
        public static void Draw(LaserRange range, GizmoType type)
        {
            ScreenSurface? screen = range.Screen;
            Transform? viewpoint = range.Viewpoint;
            if (screen == null || !screen.HasSize)
                return;
            if (viewpoint != null)
            {
                Gizmos.color = Color.yellow;
                foreach (Vector2D corner in ScreenGeometry.CornersOf(screen.SizeM))
                    Gizmos.DrawLine(viewpoint.position, screen.ScreenToWorld(new Vector3D(corner.X, corner.Y, 0)).ToUnity());
            }

            try
            {
                if (screen.ReadCalibration() is RangeCalibration calibration)
                {
                    DrawUncertainty(screen, calibration.Screen);
                    DrawResiduals(screen, calibration);
                }
            }
            catch (InputException)
            {
                // The set-up window says it; a gizmo is drawn many times a second.
            }
        }

        /// <summary>Crosses of one standard deviation either way, ten times as large.</summary>
        private static void DrawUncertainty(ScreenSurface screen, ScreenGeometry geometry)
        {
            Gizmos.color = Color.magenta;
            for (int row = 0; row < Rows; row++)
            for (int column = 0; column < Columns; column++)
            {
                var at = new Vector2D(screen.SizeM.X * (column + 0.5) / Columns, screen.SizeM.Y * (row + 0.5) / Rows);
                Vector2D sigmaM = SigmaM(geometry, at) * Magnification;
                Gizmos.DrawLine(World(screen, at.X - sigmaM.X, at.Y), World(screen, at.X + sigmaM.X, at.Y));
                Gizmos.DrawLine(World(screen, at.X, at.Y - sigmaM.Y), World(screen, at.X, at.Y + sigmaM.Y));
            }
        }

        /// <summary>From each check point to where the calibration puts it, ten times as far.</summary>
        private static void DrawResiduals(ScreenSurface screen, RangeCalibration calibration)
        {
            Gizmos.color = Color.red;
            foreach (ScreenResidual residual in calibration.Residuals)
            {
                Vector2D to = residual.ScreenM + residual.OffMm * (1e-3 * Magnification);
                Gizmos.DrawLine(World(screen, residual.ScreenM.X, residual.ScreenM.Y), World(screen, to.X, to.Y));
            }
        }

        /// <summary>Of the calibration alone, not of a dot measured with it; metres.</summary>
        internal static Vector2D SigmaM(ScreenGeometry geometry, Vector2D screenM)
        {
            Covariance2D mm2 = geometry.ToScreenMm2(geometry.ToImagePx(screenM), default);
            return new Vector2D(System.Math.Sqrt(mm2.XX), System.Math.Sqrt(mm2.YY)) * 1e-3;
        }

        private static Vector3 World(ScreenSurface screen, double xM, double yM) => screen.ScreenToWorld(new Vector3D(xM, yM, 0)).ToUnity();
    }
}
