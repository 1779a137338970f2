using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host.Studies.Calibration;
using NUnit.Framework;

namespace LaserTracking.Calibration
{
    /// <summary>Views that do not determine everything: what is refused, what is named, and that what is accepted holds.</summary>
    public sealed class AlikeViewsTests
    {
        private const int Width = 1280;
        private const int Height = 720;
        private const double UsableShare = 0.02, OpenShare = 0.05;

        [Test]
        [Pairwise]
        public void TryCalibrate_BoardsMoreOrLessAlike_IsWithinThreeDeviationsOrRefused(
            [Values(0, 15)] double lean, [Values(0, 1, 2, 4, 8, 20, 45)] double spread, [Values(0.05, 0.2, 0.5)] double sigmaPx)
        {
            var boards = new SimulatedBoards(3);
            double[] truth = CameraParameters.Of(boards.Truth.Left);
            if (!TryCalibrate(boards.Alike(8, sigmaPx, lean, spread), out CameraCalibration? found, out string reason))
            {
                Assert.That(reason, Does.Contain("not determined: f").And.Contain("tilted by 20° to 40°"));
                Assert.That(spread < 45 || sigmaPx > 0.2, "enough was seen: " + reason);
                return;
            }

            double[] parameters = CameraParameters.Of(found!.Camera);
            for (int i = 0; i < 2; i++)
            {
                Assert.That(found.StandardDeviations[i], Is.LessThanOrEqualTo(OpenShare * parameters[i]), CameraParameters.NameOf(i));
                Assert.That(found.StandardDeviations[i] <= UsableShare * parameters[i] || found.Notes.Any(note => note.Contains(CameraParameters.NameOf(i) + " to ")), "what is known badly is said");
                Assert.That(Math.Abs(parameters[i] - truth[i]), Is.LessThanOrEqualTo(3 * found.StandardDeviations[i]), CameraParameters.NameOf(i));
            }

            Assert.That(spread, Is.GreaterThan(0), "parallel boards leave it open");
        }

        [TestCase(0, 1)]
        [TestCase(1, 1)]
        [TestCase(2, 0.5)]
        public void TryCalibrate_BoardsNearlyParallelToThePicture_NamesTheFocalLengths(double spread, double sigmaPx)
        {
            Assert.That(TryCalibrate(new SimulatedBoards(5).Alike(12, sigmaPx, 0, spread), out _, out string reason), Is.False);
            Assert.That(reason, Does.Contain("not determined: fx, fy"));
            Assert.That(reason, Does.Not.Contain("\n"));
        }

        [Test]
        public void TryCalibrate_OnlyTheMiddleOfThePictureSeen_HoldsTheLensAndSaysSo()
        {
            var boards = new SimulatedBoards(6);
            var views = new List<BoardView>();
            foreach (BoardView view in boards.Alike(120, 0.2, 0, 60))
            {
                int[] near = Enumerable.Range(0, view.ImagePx.Length).Where(i => (view.ImagePx[i] - new Vector2D(Width / 2, Height / 2)).Length < 130).ToArray();
                if (near.Length >= 20)
                    views.Add(StereoReference.View(view.Name, near.Select(i => view.BoardMm[i]).ToArray(), near.Select(i => view.ImagePx[i]).ToArray()));
            }

            Assert.That(TryCalibrate(views, out CameraCalibration? found, out string reason), Is.True, reason);
            Assert.That(found!.Notes, Has.Some.Contains("do not determine").And.Some.Contains("k3: held at 0"));
            Assert.That(CameraParameters.Of(found.Camera)[8], Is.Zero);
            Assert.That(CameraParameters.Of(found.Camera)[0], Is.EqualTo(CameraParameters.Of(boards.Truth.Left)[0]).Within(3 * found.StandardDeviations[0]));
        }

        private static bool TryCalibrate(IReadOnlyList<BoardView> views, out CameraCalibration? found, out string reason) =>
            CameraCalibrator.TryCalibrate(views, Width, Height, LensModel.Brown5, false, out found, out reason);
    }
}
