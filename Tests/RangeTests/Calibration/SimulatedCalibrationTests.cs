using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host.Studies.Calibration;
using NUnit.Framework;

namespace LaserTracking.Calibration
{
    /// <summary>Sessions whose truth is known, and what can go wrong in one.</summary>
    public sealed class SimulatedCalibrationTests
    {
        private const int Width = 1280;
        private const int Height = 720;

        [Test]
        public void TryCalibrate_NoNoise_GivesTheTruth()
        {
            var boards = new SimulatedBoards(1);
            List<BoardPair> pairs = boards.Pairs(12, 0);
            CameraCalibration left = Mono(pairs.Select(p => p.Left)), right = Mono(pairs.Select(p => p.Right));
            StereoCalibration both = Stereo(pairs, left, right);
            double[] found = CameraParameters.Of(left.Camera), truth = CameraParameters.Of(boards.Truth.Left);
            for (int i = 0; i < CameraParameters.Count; i++)
                Assert.That(found[i], Is.EqualTo(truth[i]).Within(1e-6), CameraParameters.NameOf(i));
            Assert.That((both.Rig.LeftToRight.Position - boards.Truth.LeftToRight.Position).Length, Is.LessThan(1e-6));
            Assert.That(StereoReference.AngleRad(both.Rig.LeftToRight.Rotation, boards.Truth.LeftToRight.Rotation), Is.LessThan(1e-9));
            Assert.That(both.RmsPx, Is.LessThan(1e-8));
            Assert.That(left.LeftOut.Concat(both.LeftOut), Is.Empty);
        }

        [Test]
        public void Solve_WhereItEnds_NoUnknownCanLowerTheCost()
        {
            const LensModel model = LensModel.Brown5;
            var boards = new SimulatedBoards(2);
            List<BoardPair> pairs = boards.Pairs(6, 0.3);
            BundleCamera[] cameras = { new(Width, Height, CameraParameters.Free(model), false), new(Width, Height, CameraParameters.Free(model), true) };
            BundleObservation[] observations = pairs.SelectMany((pair, i) => new[] { new BundleObservation(0, i, pair.Left), new BundleObservation(1, i, pair.Right) }).ToArray();
            Pose[] poses = pairs.Select(pair => PlanarPoseEstimator.TryEstimate(pair.Left, boards.Truth.Left, out PlanarPose? pose, out _) ? pose!.Pose : default).ToArray();
            var start = new BundleState(new[] { CameraParameters.Of(boards.Truth.Left), CameraParameters.Of(boards.Truth.Right) }, new[] { Pose.Identity, boards.Truth.LeftToRight }, poses);
            BundleState solved = BundleAdjuster.Solve(cameras, observations, start, out NormalEquations? equations)!;

            // Wrong derivatives would make it stop elsewhere: where the cost is least it rises alike to both sides. (The rational model's
            // are proved by the reference: its flat valleys are not walked to the end.)
            double[] moves = cameras.SelectMany(camera => camera.FreeLens.Select(i => i < 4 ? 0.01 : 1e-7).Concat(camera.IsPoseFree ? new[] { 1e-5, 1e-5, 1e-5, 0.01, 0.01, 0.01 } : new double[0]))
                .Concat(poses.SelectMany(_ => new[] { 1e-5, 1e-5, 1e-5, 0.01, 0.01, 0.01 })).ToArray();
            for (int i = 0; i < moves.Length; i++)
            {
                double up = Cost(moves[i]) - equations!.Cost, down = Cost(-moves[i]) - equations.Cost;
                Assert.That(Math.Min(up, down), Is.GreaterThan(0), "unknown " + i);
                Assert.That(Math.Abs(up - down), Is.LessThan(0.01 * (up + down)), "unknown " + i);
                double Cost(double move) => NormalEquations.TryBuild(cameras, observations, solved.Moved(cameras, moves.Select((_, k) => k == i ? move : 0).ToArray()))!.Cost;
            }
        }

