using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>Sorts what is known about a calibration into the nine parts of the screen.</summary>
    internal static class ScreenRegions
    {
        public static ScreenRegion[] Of(ScreenPatternView view, ScreenGeometry? screen, Vector2D screenSizeM, IReadOnlyList<ScreenCheckPoint> checks)
        {
            var regions = new ScreenRegion[ScreenRegion.Count];
            for (int i = 0; i < regions.Length; i++)
            {
                regions[i] = new ScreenRegion(i);
                var px = new List<double>();
                var mm = new List<double>();
                var blur = new List<double>();
                foreach (ScreenCheckPoint check in checks)
                {
                    if (ScreenRegion.IndexOf(check.Point.Place) != i)
                        continue;
                    blur.Add(check.Point.BlurPx);
                    if (check.IsLeftOut)
                        regions[i].LeftOut++;
                    if (!check.IsHeldOut || check.IsLeftOut)
                        continue;
                    px.Add(check.OffPx.Length);
                    mm.Add(check.OffMm.Length);
                }

                regions[i].HeldOutPx = PointErrors.Of(px.ToArray());
                regions[i].HeldOutMm = PointErrors.Of(mm.ToArray());
                regions[i].BlurPx = PointErrors.Of(blur.ToArray()).Median;
                if (screen == null)
                    continue;
                var middleM = new Vector2D((i % ScreenRegion.Across + 0.5) / ScreenRegion.Across * screenSizeM.X, (i / ScreenRegion.Across + 0.5) / ScreenRegion.Down * screenSizeM.Y);
                Covariance2D covariance = screen.ToScreenMm2(screen.ToImagePx(middleM), default);
                regions[i].SigmaMm = Math.Sqrt((covariance.XX + covariance.YY) / 2);
            }

            Count(view.First, regions);
            Count(view.Second, regions);
            return regions;
        }

        private static void Count(ScreenPoint[] points, ScreenRegion[] regions)
        {
            foreach (ScreenPoint point in points)
            {
                ScreenRegion region = regions[ScreenRegion.IndexOf(point.Place)];
                region.Projected++;
                switch (point.State)
                {
                    case ScreenPointState.Measured:
                        region.Measured++;
                        break;
                    case ScreenPointState.Covered:
                        region.Covered++;
                        break;
                    case ScreenPointState.OutOfPicture:
                        region.OutOfPicture++;
                        break;
                    default:
                        region.Unclear++;
                        break;
                }
            }
        }
    }
}
