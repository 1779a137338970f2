using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Calibrates the screen from a view of the projected boards: fits the first board's points, then proves the fit on the shifted
    /// board's, which it has not seen, region by region; refuses with the reason what does not hold. For set-up: allocates.
    /// </summary>
    public sealed class ScreenCalibrator
    {
        /// <summary>The least number of points for a fit: what the published set-up measured by hand.</summary>
        public const int LeastPoints = 54;

        /// <summary>Standard deviation of a measured coordinate before anything is known, px: a usual one, for the points themselves say more.</summary>
        private const double ExpectedSigmaPx = 0.02;

        /// <summary>
        /// What displaces the points of one part of the picture together, px: a little always, and what uneven light does through the blur, which
        /// grows with the blur's square. From simulated rooms 1 to 130 (those out of focus) and 301 to 370 of the study.
        /// </summary>
        private const double CommonSigmaPx = 0.001, CommonSigmaOfBlur2 = 0.0006;

        /// <summary>A point further off than this many standard deviations and pixels does not belong to the plane.</summary>
        private const double LeftOutSigmas = 5, LeftOutPx = 1;

        /// <summary>A point that lies off by so many limits and is dimmer than the screen around it lies on something before the screen.</summary>
        private const double BeforeScreenLimits = 2.5, DimShare = 0.88;

        /// <summary>Half the width of the surroundings, share of the picture.</summary>
        private const double Near = 0.25;

        /// <summary>Of a single board, every third point along both ways is held out.</summary>
        private const int HeldOutOf = 3;

        private readonly Vector2D _screenSizeM;
        private readonly double _limitMm;
        private readonly LensCamera? _lens;
        private readonly List<(ScreenPoint Point, bool IsHeldOut, bool IsLeftOut)> _points = new List<(ScreenPoint, bool, bool)>();

        /// <param name="screenSizeM">Width and height of the projected picture, m.</param>
        /// <param name="limitMm">Largest held-out error that holds.</param>
        /// <param name="lens">Camera 0 with its lens; null: what shows of the lens in these points is corrected.</param>
        public ScreenCalibrator(Vector2D screenSizeM, double limitMm, LensCamera? lens = null)
        {
            _screenSizeM = screenSizeM;
            _limitMm = limitMm;
            _lens = lens;
        }

        public ScreenCalibration Calibrate(ScreenPatternView view)
        {
            _points.Clear();
            bool hasBoth = view.First.Length > 0 && view.Second.Length > 0;
            ScreenPoint[] board = view.First.Length > 0 ? view.First : view.Second;
            for (int i = 0; i < board.Length; i++)
                Take(board[i], !hasBoth && IsHeldOutOfOne(i, board.Length, view.CellsDown));
            for (int i = 0; hasBoth && i < view.Second.Length; i++)
                Take(view.Second[i], true);

            string problem = string.Empty;
            bool isLensFound = false;
            ScreenGeometry? screen = FitCount() < LeastPoints ? null : Fit(view, out isLensFound, out problem);
            var checks = new List<ScreenCheckPoint>();
            for (int i = 0; i < _points.Count && screen != null; i++)
            {
                ScreenPoint point = _points[i].Point;
                Vector2D offMm = OffMm(screen, point);
                bool isLeftOut = _points[i].IsLeftOut || (offMm.Length > BeforeScreenLimits * _limitMm && IsDim(screen, point));
                checks.Add(new ScreenCheckPoint(point, point.ImagePx - screen.ToImagePx(PlaceM(point)), offMm, _points[i].IsHeldOut, isLeftOut));
            }

            ScreenRegion[] regions = ScreenRegions.Of(view, screen, _screenSizeM, checks);
            var judge = new ScreenJudge(view, regions, checks, _limitMm);
            judge.Judge(FitCount(), problem);
            if (!hasBoth && board.Length > 0)
                judge.Notes.Add("only one of the two boards was seen: a third of its points was held out to prove the rest");
            return new ScreenCalibration(view, screen, isLensFound, checks, regions, judge.Refusals, judge.Notes);
        }

        /// <summary>Every third point of every row, shifted from row to row, so that they lie between points of the fit.</summary>
        private static bool IsHeldOutOfOne(int index, int count, int cellsDown)
        {
            int columns = count == ScreenBoard.CellsAcross * cellsDown ? ScreenBoard.CellsAcross : ScreenBoard.CellsAcross - 1;
            return (index % columns + index / columns) % HeldOutOf == 0;
        }

        private void Take(ScreenPoint point, bool isHeldOut)
        {
            if (point.State == ScreenPointState.Measured)
                _points.Add((point, isHeldOut, false));
        }

        private Vector2D PlaceM(ScreenPoint point) => new Vector2D(point.Place.X * _screenSizeM.X, point.Place.Y * _screenSizeM.Y);

        private Vector2D OffMm(ScreenGeometry screen, ScreenPoint point) => (screen.ToScreenM(point.ImagePx) - PlaceM(point)) * 1000;

        private bool IsDim(ScreenGeometry screen, ScreenPoint point)
        {
            var contrasts = new List<double>();
            foreach ((ScreenPoint other, _, _) in _points)
            {
                if (Math.Abs(other.Place.X - point.Place.X) < Near && Math.Abs(other.Place.Y - point.Place.Y) < Near && OffMm(screen, other).Length <= _limitMm)
                    contrasts.Add(other.Contrast);
            }

            contrasts.Sort();
            return contrasts.Count >= 3 && point.Contrast < DimShare * contrasts[contrasts.Count / 2];
        }

        private int FitCount() => _points.FindAll(p => !p.IsHeldOut && !p.IsLeftOut).Count;

        private ScreenGeometry? Fit(ScreenPatternView view, out bool isLensFound, out string problem)
        {
            isLensFound = false;
            ScreenGeometry? screen = null;
            problem = string.Empty;
            double common = CommonSigma();
            for (int round = 0; round < 4; round++)
            {
                List<Vector2D> from = new List<Vector2D>(), to = new List<Vector2D>();
                foreach ((ScreenPoint point, bool isHeldOut, bool isLeftOut) in _points)
                {
                    if (isHeldOut || isLeftOut)
                        continue;
                    from.Add(PlaceM(point));
                    to.Add(point.ImagePx);
                }

                Vector2D[] placesM = from.ToArray(), px = to.ToArray();
                PlaneLens? found = null;
                if (_lens == null)
                    PlaneLens.TryFind(placesM, px, view.ImageWidth, view.ImageHeight, ExpectedSigmaPx, out found, common);
                isLensFound = found is { IsFound: true };
                if (!ScreenGeometry.TryFit(px, placesM, _screenSizeM, found?.Camera ?? _lens, ExpectedSigmaPx, out screen, out problem, common))
                    return null;
                if (found != null)
                    screen = new ScreenGeometry(screen!.ImageToScreen, _screenSizeM, found.Camera, found.Uncertainty, isFocalLengthKnown: false);
                if (!LeaveOut(screen!))
                    return screen;
            }

            return screen;
        }

        /// <summary>By the middle one of the points' blurs.</summary>
        private double CommonSigma()
        {
            var blurs = new List<double>();
            foreach ((ScreenPoint point, _, _) in _points)
                blurs.Add(point.BlurPx);
            blurs.Sort();
            double blur = blurs[blurs.Count / 2], ofBlur = CommonSigmaOfBlur2 * blur * blur;
            return Math.Sqrt(CommonSigmaPx * CommonSigmaPx + ofBlur * ofBlur);
        }

        /// <summary>Leaves the worst points out of the fit, at most a tenth of those left a round; false when none was.</summary>
        private bool LeaveOut(ScreenGeometry screen)
        {
            var off = new List<(double Px, int Index)>();
            for (int i = 0; i < _points.Count; i++)
            {
                if (!_points[i].IsHeldOut && !_points[i].IsLeftOut)
                    off.Add(((_points[i].Point.ImagePx - screen.ToImagePx(PlaceM(_points[i].Point))).Length, i));
            }

            off.Sort((a, b) => b.Px.CompareTo(a.Px));
            double limit = Math.Max(LeftOutPx, LeftOutSigmas * off[off.Count / 2].Px / 1.18);
            int most = Math.Min(off.Count - LeastPoints, off.Count / 10), left = 0;
            for (; left < most && off[left].Px > limit; left++)
                _points[off[left].Index] = (_points[off[left].Index].Point, false, true);
            return left > 0;
        }
    }
}