        [Test]
        public void StandardDeviations_OverManySessions_TellTheError()
        {
            var ratios = new List<double>();
            for (int seed = 1; seed <= 12; seed++)
            {
                var boards = new SimulatedBoards(seed);
                CameraCalibration found = Mono(boards.Pairs(12, 0.2).Select(p => p.Left));
                double[] parameters = CameraParameters.Of(found.Camera), truth = CameraParameters.Of(boards.Truth.Left);
                ratios.AddRange(Enumerable.Range(0, 4).Select(i => (parameters[i] - truth[i]) / found.StandardDeviations[i]));
            }

            Assert.That(Math.Sqrt(ratios.Average(r => r * r)), Is.InRange(0.7, 1.4));
        }

        [Test]
        public void TryCalibrate_OneBlurredViewAmongTwenty_IsNamedAndLeftOut()
        {
            var boards = new SimulatedBoards(3);
            BoardView[] views = boards.Pairs(20, 0.2, 1.5).Select(p => p.Left).ToArray();
            CameraCalibration found = Mono(views), without = Mono(views.Skip(1));
            Assert.That(found.LeftOut.Select(view => view.Name), Is.EqualTo(new[] { "left01" }));
            Assert.That(found.LeftOut[0].Reason, Does.Contain("blurred"));
            Assert.That(found.RmsPx, Is.EqualTo(without.RmsPx).Within(1e-9));
        }

        [Test]
        public void TryCalibrate_AllViewsParallel_SaysWhatIsNotDetermined()
        {
            LensCamera camera = new SimulatedBoards(4).Truth.Left;
            var random = new Random(4);
            var views = new List<BoardView>();
            for (int i = 0; i < 20; i++)
                views.Add(See(camera, new Pose(new Vector3D(-280 + 30 * (i % 5 - 2), -200 + 20 * (i / 5 - 2), 1300 + 60 * i), Rotation3D.Identity), random, "view" + i));
            Assert.That(CameraCalibrator.TryCalibrate(views, Width, Height, LensModel.Brown5, false, out _, out string reason), Is.False);
            Assert.That(reason, Does.Contain("parallel").And.Contain("not determined: fx, fy").And.Contain("tilted"));
        }

        [Test]
        public void TryCalibrate_TooFewViews_SaysWhatIsNotDetermined()
        {
            BoardView[] views = new SimulatedBoards(5).Pairs(2, 0.2).Select(p => p.Left).ToArray();
            Assert.That(CameraCalibrator.TryCalibrate(views.Take(1).ToArray(), Width, Height, LensModel.Brown5, false, out _, out string one), Is.False);
            Assert.That(one, Does.Contain("not determined"));
            Assert.That(CameraCalibrator.TryCalibrate(Array.Empty<BoardView>(), Width, Height, LensModel.Brown5, false, out _, out string none), Is.False);
            Assert.That(none, Does.Contain("no view"));
            Assert.That(HeldOutError.OfCamera(views, Width, Height, LensModel.Brown5), Is.Null);
        }

        [Test]
        public void TryCalibrate_OneViewInMirroredOrder_IsNamedAndLeftOut()
        {
            BoardView[] views = new SimulatedBoards(6).Pairs(10, 0.2).Select(p => p.Left).ToArray();
            BoardView view = views[4];
            views[4] = Mirrored(view);
            Assert.That(Mono(views).LeftOut.Single().Name, Is.EqualTo(view.Name));
        }

        [Test]
        public void TryCalibrate_LeftAndRightSwapped_IsRefused()
        {
            List<BoardPair> pairs = new SimulatedBoards(7).Pairs(10, 0.2).Select(p => new BoardPair(p.Right, p.Left)).ToList();
            Assert.That(WhyNotStereo(pairs, pairs), Does.Contain("left and right are swapped").And.Contain("negative"));
        }

