using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Patterns;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Calibration
{
    /// <summary>What proves a fit of measured points: check points, else the points themselves, each predicted by the others, else nothing.</summary>
    internal sealed class PointProof
    {
        /// <summary>Names of what proves a calibration, as its file has them in "proof".</summary>
        public const string ByCheckPoints = "check points", ByCrossValidation = "cross-validation", None = RangeCalibrationFile.NoProof;

        private readonly ScreenPoints _points;
        private readonly Vector2D _sizeM;
        private readonly LensCamera? _lens;
        private readonly double _sigmaPx;
        private readonly double _limitMm;
        private readonly Vector2D[] _placesM;
        private readonly double[] _px;
        private readonly double[] _mm;

        private PointProof(string kind, ScreenPoints points, Vector2D sizeM, LensCamera? lens, double sigmaPx, double limitMm, Vector2D[] placesM, double[] px, Vector2D[] offMm)
        {
            Kind = kind;
            _points = points;
            _sizeM = sizeM;
            _lens = lens;
            _sigmaPx = sigmaPx;
            _limitMm = limitMm;
            _placesM = placesM;
            _px = px;
            _mm = offMm.Select(off => off.Length).ToArray();
            Residuals = placesM.Zip(offMm, (place, off) => new ScreenResidual(place, off)).ToArray();
        }

        public string Kind { get; }

        /// <summary>The points that proved it, or failed to.</summary>
        public ScreenResidual[] Residuals { get; }

        /// <param name="screen">The fit.</param>
        /// <param name="points">What it was fitted to, and the check points.</param>
        /// <param name="sizeM">Of the projected picture.</param>
        /// <param name="lens">As given, or null.</param>
        /// <param name="sigmaPx">How well somebody points at a place.</param>
        /// <param name="limitMm">Largest held-out error that holds.</param>
        public static PointProof Of(ScreenGeometry screen, ScreenPoints points, Vector2D sizeM, LensCamera? lens, double sigmaPx, double limitMm)
        {
            if (points.VerifyImagePx.Length > 0)
            {
                double[] px = points.VerifyImagePx.Zip(points.VerifyScreenM, (at, m) => (screen.ToImagePx(m) - at).Length).ToArray();
                Vector2D[] mm = points.VerifyImagePx.Zip(points.VerifyScreenM, (at, m) => (screen.ToScreenM(at) - m) * 1000).ToArray();
                return new PointProof(ByCheckPoints, points, sizeM, lens, sigmaPx, limitMm, points.VerifyScreenM, px, mm);
            }

            bool isCrossed = ScreenCrossValidation.TryRun(points.ImagePx, points.ScreenM, sizeM, lens, sigmaPx, out Vector2D[] offPx, out Vector2D[] offMm);

            // A place that hangs on one point alone is not proven by the others, and a calibration is as good as its worst place.
            return isCrossed && offMm.All(off => off.IsFinite)
                ? new PointProof(ByCrossValidation, points, sizeM, lens, sigmaPx, limitMm, points.ScreenM, offPx.Select(p => p.Length).ToArray(), offMm)
                : new PointProof(None, points, sizeM, lens, sigmaPx, limitMm, [], [], []);
        }

        /// <summary>Adds what was found: held-out errors, by part of the screen, and by what they were found.</summary>
        public void AddTo(JObject result)
        {
            result["proof"] = Kind;
            result["verify"] = ScreenReport.Errors(PointErrors.Of([.. _mm]), PointErrors.Of([.. _px]));
            result["regions"] = new JArray(Regions().Select(region => new JObject
            {
                ["name"] = region.Key,
                ["verify"] = ScreenReport.Errors(PointErrors.Of(region.Select(i => _mm[i]).ToArray()), PointErrors.Of(region.Select(i => _px[i]).ToArray())),
            }));
        }

        /// <summary>Whether it keeps to the limit everywhere; says where and why it does not, and what is not proven.</summary>
        public bool Passes(string consequence)
        {
            bool isWithin = true;
            foreach (IGrouping<string, int> region in Regions())
            {
                int worst = region.MaxBy(i => _mm[i]);
                if (_mm[worst] <= _limitMm)
                    continue;
                isWithin = false;
                Console.Error.WriteLine(FormattableString.Invariant($"range: {region.Key}: the held-out error reaches {_mm[worst]:F2} mm ({_px[worst]:F2} px, {(Kind == ByCheckPoints ? "check point" : "point")} {worst + 1}), over the limit of {_limitMm} mm: {Cause()}{consequence}"));
            }

            if (Kind == None)
                Console.Error.WriteLine("range: UNVERIFIED: " + (_points.ImagePx.Length == 4 ? "the fit goes through its four corners exactly and proves nothing"
                    : _points.ImagePx.Length < ScreenCrossValidation.LeastPoints ? FormattableString.Invariant($"{_points.ImagePx.Length} points are too few to check each by the others ({ScreenCrossValidation.LeastPoints} or more)")
                    : "without one of the points the others fix no fit, so nothing checks that one") + "; fire at known places and run 'range calibrate verify', or give them as \"verify\" in --points");
            else if (Kind == ByCrossValidation && isWithin)
                Console.Error.WriteLine(FormattableString.Invariant($"range: no check points: proven by leaving each of the {_mm.Length} points out in turn; shots at known places ('range calibrate verify') prove more"));
            if (Kind != None && isWithin && Regions().Count() < ScreenRegion.Count)
                Console.Error.WriteLine("range: nothing is proven in these parts of the screen: " + string.Join(", ", ScreenRegion.AllNames.Except(Regions().Select(region => region.Key))));
            return isWithin;
        }

        private IEnumerable<IGrouping<string, int>> Regions() => Enumerable.Range(0, _mm.Length)
            .GroupBy(i => ScreenRegion.AllNames[ScreenRegion.IndexOf(new Vector2D(_placesM[i].X / _sizeM.X, _placesM[i].Y / _sizeM.Y))]);

        /// <summary>What the errors have in common: one bad point, a lens, or nothing.</summary>
        private string Cause()
        {
            if (_points.ImagePx.Length == 0)
                return "camera, projector or screen were moved since, or it was never better: calibrate again";
            if (_mm.Length > ScreenCrossValidation.LeastPoints && Kind == ByCrossValidation)
            {
                int worst = Enumerable.Range(0, _mm.Length).MaxBy(i => _mm[i]);
                Vector2D[] px = _points.ImagePx.Where((_, i) => i != worst).ToArray(), m = _points.ScreenM.Where((_, i) => i != worst).ToArray();
                if (ScreenCrossValidation.TryRun(px, m, _sizeM, _lens, _sigmaPx, out _, out Vector2D[] others) && others.All(off => off.Length <= _limitMm))
                    return FormattableString.Invariant($"point {worst + 1} alone does not fit the others: measure it again");
            }

            (int width, int height) = _points.ImageSize ?? (0, 0);
            if (_lens == null && width > 0 && PlaneLens.TryFind(_points.ScreenM, _points.ImagePx, width, height, _sigmaPx, out PlaneLens? lens) && lens!.IsFound)
                return "the camera's lens bends the picture: give it with --camera";
            return _points.ImagePx.Length == 4 ? "the corners were not met: point at them again, nearer"
                : "the points scatter, or the screen is not flat: measure them again, and more of them";
        }
    }
}
