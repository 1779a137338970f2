using System;
using System.Collections.Generic;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// How far measured points of a screen lie from where the others put them: each group is left out of a fit in turn and predicted by
    /// it (Stone 1974). An error so found holds the point's own noise and what the fit lacks there. For set-up.
    /// </summary>
    public static class ScreenCrossValidation
    {
        /// <summary>Points from which the rest still says more than it must: five points for the eight parameters of a homography.</summary>
        public const int LeastPoints = 6;

        private const int MostGroups = 60;

        /// <param name="imagePx">Where the camera sees the points.</param>
        /// <param name="screenM">Where they are.</param>
        /// <param name="screenSizeM">Width and height of the projected picture.</param>
        /// <param name="camera">The camera with its lens, or null.</param>
        /// <param name="expectedSigmaPx">As for <see cref="ScreenGeometry.TryFit"/>.</param>
        /// <param name="offPx">By point: measured less predicted, px; not finite where the others do not fix a fit.</param>
        /// <param name="offMm">By point: predicted less true, mm; the same.</param>
        /// <returns>False with too few points.</returns>
        public static bool TryRun(Vector2D[] imagePx, Vector2D[] screenM, Vector2D screenSizeM, LensCamera? camera, double expectedSigmaPx, out Vector2D[] offPx, out Vector2D[] offMm)
        {
            int count = imagePx.Length, groups = Math.Min(count, MostGroups);
            offPx = new Vector2D[count];
            offMm = new Vector2D[count];
            if (count < LeastPoints)
                return false;
            List<Vector2D> px = new List<Vector2D>(), m = new List<Vector2D>();
            for (int group = 0; group < groups; group++)
            {
                px.Clear();
                m.Clear();
                for (int i = 0; i < count; i++)
                {
                    if (i % groups == group)
                        continue;
                    px.Add(imagePx[i]);
                    m.Add(screenM[i]);
                }

                bool isFitted = ScreenGeometry.TryFit(px.ToArray(), m.ToArray(), screenSizeM, camera, expectedSigmaPx, out ScreenGeometry? fit, out _);
                var none = new Vector2D(double.NaN, double.NaN);
                for (int i = group; i < count; i += groups)
                {
                    offPx[i] = isFitted ? imagePx[i] - fit!.ToImagePx(screenM[i]) : none;
                    offMm[i] = isFitted ? (fit!.ToScreenM(imagePx[i]) - screenM[i]) * 1000 : none;
                }
            }

            return true;
        }
    }
}