        [Test]
        public void TryCalibrate_EveryPairOfTwoMoments_IsRefused()
        {
            List<BoardPair> pairs = new SimulatedBoards(8).Pairs(12, 0.2);
            List<BoardPair> shifted = pairs.Select((pair, i) => new BoardPair(pair.Left, pairs[(i + 1) % pairs.Count].Right)).ToList();
            Assert.That(WhyNotStereo(shifted, pairs), Does.Contain("the pairs do not agree").And.Contain("not of one moment"));
        }

        [Test]
        public void TryCalibrate_BothCamerasCornersInMirroredOrder_GivesTheSameGeometry_AndSaysSo()
        {
            List<BoardPair> pairs = new SimulatedBoards(8).Pairs(8, 0.2), mirrored = pairs.Select(pair => new BoardPair(Mirrored(pair.Left), Mirrored(pair.Right))).ToList();
            CameraCalibration left = Mono(mirrored.Select(p => p.Left)), right = Mono(mirrored.Select(p => p.Right));
            StereoCalibration expected = Stereo(pairs, Mono(pairs.Select(p => p.Left)), Mono(pairs.Select(p => p.Right)));
            Assert.That(left.IsMirrored && right.IsMirrored);
            Assert.That(left.Notes, Has.Some.Contains("the boards appear mirrored"));
            Assert.That((Stereo(mirrored, left, right).Rig.LeftToRight.Position - expected.Rig.LeftToRight.Position).Length, Is.LessThan(1e-3));
        }

        private static BoardView Mirrored(BoardView view) => StereoReference.View(view.Name, view.BoardMm, view.ImagePx.Chunk(8).SelectMany(row => row.Reverse()).ToArray());

        private static string WhyNotStereo(List<BoardPair> pairs, List<BoardPair> alone)
        {
            CameraCalibration left = Mono(alone.Select(p => p.Left)), right = Mono(alone.Select(p => p.Right));
            Assert.That(StereoCalibrator.TryCalibrate(pairs, left.Camera, right.Camera, null, false, out _, out string reason), Is.False);
            return reason;
        }

        [Test]
        public void TryCalibrate_OnePairOfAnotherMoment_IsNamedAndLeftOut()
        {
            List<BoardPair> pairs = new SimulatedBoards(8).Pairs(12, 0.2);
            CameraCalibration left = Mono(pairs.Select(p => p.Left)), right = Mono(pairs.Select(p => p.Right));
            pairs[3] = new BoardPair(pairs[3].Left, pairs[4].Right);
            Assert.That(Stereo(pairs, left, right).LeftOut.Single().Name, Is.EqualTo(pairs[3].Name));
        }

        [Test]
        public void TryCalibrate_RightViewsCountedFromTheOtherEnd_AreTurned()
        {
            List<BoardPair> pairs = new SimulatedBoards(9).Pairs(10, 0.2);
            CameraCalibration left = Mono(pairs.Select(p => p.Left)), right = Mono(pairs.Select(p => p.Right));
            StereoCalibration expected = Stereo(pairs, left, right);
            foreach (int turned in new[] { 0, 6 })
                pairs[turned] = new BoardPair(pairs[turned].Left, StereoReference.View(pairs[turned].Right.Name, pairs[turned].Right.BoardMm, pairs[turned].Right.ImagePx.Reverse().ToArray()));
            StereoCalibration found = Stereo(pairs, left, right);
            Assert.That(found.LeftOut, Is.Empty);
            Assert.That(found.Notes.Count(note => note.Contains("opposite end")), Is.EqualTo(2));
            Assert.That((found.Rig.LeftToRight.Position - expected.Rig.LeftToRight.Position).Length, Is.LessThan(1e-3));
        }

        [Test]
        public void TriangulationCheck_PicturesSwapped_CountsNegativeDepths()
        {
            var boards = new SimulatedBoards(10);
            List<BoardPair> pairs = boards.Pairs(4, 0.1);
            var parallel = new StereoRig(boards.Truth.Left, boards.Truth.Left, new Pose(new Vector3D(-400, 0, 0), Rotation3D.Identity));
            BoardPair[] seen = Enumerable.Range(0, 4).Select(i => SeenBy(parallel, i)).ToArray();
            Assert.That(TriangulationCheck.Of(parallel, seen).Behind, Is.Zero);
            Assert.That(TriangulationCheck.Of(parallel, seen).EdgeRatioMean, Is.EqualTo(1).Within(1e-3));
            Assert.That(TriangulationCheck.Of(parallel, seen.Select(pair => new BoardPair(pair.Right, pair.Left)).ToArray()).Behind, Is.EqualTo(4 * 48));
            Assert.That(TriangulationCheck.Of(boards.Truth, pairs).Behind, Is.Zero);
        }

