using System;
using LaserTracking.Detection;
using LaserTracking.Fusion;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Imaging;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>One frame of hands noted and its four shots given to people.</summary>
    internal static class PairBenchmark
    {
        private const int People = 4;
        private const long PeriodUs = 33_333;

        /// <summary>Places that made-up hands are at in turn.</summary>
        private const int Sways = 7;

        /// <summary>Depth frames that are found hands in beforehand, and before those to know everybody.</summary>
        private const int Frames = 24;

        /// <summary>Hands made up, without a depth picture.</summary>
        public static Action<int> Prepare()
        {
            var fusion = new ShooterAssignment(new HandCamera(new PinholeCamera(504, 504, 320, 288, 640, 576), Pose.Identity));
            var hands = new HandObservations();
            var made = new HandObservation[Sways * People];
            var people = new PersonObservation[Sways * People];
            var screen = new Vector2D[People];
            for (int i = 0; i < made.Length; i++)
            {
                int person = i % People;
                screen[person] = new Vector2D(0.5 + 0.8 * person, 1.0);
                var muzzle = new Vector3D(800.0 * person + 300, 900 + 10 * (i / People), -1500);
                Vector3D aim = (new Vector3D(screen[person].X * 1000, screen[person].Y * 1000, 0) - muzzle).Normalized;
                made[i] = new HandObservation { TrackId = person + 1, PersonId = person + 1, PalmMm = muzzle - aim * 150, MuzzleMm = muzzle, AimDirection = aim, SigmaMm = 10, MuzzleSigmaMm = 5 };
                people[i] = new PersonObservation { PersonId = person + 1, EyeMm = muzzle - aim * 750, SigmaMm = 60 };
            }

            var shots = new Shot[People];
            var fused = new FusedShot[People];
            return number =>
            {
                hands.Begin(number, number * PeriodUs);
                for (int i = number % Sways * People, end = i + People; i < end; i++)
                {
                    hands.Add(made[i]);
                    hands.Add(people[i]);
                }

                Fire(shots, number);
                fusion.AddHands(hands);
                fusion.Fuse(shots, screen, fused);
            };
        }

        /// <summary>Hands as found in simulated depth pictures, which are asked where weapons are that were not found. Copying a picture into place counts too.</summary>
        public static Action<int> PrepareWithPicture()
        {
            SimulatedRange range = FrameLoop.Range(320, 180, PixelFormat.Nv12, People, 40, 10);
            var frames = new FrameLoop(range.CreateDepthSource(), 2 * Frames);
            HandCamera camera = range.Calibration.HandCamera!;
            var tracker = new DepthHandTracker(camera);
            var found = new HandObservations[Frames];
            var dots = new Vector2D[Frames * People];
            for (int i = 0; i < 2 * Frames; i++)
            {
                HandObservations seen = found[i % Frames] = new HandObservations();
                tracker.Process(frames[i], seen);
                for (int k = 0; k < People; k++)
                    dots[i % Frames * People + k] = range.Truth.HandAt(k + 1, range.Truth.DepthFrameTimeUs(i)).DotM;
            }

            var fusion = new ShooterAssignment(camera);
            var hands = new HandObservations();
            var shots = new Shot[People];
            var fused = new FusedShot[People];
            return number =>
            {
                HandObservations seen = found[number % Frames];
                hands.Begin(number, number * PeriodUs);
                foreach (ref readonly HandObservation hand in seen.Hands)
                    hands.Add(hand);
                foreach (ref readonly PersonObservation person in seen.People)
                    hands.Add(person);
                hands.Depth.CopyFrom(seen.Depth);
                Fire(shots, number);
                fusion.AddHands(hands);
                fusion.Fuse(shots, new ReadOnlySpan<Vector2D>(dots, number % Frames * People, People), fused);
            };
        }

        private static void Fire(Shot[] shots, int number)
        {
            for (int i = 0; i < shots.Length; i++)
                shots[i] = new Shot { Id = number * People + i, TimeUs = number * PeriodUs, TrackId = number * People + i + 1, Dot = new Dot { Color = LaserColor.Green } };
        }
    }
}
