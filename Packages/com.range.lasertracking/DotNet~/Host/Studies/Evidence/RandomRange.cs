using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Detection;
using LaserTracking.Host.Scoring;
using LaserTracking.Imaging;
using LaserTracking.Session;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>A simulated range with camera, projector, room and lasers drawn at random; equal seeds give equal ranges.</summary>
    internal sealed class RandomRange
    {
        private const double DurationS = 14;

        /// <summary>Light added by a dot, full scale 1, from which a picture shows it.</summary>
        private const double MinPeak = 0.04;

        public RandomRange(int seed)
        {
            Range = new SimulatedRange(Scenario(seed), SimulationScenes.Default());
            var dots = new List<TrueDot>();
            for (int frame = 0; frame < Range.Truth.ColorFrameCount; frame++)
                dots.AddRange(Range.Truth.DotsOf(frame).ToArray());
            ILookup<int, TrueDot> ofShot = dots.ToLookup(d => d.ShotId);
            var shots = new List<TruthShot>();
            var weak = new List<TruthShot>();
            foreach (TrueShot shot in Range.Truth.Shots.Where(s => s.FirstFrame >= 0))
            {
                TrueDot[] all = ofShot[shot.Id].ToArray(), seen = all.Where(d => d.Peak > MinPeak).ToArray();
                int first = seen.Length > 0 ? seen[0].Frame : shot.FirstFrame;
                (seen.Length > 0 ? shots : weak).Add(new TruthShot(FormattableString.Invariant($"{shot.Id}"), EventWords.Of(shot.Color), first, shot.LastFrame, all.Select(d => d.PositionPx).Prepend(shot.FirstLightPx).ToArray()));
            }

            Shots = shots;
            WeakShots = weak;
        }

        public SimulatedRange Range { get; }

        public IReadOnlyList<TruthShot> Shots { get; }

        /// <summary>Nothing of them can be seen.</summary>
        public IReadOnlyList<TruthShot> WeakShots { get; }

        private static SimulationScenario Scenario(int seed)
        {
            var random = new Random(seed);
            T Any<T>(params T[] values) => values[random.Next(values.Length)];
            var scenario = new SimulationScenario { Name = "random", Seed = seed, DurationS = DurationS };
            ColorCameraSettings camera = scenario.ColorCamera;
            (camera.Width, camera.Height) = Any((640, 480), (960, 540));
            camera.Gain = Any(0.3, 0.6, 1, 1.4, 2.2);
            camera.Format = Any(PixelFormat.Bgra32, PixelFormat.Nv12);
            if (camera.Format == PixelFormat.Nv12 && random.Next(2) == 0)
                camera.JpegQuality = 80;
            camera.FullWellElectrons = Any(1500, 9000, 30000);
            camera.BlurPx = 0.5 + random.NextDouble();
            scenario.DepthCamera.Enabled = false;
            scenario.Projector.Brightness = Any(0.5, 1, 1.6);
            scenario.Room.Ambient = Any(0.01, 0.05, 0.3);
            for (int i = 0; i < 3; i++)
            {
                var shooter = new ShooterSettings { OffsetXM = (i - 1) * 0.7 };
                shooter.Laser.PowerMw = 0.1 * Math.Pow(40, random.NextDouble());
                shooter.Laser.Color = i == 1 ? LaserColor.Red : LaserColor.Green;
                shooter.Laser.DotRadiusMm = 2 + 3 * random.NextDouble();
                scenario.Shooters.Add(shooter);
            }

            scenario.Generator.ShotsPerMinute = 45;
            scenario.Generator.AnywhereShare = 0.6;
            return scenario;
        }
    }
}
