using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>Whether a calibration of the screen may be used, and if not, where it fails, why, and what to do.</summary>
    internal sealed class ScreenJudge
    {
        /// <summary>Held-out points from which a part of the screen counts as proven.</summary>
        private const int LeastChecks = 3;

        /// <summary>Parts of the screen that may go unproven as long as the others say enough about them.</summary>
        private const int MostUnproven = 2;

        /// <summary>Share of the boards' distance explained by one displacement from which the camera was moved between them.</summary>
        private const double MovedShare = 0.6;

        /// <summary>Share of the points that may lie beside the screen's plane.</summary>
        private const double MostLeftOutShare = 0.15;

        /// <summary>Displacement between two of the pictures from which the camera was moved, px.</summary>
        private const double MovedPx = 0.5;

        /// <summary>Blur as a share of a cell from which corners suffer.</summary>
        private const double BlurredShare = 0.11;

        /// <summary>Agreement of neighbours' errors (1: the same, 0: at random) from which there is a reason in the screen itself.</summary>
        private const double CommonShare = 0.4;

        private readonly ScreenPatternView _view;
        private readonly ScreenRegion[] _regions;
        private readonly List<ScreenCheckPoint> _heldOut = new List<ScreenCheckPoint>();
        private readonly double _limitMm;

        public ScreenJudge(ScreenPatternView view, ScreenRegion[] regions, IReadOnlyList<ScreenCheckPoint> checks, double limitMm)
        {
            _view = view;
            _regions = regions;
            _limitMm = limitMm;
            foreach (ScreenCheckPoint check in checks)
            {
                if (check.IsHeldOut && !check.IsLeftOut)
                    _heldOut.Add(check);
            }
        }

        public List<string> Refusals { get; } = new List<string>();

        public List<string> Notes { get; } = new List<string>();

        /// <param name="fitPoints">Points that a fit could use.</param>
        /// <param name="problem">Why they gave none, or empty.</param>
        public void Judge(int fitPoints, string problem)
        {
            if (_view.CellsDown == 0)
                Refusals.Add(FormattableString.Invariant($"no projected pattern was recognised in {_view.Frames} frames with {_view.Pictures} different pictures: show the pictures of 'range calibrate pattern' one after the other, full screen, and let the camera see most of the screen in focus"));
            else if (fitPoints < ScreenCalibrator.LeastPoints)
                Refusals.Add(FormattableString.Invariant($"too few points: {fitPoints} of the {ScreenCalibrator.LeastPoints} that a fit needs; ") + Worst());
            else if (problem.Length > 0)
                Refusals.Add(problem + ": show the pattern again");
            else
                JudgeErrors();
        }

        private void JudgeErrors()
        {
            if (_view.MovedPx.Length > MovedPx)
            {
                Refusals.Add(FormattableString.Invariant($"camera or projector moved during the capture: between two pictures the pattern went {_view.MovedPx.Length:F1} px {Compass.Of(_view.MovedPx)}; fix them and show the pattern again"));
                return;
            }

            if (TryDisplacement(out Vector2D moved))
            {
                Refusals.Add(FormattableString.Invariant($"camera or projector moved during the capture: the second pattern lies {moved.Length:F1} px {Compass.Of(moved)} of where the first one puts it; fix them and show the pattern again"));
                return;
            }

            int proven = 0, leftOut = 0, measured = 0;
            for (int i = 0; i < _regions.Length; i++)
            {
                ScreenRegion region = _regions[i];
                leftOut += region.LeftOut;
                measured += region.Measured;
                if (region.LeftOut > 0)
                    Notes.Add(FormattableString.Invariant($"{region.Name}: {region.LeftOut} points were left out, they do not lie on the screen's plane: something stands before it"));
                proven += region.HeldOutMm.Count >= LeastChecks ? 1 : 0;
                if (region.HeldOutMm.Max > _limitMm)
                    Refusals.Add(FormattableString.Invariant($"{region.Name}: the held-out error reaches {region.HeldOutMm.Max:F1} mm ({region.HeldOutPx.Max:F2} px), over the limit of {_limitMm} mm: {Cause(i)}"));
                else if (region.HeldOutMm.Count < LeastChecks && !(3 * region.SigmaMm <= _limitMm))
                    Refusals.Add(FormattableString.Invariant($"{region.Name}: too few points to say anything ({region.HeldOutMm.Count} held out), and what the others say there may be {3 * region.SigmaMm:F1} mm off: {Why(region)}"));
                else if (region.HeldOutMm.Count < LeastChecks)
                    Notes.Add(FormattableString.Invariant($"{region.Name}: nothing is proven there ({region.HeldOutMm.Count} held-out points): {Why(region)}"));
            }

            if (leftOut > MostLeftOutShare * measured)
                Refusals.Add(FormattableString.Invariant($"{leftOut} of {measured} points do not lie on one plane: the screen is not flat, or too much stands before it; clear the way and show the pattern again"));
            if (proven < ScreenRegion.Count - MostUnproven)
                Refusals.Add(FormattableString.Invariant($"only {proven} of {ScreenRegion.Count} parts of the screen are proven: {Worst()}"));
        }

        /// <summary>Whether one displacement of the whole picture explains the held-out errors, px.</summary>
        private bool TryDisplacement(out Vector2D moved)
        {
            moved = default;
            double squares = 0;
            foreach (ScreenCheckPoint check in _heldOut)
                moved += check.OffPx * (1.0 / _heldOut.Count);
            double worst = 0;
            foreach (ScreenCheckPoint check in _heldOut)
            {
                squares += check.OffPx.LengthSquared / _heldOut.Count;
                worst = Math.Max(worst, check.OffMm.Length);
            }

            return worst > _limitMm && moved.LengthSquared > MovedShare * squares;
        }

        private string Cause(int index)
        {
            ScreenRegion region = _regions[index];
            double common = Agreement(index);
            if (common > CommonShare)
                return "the points there lie off together: the screen is not flat there, or something stands before it";
            if (region.BlurPx > BlurredShare * CellPx())
                return FormattableString.Invariant($"the picture is blurred there (edges {region.BlurPx:F1} px wide): focus camera and projector");
            return region.Covered + region.Unclear > region.Projected / 4
                ? "part of it is covered: clear the way and show the pattern again"
                : "the points there scatter: steady the camera, give it more light, show each picture longer";
        }

        /// <summary>How alike the errors of near points in a part are: mean product through mean square.</summary>
        private double Agreement(int index)
        {
            double products = 0, squares = 0;
            int pairs = 0;
            for (int i = 0; i < _heldOut.Count; i++)
            {
                if (ScreenRegion.IndexOf(_heldOut[i].Point.Place) != index)
                    continue;
                for (int k = 0; k < _heldOut.Count; k++)
                {
                    Vector2D apart = _heldOut[k].Point.Place - _heldOut[i].Point.Place;
                    if (k == i || Math.Abs(apart.X) > 0.07 || Math.Abs(apart.Y) > 0.13)
                        continue;
                    products += Vector2D.Dot(_heldOut[i].OffPx, _heldOut[k].OffPx);
                    squares += _heldOut[i].OffPx.LengthSquared;
                    pairs++;
                }
            }

            return pairs == 0 ? 0 : products / squares;
        }

        private double CellPx()
        {
            // Two neighbours in a row of either board lie a cell apart.
            ScreenPoint[] board = _view.First.Length > 0 ? _view.First : _view.Second;
            double sum = 0;
            int count = 0;
            for (int i = 1; i < board.Length; i++)
            {
                if (board[i].Place.Y != board[i - 1].Place.Y || board[i].State != ScreenPointState.Measured || board[i - 1].State != ScreenPointState.Measured)
                    continue;
                sum += (board[i].ImagePx - board[i - 1].ImagePx).Length;
                count++;
            }

            return sum / Math.Max(1, count);
        }

        private string Worst()
        {
            ScreenRegion worst = _regions[0];
            foreach (ScreenRegion region in _regions)
                worst = region.Measured * (double)worst.Projected < worst.Measured * (double)region.Projected ? region : worst;
            return FormattableString.Invariant($"worst is {worst.Name} with {worst.Measured} of {worst.Projected}: {Why(worst)}");
        }

        private static string Why(ScreenRegion region)
        {
            if (region.OutOfPicture >= Math.Max(region.Covered, region.Unclear) && region.OutOfPicture > 0)
                return "it lies outside the camera's picture; turn the camera";
            return region.Unclear > region.Covered
                ? "the pattern is too blurred or noisy there; focus camera and projector, give the camera more light"
                : "it is covered or dark; step aside and show the pattern again";
        }
    }
}
