using System;
using System.Collections.Generic;
using LaserTracking.Detection;
using LaserTracking.Imaging;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>The simulated ranges that the measuring studies run on: cameras, shutters, formats, lasers; one scenario a name and seed.</summary>
    internal static class MeasuredRange
    {
        private const double DurationS = 14;

        private static readonly Dictionary<string, Action<SimulationScenario>> Variants = new()
        {
            ["720p30"] = _ => { },
            ["480p30 NV12, rolling"] = s => Camera(s, 640, 480, 30, 8330, PixelFormat.Nv12, 30),
            ["1080p30 NV12, rolling"] = s => Camera(s, 1920, 1080, 30, 16670, PixelFormat.Nv12, 15),
            ["720p60"] = s => Camera(s, 1280, 720, 60, 8330, PixelFormat.Bgra32, 0),
            ["480p15 YUY2, open shutter"] = s => Camera(s, 640, 480, 15, 66000, PixelFormat.Yuy2, 0),
            ["720p30 JPEG"] = s =>
            {
                Camera(s, 1280, 720, 30, 12000, PixelFormat.Yuy2, 20);
                s.ColorCamera.JpegQuality = 85;
            },
            ["720p30 short shutter"] = s =>
            {
                Camera(s, 1280, 720, 30, 1500, PixelFormat.Bgra32, 10);
                s.ColorCamera.Gain = 4;
            },
            ["720p30 dim lasers"] = s => Lasers(s, 0.06, 0.25),
            ["720p30 strong lasers"] = s => Lasers(s, 12, 0.25),
            ["720p30 coarse speckle"] = s => Lasers(s, 0.3, 0.5),
            ["480p30 over-exposed"] = s =>
            {
                Camera(s, 640, 480, 30, 16670, PixelFormat.Bgra32, 0);
                s.ColorCamera.Gain = 1.9;
            },
            ["480p30 far over-exposed"] = s =>
            {
                Camera(s, 640, 480, 30, 16670, PixelFormat.Bgra32, 0);
                s.ColorCamera.Gain = 3;
            },
        };

        public static IEnumerable<string> Names => Variants.Keys;

        /// <summary>Three shooters, two of them with a laser each of another colour, firing often; a fifth of the shots swept.</summary>
        public static SimulationScenario Create(string name, int seed)
        {
            var scenario = new SimulationScenario { Name = name, Seed = seed, DurationS = DurationS };
            scenario.DepthCamera.Enabled = false;
            for (int i = 0; i < 3; i++)
            {
                var shooter = new ShooterSettings { OffsetXM = i - 1.0, DistanceM = 2.3 + 0.3 * i };
                shooter.Laser.Color = i == 1 ? LaserColor.Red : LaserColor.Green;
                scenario.Shooters.Add(shooter);
            }

            scenario.Generator.ShotsPerMinute = 60;
            scenario.Generator.SweepShare = 0.2;
            Variants[name](scenario);
            return scenario;
        }

        private static void Camera(SimulationScenario scenario, int width, int height, double framesPerSecond, double exposureUs, PixelFormat format, double rowUs)
        {
            ColorCameraSettings camera = scenario.ColorCamera;
            camera.Width = width;
            camera.Height = height;
            camera.FramesPerSecond = framesPerSecond;
            camera.ExposureUs = exposureUs;
            camera.Format = format;
            camera.RollingShutterRowUs = rowUs;
        }

        private static void Lasers(SimulationScenario scenario, double powerMw, double speckle)
        {
            foreach (ShooterSettings shooter in scenario.Shooters)
            {
                shooter.Laser.PowerMw = powerMw;
                shooter.Laser.SpeckleContrast = speckle;
            }
        }
    }
}
