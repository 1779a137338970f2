using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Geometry;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Studies.Calibration
{
    /// <summary>The automatic calibration of the screen in rooms drawn at random: what it reports, what is true, what it refuses.</summary>
    internal sealed class ScreenCalibrationStudy : IStudy
    {
        private const double LimitMm = 5;

        /// <summary>Chi squared with two degrees of freedom.</summary>
        private const double NinetyPercent = 4.605;

        private const int GridAcross = 25, GridDown = 15;

        public string Name => "screen-calibration";

        public string What => "automatic calibration of the screen in random rooms: held-out and true errors, refusals right and wrong.";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var results = new List<Result>();
            for (int seed = options.FirstSeed; seed <= options.LastSeed; seed++)
            {
                interrupted.ThrowIfCancellationRequested();
                options.Progress.Show(FormattableString.Invariant($"room {seed} …"));
                results.Add(Calibrate(seed));
            }

            var table = new StudyTable($"Automatic calibration of the screen, rooms {options.FirstSeed}..{options.LastSeed}, limit {LimitMm} mm", "rooms", "number",
                "accepted", "of these truly within the limit", "refused", "of these rightly", "held-out px", "held-out mm", "true mm", "true inside stated 90 %");
            Add(table, options, "all", results);
            Add(table, options, "nobody in front, not bumped, in focus", results.Where(r => !r.HasPerson && !r.IsBumped && !r.IsBlurred));
            Add(table, options, "person in front", results.Where(r => r.HasPerson && !r.IsBumped));
            Add(table, options, "out of focus", results.Where(r => r.IsBlurred && !r.IsBumped));
            Add(table, options, "bumped during the capture", results.Where(r => r.IsBumped));
            table.Notes.Add("Errors: median / 95th percentile / worst over all points of all accepted rooms. Held out: points of the second pattern, as reported. True: a grid over all of the screen that the camera sees, against the simulation's exact geometry.");
            table.Notes.Add("Inside the stated 90 %: share of the true errors within the ellipse of 90 % that the calibration's own covariance draws, lens included.");
            table.Notes.Add("A refusal is right when the fit was truly over the limit somewhere, when the camera was bumped, or when there was no fit.");
            foreach (Result wrong in results.Where(r => r.IsAccepted != r.ShouldBeAccepted))
                table.Notes.Add(FormattableString.Invariant($"room {wrong.Seed}: {(wrong.IsAccepted ? "accepted" : "refused")}, true error {wrong.TrueMax:F2} mm{(wrong.IsAccepted ? string.Empty : ": " + string.Join("; ", wrong.Calibration.Refusals))}"));
            return table;
        }

        private static Result Calibrate(int seed)
        {
            var room = new CalibrationRoom(seed);
            ScreenCalibration calibration = new ScreenCalibrator(room.Range.Scene.ScreenSizeM, LimitMm).Calibrate(room.Look());
            (double Mm, bool IsInside)[] errors = calibration.Screen == null ? [] : TrueErrors(calibration.Screen, room);
            return new Result(seed, room.HasPerson, room.IsBumped, room.IsBlurred, calibration, errors);
        }

        /// <summary>Over the part of the screen that lies in the picture, after whatever bumps there were, mm.</summary>
        private static (double Mm, bool IsInside)[] TrueErrors(ScreenGeometry found, CalibrationRoom room)
        {
            RangeCalibration truth = room.Range.Calibration;
            var errors = new List<(double Mm, bool IsInside)>();
            for (int i = 0; i < GridAcross * GridDown; i++)
            {
                Vector2D size = truth.Screen.ScreenSizeM;
                var place = new Vector2D(i % GridAcross * size.X / (GridAcross - 1), i / GridAcross * size.Y / (GridDown - 1));
                Vector2D px = truth.Screen.ToImagePx(place) + room.BumpPx;
                if (px.X >= 0 && px.Y >= 0 && px.X <= truth.ImageWidth - 1 && px.Y <= truth.ImageHeight - 1)
                {
                    Vector2D off = (found.ToScreenM(px) - place) * 1000;
                    Covariance2D c = found.ToScreenMm2(px, default);
                    double squared = (c.YY * off.X * off.X - 2 * c.XY * off.X * off.Y + c.XX * off.Y * off.Y) / (c.XX * c.YY - c.XY * c.XY);
                    errors.Add((off.Length, squared <= NinetyPercent));
                }
            }

            return errors.ToArray();
        }

        private static void Add(StudyTable table, StudyOptions options, string name, IEnumerable<Result> some)
        {
            Result[] results = some.ToArray(), accepted = results.Where(r => r.IsAccepted).ToArray(), refused = results.Where(r => !r.IsAccepted).ToArray();
            if (!options.Includes(name))
                return;
            table.Add(name, results.Length, new Proportion(accepted.Length, results.Length), new Proportion(accepted.Count(r => r.TrueMax <= LimitMm), accepted.Length),
                refused.Length, new Proportion(refused.Count(r => !r.ShouldBeAccepted), refused.Length),
                Spread(accepted.SelectMany(r => r.HeldOut.Select(p => p.OffPx.Length))), Spread(accepted.SelectMany(r => r.HeldOut.Select(p => p.OffMm.Length))), Spread(accepted.SelectMany(r => r.Errors.Select(e => e.Mm))), new Proportion(accepted.Sum(r => r.Errors.Count(e => e.IsInside)), accepted.Sum(r => r.Errors.Length)));
        }

        private static string Spread(IEnumerable<double> values)
        {
            PointErrors errors = PointErrors.Of(values.ToArray());
            return errors.Count == 0 ? "–" : FormattableString.Invariant($"{errors.Median:F3} / {errors.P95:F3} / {errors.Max:F3}");
        }

        private sealed record Result(int Seed, bool HasPerson, bool IsBumped, bool IsBlurred, ScreenCalibration Calibration, (double Mm, bool IsInside)[] Errors)
        {
            public bool IsAccepted => Calibration.IsAccepted;

            public double TrueMax => Errors.Length == 0 ? double.PositiveInfinity : Errors.Max(e => e.Mm);

            public bool ShouldBeAccepted => !IsBumped && TrueMax <= LimitMm;

            public IEnumerable<ScreenCheckPoint> HeldOut => Calibration.Points.Where(p => p.IsHeldOut && !p.IsLeftOut);
        }
    }
}