        [Test]
        public void HeldOutError_GoodSession_IsLittleAboveTheFit()
        {
            List<BoardPair> pairs = new SimulatedBoards(11).Pairs(20, 0.2);
            CameraCalibration left = Mono(pairs.Select(p => p.Left)), right = Mono(pairs.Select(p => p.Right));
            double mono = HeldOutError.OfCamera(left.Views, Width, Height, LensModel.Brown5)!.Value;
            double stereo = HeldOutError.OfPairs(pairs, left.Camera, right.Camera, LensModel.Brown5)!.Value;
            Assert.That(mono, Is.InRange(0.9 * left.RmsPx, 1.2 * left.RmsPx));
            double fit = Stereo(pairs, left, right).RmsPx;
            Assert.That(stereo, Is.InRange(0.95 * fit, 1.5 * fit));
        }

        [Test]
        public void BoardView_UnusablePoints_AreRefusedWithTheirName()
        {
            var square = new[] { new Vector2D(0, 0), new Vector2D(1, 0), new Vector2D(1, 1), new Vector2D(0, 1) };
            Refuse(square.Take(3).ToArray(), square.Take(3).ToArray(), "3 points");
            Refuse(square, square.Take(3).ToArray(), "3 points in the picture against 4");
            Refuse(square, new[] { square[0], square[1], new Vector2D(double.NaN, 1), square[3] }, "point 3 is not finite");
            Refuse(square, new[] { square[0], square[1], new Vector2D(2, 0), new Vector2D(3, 0) }, "one line");

            static void Refuse(Vector2D[] board, Vector2D[] px, string words)
            {
                Assert.That(BoardView.TryCreate("view7", board, px, out _, out string reason), Is.False);
                Assert.That(reason, Does.StartWith("view7: ").And.Contain(words));
            }
        }

        private static BoardPair SeenBy(StereoRig rig, int i)
        {
            var random = new Random(i);
            var pose = new Pose(new Vector3D(-100, -200, 1500 + 200 * i), Rotation3D.AboutAxis(new Vector3D(1, 1, 0), 0.1 * i));
            return new BoardPair(See(rig.Left, pose, random, "left" + i, 0), See(rig.Right, rig.LeftToRight * pose, random, "right" + i, 0));
        }

        private static BoardView See(LensCamera camera, Pose pose, Random random, string name, double noisePx = 0.2)
        {
            Vector2D[] board = new SimulatedBoards(0).Board.CornersMm();
            Vector2D[] px = board.Select(corner =>
            {
                Assert.That(camera.TryProject(pose.TransformPoint(new Vector3D(corner.X, corner.Y, 0)), out Vector2D at), Is.True);
                return at + new Vector2D(random.NextDouble() - 0.5, random.NextDouble() - 0.5) * noisePx;
            }).ToArray();
            return StereoReference.View(name, board, px);
        }

        private static CameraCalibration Mono(IEnumerable<BoardView> views)
        {
            Assert.That(CameraCalibrator.TryCalibrate(views.ToArray(), Width, Height, LensModel.Brown5, false, out CameraCalibration? found, out string reason), Is.True, reason);
            return found!;
        }

        private static StereoCalibration Stereo(IReadOnlyList<BoardPair> pairs, CameraCalibration left, CameraCalibration right)
        {
            Assert.That(StereoCalibrator.TryCalibrate(pairs, left.Camera, right.Camera, null, false, out StereoCalibration? found, out string reason), Is.True, reason);
            return found!;
        }
    }
}
