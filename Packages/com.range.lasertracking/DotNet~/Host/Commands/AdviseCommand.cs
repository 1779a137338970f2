using System;
using System.CommandLine;
using System.Globalization;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Sources;
using LaserTracking.Host.Terminal;
using Newtonsoft.Json;

namespace LaserTracking.Host.Commands
{
    /// <summary>range advise: what is the dimmest and the shortest flash that will be caught here, and what to change.</summary>
    internal static class AdviseCommand
    {
        private const int FramesBetweenRounds = 3;

        public static Command Create()
        {
            var input = new Argument<string>("INPUT") { Description = "A recording, a video or a folder of images in which nobody fires at first." };
            var calibration = new Option<string?>("--calibration") { HelpName = "FILE", Description = "Where the screen lies in the image, and its size." };
            var seconds = new Option<double>("--seconds") { HelpName = "S", Description = "How much of it to look at.", DefaultValueFactory = _ => 3 };
            var defaults = new AdvisorSettings();
            var exposure = new Option<double>("--exposure-us") { HelpName = "US", Description = "The camera's exposure; half a frame is assumed without it." };
            var gamma = new Option<double>("--gamma") { HelpName = "G", Description = "Display value = light^(1/gamma).", DefaultValueFactory = _ => defaults.Gamma };
            var power = new Option<double>("--power-mw") { HelpName = "MW", Description = "The laser asked about.", DefaultValueFactory = _ => defaults.PowerMw };
            var radius = new Option<double>("--radius-mm") { HelpName = "MM", Description = "Radius of its dot (1/e²).", DefaultValueFactory = _ => defaults.DotRadiusMm };
            var color = new Option<LaserColor>("--color") { HelpName = "NAME", Description = "green, red or infrared.", DefaultValueFactory = _ => defaults.Color };
            var width = new Option<double>("--picture-width-m") { HelpName = "M", Description = "How wide a strip of wall the picture shows; needed without a calibration.", DefaultValueFactory = _ => defaults.PictureWidthM };
            var json = new Option<bool>("--json") { Description = "Prints JSON instead of a map." };
            var command = new Command("advise", "Says which flashes will be caught here, part by part of the screen, and what to change to gain most.") { input, calibration, seconds, exposure, gamma, power, radius, color, width, json };
            command.SetAction((parsed, interrupted) =>
            {
                string? calibrationName = parsed.GetValue(calibration);
                var settings = new AdvisorSettings
                {
                    ExposureUs = parsed.GetValue(exposure),
                    Gamma = parsed.GetValue(gamma),
                    PowerMw = parsed.GetValue(power),
                    DotRadiusMm = parsed.GetValue(radius),
                    Color = parsed.GetValue(color),
                    PictureWidthM = parsed.GetValue(width),
                };
                try
                {
                    settings.Validate();
                }
                catch (ArgumentException problem)
                {
                    throw new InputException("advise", problem.Message, "'./range help advise' lists the options");
                }

                ScreenGeometry? screen = calibrationName == null ? null : RangeCalibrationFile.Read(calibrationName).Screen;
                DetectionAdvice advice = Look(parsed.GetValue(input)!, parsed.GetValue(seconds), settings, screen, interrupted);
                if (parsed.GetValue(json))
                    Console.WriteLine(Json(advice, settings));
                else
                    Print(advice, settings, screen != null);
                return Task.FromResult(ExitCodes.Done);
            });
            return command;
        }

        private static DetectionAdvice Look(string input, double seconds, AdvisorSettings settings, ScreenGeometry? screen, CancellationToken interrupted)
        {
            using IFrameSource source = new PrefetchingFrameSource(FrameSources.OpenScreenCamera(input));
            using var progress = new ProgressLine();
            var detector = new ShotDetector();
            var detections = new Detections();
            var advisor = new DetectionAdvisor(detector, settings, screen);
            using var frame = new Frame();
            long? firstUs = null;
            while (source.TryRead(frame))
            {
                interrupted.ThrowIfCancellationRequested();
                firstUs ??= frame.TimeUs;
                if (frame.TimeUs - firstUs > seconds * 1e6)
                    break;
                progress.Show(FormattableString.Invariant($"frame {frame.Index + 1}"));
                detector.Process(frame, detections);
                if (frame.Index % FramesBetweenRounds == 0)
                    advisor.LookEverywhere(frame);
                else
                    advisor.Note(frame);
            }

            if (advisor.Rounds == 0)
                throw new InputException(input, "has too few frames with a picture to learn its background from", "give a recording of a second or more");
            return advisor.Advise();
        }

        private static void Print(DetectionAdvice advice, AdvisorSettings settings, bool isCalibrated)
        {
            Console.WriteLine(char.ToUpperInvariant(advice.Sentence[0]) + advice.Sentence[1..] + ".");
            Console.WriteLine();
            Map("shortest flash caught, ms", advice, region => region.ShortestMs, "0.#");
            Map("dimmest dot caught when lit for a whole exposure, rise in levels", advice, region => region.DimmestLevels, "0");
            string exposure = settings.ExposureUs > 0 ? "as given" : "assumed: give --exposure-us";
            string size = isCalibrated ? "the calibration's" : FormattableString.Invariant($"a picture {settings.PictureWidthM:0.##} m wide (assumed: give --calibration or --picture-width-m)");
            Console.WriteLine(FormattableString.Invariant($"Taken for given: exposure {advice.ExposureUs / 1000:0.#} ms of {advice.IntervalUs / 1000:0.#} ms ({exposure}); size {size}; the brightest parts of the picture are projected white of {settings.WhiteWPerM2:0.##} W/m²; \"caught\" is {settings.CaughtShare * 100:0.#} % of flashes at any moment."));
        }

        private static void Map(string title, DetectionAdvice advice, Func<RegionAdvice, double> value, string format)
        {
            Console.WriteLine(title + " (– : not caught)");
            for (int row = 0; row < advice.Rows; row++)
            {
                Console.WriteLine(string.Concat(Enumerable.Range(0, advice.Columns).Select(column =>
                {
                    double number = value(advice.Regions[row * advice.Columns + column]);
                    return (double.IsNaN(number) ? "–" : number.ToString(format, CultureInfo.InvariantCulture)).PadLeft(7);
                })));
            }

            Console.WriteLine();
        }

        private static string Json(DetectionAdvice advice, AdvisorSettings settings)
        {
            static double? Known(double value) => double.IsNaN(value) ? null : Math.Round(value, 5);
            return JsonConvert.SerializeObject(new
            {
                sentence = advice.Sentence,
                gain = advice.Gain,
                power_mw = settings.PowerMw,
                exposure_us = advice.ExposureUs,
                interval_us = advice.IntervalUs,
                blind_parts = advice.BlindRegions,
                shortest_ms = Known(advice.ShortestMs),
                dimmest_mw = Known(advice.DimmestMw),
                dimmest_levels = Known(advice.DimmestLevels),
                columns = advice.Columns,
                rows = advice.Rows,
                regions = advice.Regions.Select(r => new { shortest_ms = Known(r.ShortestMs), dimmest_mw = Known(r.DimmestMw), dimmest_levels = Known(r.DimmestLevels), background_level = Known(r.BackgroundLevel) }),
            }, Formatting.Indented);
        }
    }
}
