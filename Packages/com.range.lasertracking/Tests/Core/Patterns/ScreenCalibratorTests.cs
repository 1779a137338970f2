using System;
using System.Linq;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Patterns
{
    /// <summary>The solve and the verdict on points that were made up, so that the truth is known to the last digit.</summary>
    public sealed class ScreenCalibratorTests
    {
        private static readonly Vector2D SizeM = new Vector2D(3.2, 1.8);
        private static readonly LensCamera Barrel = Lens(-0.2, 0.05);

        [TestCase(0.03)]
        [TestCase(0.1)]
        public void Calibrate_CleanPoints_ReportsTheNoiseThatIsThere(double noisePx)
        {
            ScreenCalibration found = Calibrate(View(noisePx: noisePx));
            Assert.That(found.Refusals, Is.Empty);
            Assert.That(found.IsLensFound, Is.False);
            PointErrors px = found.Errors(true, inMm: false);
            Assert.That(px.Count, Is.EqualTo(144));

            // Rayleigh's median, and a little for the fit's own uncertainty.
            Assert.That(px.Median, Is.EqualTo(1.1774 * noisePx).Within(0.2 * noisePx));
            Assert.That(found.Regions.Select(r => r.HeldOutMm.Count), Is.All.GreaterThan(10));
        }

        [Test]
        public void Calibrate_Lens_IsFoundFromThePointsThemselves()
        {
            ScreenCalibration found = Calibrate(View(lens: Barrel));
            Assert.That(found.Refusals, Is.Empty);
            Assert.That(found.IsLensFound, Is.True);
            Assert.That(found.Errors(true, inMm: true).Max, Is.LessThan(1));
            Assert.That(Calibrate(View(lens: Barrel), Barrel).Errors(true, inMm: true).Max, Is.LessThan(1), "a lens that is given");
        }

        [Test]
        public void Calibrate_WrongLensGiven_IsRefused()
        {
            Assert.That(Calibrate(View(lens: Barrel), Lens(0.1, 0)).Refusals, Is.Not.Empty);
        }

        [Test]
        public void Calibrate_SecondBoardDisplaced_SaysWhatMoved()
        {
            string[] refusals = Calibrate(View(secondShiftPx: new Vector2D(-4, 0.2))).Refusals.ToArray();
            Assert.That(refusals, Has.Length.EqualTo(1));
            Assert.That(refusals[0], Does.Contain("moved during the capture").And.Contain("4.0 px left"));
        }

        [Test]
        public void Calibrate_BulgeInThePlane_NamesThePartAndTheReason()
        {
            string[] refusals = Calibrate(View(bulge: p => p.X > 0.72 && p.Y < 0.3 ? new Vector2D(5, 0) : default)).Refusals.ToArray();
            Assert.That(refusals.Any(r => r.StartsWith("top right", StringComparison.Ordinal) && r.Contains("not flat")), Is.True, string.Join("\n", refusals));
            Assert.That(refusals.Any(r => r.StartsWith("bottom left", StringComparison.Ordinal)), Is.False);
        }

        [Test]
        public void Calibrate_NoisyPoints_AreRefusedAsScatter()
        {
            string[] refusals = Calibrate(View(noisePx: 3)).Refusals.ToArray();
            Assert.That(refusals, Is.Not.Empty);
            Assert.That(refusals, Is.All.Contain("scatter"));
        }

        [Test]
        public void Calibrate_BlurredPart_IsNamed()
        {
            string[] refusals = Calibrate(View(noisePx: 3, blurPx: 15)).Refusals.ToArray();
            Assert.That(refusals.Any(r => r.Contains("blurred there (edges 15.0 px wide)")), Is.True, string.Join("\n", refusals));
        }

        [Test]
        public void Calibrate_FiftyPointsOnly_AreTooFew()
        {
            int left = 50;
            string[] refusals = Calibrate(View(state: p => left-- > 0 ? ScreenPointState.Measured : ScreenPointState.Covered)).Refusals.ToArray();
            Assert.That(refusals, Has.Length.EqualTo(1));
            Assert.That(refusals[0], Does.StartWith("too few points: 50 of the 54").And.Contain("bottom").And.Contain("covered"));
        }

        [Test]
        public void Calibrate_CoveredCorner_IsNotProvenButNoReasonToRefuse()
        {
            ScreenCalibration found = Calibrate(View(state: p => p.X < 0.34 && p.Y > 0.66 ? ScreenPointState.Covered : ScreenPointState.Measured));
            Assert.That(found.Refusals, Is.Empty);
            Assert.That(found.Notes.Any(n => n.StartsWith("bottom left: nothing is proven there", StringComparison.Ordinal)), Is.True, string.Join("\n", found.Notes));
        }

        [Test]
        public void Calibrate_HalfCovered_IsRefused()
        {
            Assert.That(Calibrate(View(state: p => p.X < 0.45 ? ScreenPointState.Covered : ScreenPointState.Measured)).Refusals, Is.Not.Empty);
        }

        [Test]
        public void Calibrate_PointsOnSomebodysClothes_AreLeftOutAndSaid()
        {
            ScreenCalibration found = Calibrate(View(bulge: p => IsPerson(p) ? new Vector2D(14, 4) : default, contrast: p => IsPerson(p) ? 32 : 40));
            Assert.That(found.Refusals, Is.Empty);
            Assert.That(found.Notes, Has.Some.Contain("points were left out"));
            Assert.That(found.Errors(true, inMm: true).Max, Is.LessThan(1));
        }

        [Test]
        public void Calibrate_OneBoardOnly_ProvesWithAThirdOfIt()
        {
            ScreenCalibration found = Calibrate(View(hasSecond: false));
            Assert.That(found.Refusals, Is.Empty);
            Assert.That((found.Errors(false, true).Count, found.Errors(true, true).Count), Is.EqualTo((80, 40)));
            Assert.That(found.Notes, Has.Some.Contain("only one of the two boards"));
        }

        [Test]
        public void Calibrate_NothingSeen_SaysSo()
        {
            var nothing = new ScreenPatternView(640, 360, 12, 4, default, null, null);
            Assert.That(Calibrate(nothing).Refusals.Single(), Does.StartWith("no projected pattern was recognised in 12 frames"));
        }

        [TestCase(-0.3, 0.0)]
        [TestCase(0.05, 0.0)]
        [TestCase(-0.25, 0.08)]
        public void PlaneLens_ManyPoints_FindsTheBend(double k1, double k2)
        {
            LensCamera truth = Lens(k1, k2);
            ScreenPatternView view = View(lens: truth, noisePx: 0);
            Vector2D[] places = view.Second.Select(p => p.Place).ToArray(), px = view.Second.Select(p => p.ImagePx).ToArray();
            Assert.That(PlaneLens.TryFind(places, px, 1280, 720, 0.1, out PlaneLens? found), Is.True);
            Assert.That(found!.IsFound, Is.True);
            Vector2D[] straight = px.Select(p => found.Camera.TryUndistort(p, out Vector2D ideal) ? ideal : default).ToArray();
            Assert.That(HomographyFit.TryFit(places, straight, default, 0.1, out HomographyFit? fit, out _), Is.True);
            Assert.That(fit!.Rms, Is.LessThan(0.01), "straight lines are straight again");
        }

        private static bool IsPerson(Vector2D place) => Math.Abs(place.X - 0.45) < 0.08 && place.Y > 0.5;

        private static ScreenCalibration Calibrate(ScreenPatternView view, LensCamera? lens = null) => new ScreenCalibrator(SizeM, 5, lens).Calibrate(view);

        private static LensCamera Lens(double k1, double k2) =>
            new LensCamera(new PinholeCamera(1280, 1280, 639.5, 359.5, 1280, 720), new BrownDistortion(new[] { k1, k2, 0 }, 0, 0));

        private static ScreenPatternView View(double noisePx = 0.05, LensCamera? lens = null, Vector2D secondShiftPx = default, Func<Vector2D, Vector2D>? bulge = null, Func<Vector2D, ScreenPointState>? state = null, Func<Vector2D, double>? contrast = null, double blurPx = 1, bool hasSecond = true)
        {
            var random = new Random(11);
            double Noise() => noisePx * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
            HomographyEstimator.TryFit(ScreenGeometry.CornersOf(new Vector2D(1, 1)), new[] { new Vector2D(120, 60), new Vector2D(1190, 105), new Vector2D(1130, 660), new Vector2D(170, 610) }, out Homography toImage, out _);
            BoardSighting Board(bool isShifted)
            {
                var board = new ScreenBoard(9, isShifted);
                var points = new ScreenPoint[board.Count];
                for (int i = 0; i < points.Length; i++)
                {
                    Vector2D place = board.Place(i % board.Columns, i / board.Columns), px = toImage.Map(place);
                    if (lens != null)
                        lens.TryDistort(px, out px);
                    px += new Vector2D(Noise(), Noise()) + (isShifted ? secondShiftPx : default) + (bulge?.Invoke(place) ?? default);
                    ScreenPointState found = state?.Invoke(place) ?? ScreenPointState.Measured;
                    points[i] = new ScreenPoint(place, found, px, contrast?.Invoke(place) ?? 40, 1, blurPx);
                }

                return new BoardSighting(board, points, false);
            }

            return new ScreenPatternView(1280, 720, 16, 4, default, Board(false), hasSecond ? Board(true) : null);
        }
    }
}
