using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Calibration;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Studies.Calibration
{
    /// <summary>
    /// Cameras and rigs determined from simulated boards against the truth: how far off, whether the stated standard deviations tell it,
    /// and whether one bad pair is found.
    /// </summary>
    internal sealed class BoardStudy : IStudy
    {
        private const double SigmaPx = 0.2;
        private const double BlurredSigmaPx = 1.5;

        public string Name => "board";

        public string What => "simulated board sessions: errors of camera and stereo calibration against the truth, by number of views; one blurred pair among them";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable(FormattableString.Invariant($"board: 8×6 corners of 80 mm at 1.2 to 2.6 m, 1280×720, corner noise {SigmaPx} px; errors are RMS over {options.LastSeed - options.FirstSeed + 1} rigs"),
                "pairs", "blurred", "rms_px", "held_out_px", "focal_px", "focal_sigmas", "centre_px", "baseline_mm", "rotation_mrad", "T_sigmas", "blurred_found", "others_left_out");
            foreach ((int count, bool isBlurred) in new[] { (5, false), (10, false), (20, false), (40, false), (20, true) })
            {
                string name = FormattableString.Invariant($"{count}{(isBlurred ? " blurred" : string.Empty)}");
                if (!options.Includes(name))
                    continue;
                var sums = new Sums();
                for (int seed = options.FirstSeed; seed <= options.LastSeed; seed++)
                {
                    interrupted.ThrowIfCancellationRequested();
                    options.Progress.Show(FormattableString.Invariant($"board: {name}, seed {seed} …"));
                    sums.Add(new SimulatedBoards(seed), count, isBlurred);
                }

                table.Add(count, isBlurred ? "one" : "none", sums.Rms("rms"), sums.Rms("held"), sums.Rms("focal"), sums.Rms("focal sigmas"), sums.Rms("centre"), sums.Rms("baseline"), sums.Rms("rotation"),
                    sums.Rms("T sigmas"), isBlurred ? new Proportion(sums.BlurredFound, sums.Runs) : "-", new Proportion(sums.OthersLeftOut, sums.Runs * (isBlurred ? count - 1 : count)));
            }

            table.Notes.Add("focal_sigmas, T_sigmas: error by the calibration's own standard deviation; 1 is right.");
            table.Notes.Add(FormattableString.Invariant($"blurred: the corners of the first pair have a noise of {BlurredSigmaPx} px."));
            return table;
        }

        private sealed class Sums
        {
            private readonly Dictionary<string, List<double>> _values = new();

            public int Runs { get; private set; }

            public int BlurredFound { get; private set; }

            public int OthersLeftOut { get; private set; }

            public double Rms(string name) => _values.TryGetValue(name, out List<double>? values) ? Math.Sqrt(values.Average(value => value * value)) : double.NaN;

            public void Add(SimulatedBoards boards, int count, bool isBlurred)
            {
                Runs++;
                List<BoardPair> pairs = boards.Pairs(count, SigmaPx, isBlurred ? BlurredSigmaPx : null);
                LensCamera left = boards.Truth.Left, right = boards.Truth.Right;
                if (!CameraCalibrator.TryCalibrate(pairs.Select(pair => pair.Left).ToArray(), left.Pinhole.Width, left.Pinhole.Height, LensModel.Brown5, false, out CameraCalibration? first, out _)
                    || !CameraCalibrator.TryCalibrate(pairs.Select(pair => pair.Right).ToArray(), right.Pinhole.Width, right.Pinhole.Height, LensModel.Brown5, false, out CameraCalibration? second, out _))
                    return;
                BoardPair[] used = pairs.Where(pair => first!.Views.Contains(pair.Left) && second!.Views.Contains(pair.Right)).ToArray();
                if (!StereoCalibrator.TryCalibrate(used, first!.Camera, second!.Camera, LensModel.Brown5, false, out StereoCalibration? both, out _))
                    return;
                string[] kept = both!.Pairs.Select(pair => pair.Left.Name).ToArray();
                foreach (BoardPair pair in pairs.Where(pair => !kept.Contains(pair.Left.Name)))
                {
                    bool isBad = isBlurred && pair == pairs[0];
                    BlurredFound += isBad ? 1 : 0;
                    OthersLeftOut += isBad ? 0 : 1;
                }

                PinholeCamera found = first.Camera.Pinhole, truth = left.Pinhole;
                Pose rig = both.Rig.LeftToRight, trueRig = boards.Truth.LeftToRight;
                Vector3D off = rig.Position - trueRig.Position;
                Rotation3D turn = rig.Rotation * trueRig.Rotation.Inverse;
                Note("rms", both.RmsPx);
                if (HeldOutError.OfCamera(first.Views, truth.Width, truth.Height, LensModel.Brown5) is double heldOut)
                    Note("held", heldOut);
                Note("focal", found.FocalXPx - truth.FocalXPx);
                Note("focal sigmas", (found.FocalXPx - truth.FocalXPx) / first.StandardDeviations[0]);
                Note("centre", Math.Sqrt((Square(found.CenterXPx - truth.CenterXPx) + Square(found.CenterYPx - truth.CenterYPx)) / 2));
                Note("baseline", rig.Position.Length - trueRig.Position.Length);
                Note("rotation", 2000 * new Vector3D(turn.X, turn.Y, turn.Z).Length);
                Note("T sigmas", Math.Sqrt((Square(off.X / both.RigDeviations[3]) + Square(off.Y / both.RigDeviations[4]) + Square(off.Z / both.RigDeviations[5])) / 3));
            }

            private static double Square(double value) => value * value;

            private void Note(string name, double value)
            {
                if (!_values.TryGetValue(name, out List<double>? values))
                    _values.Add(name, values = new List<double>());
                values.Add(value);
            }
        }
    }
}
