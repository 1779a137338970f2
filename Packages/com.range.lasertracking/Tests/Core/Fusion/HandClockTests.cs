using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Fusion
{
    /// <summary>One who swings the weapon to and fro and fires while it moves; camera 1 stamps its pictures wrongly.</summary>
    public sealed class HandClockTests
    {
        private const double ReachM = 0.75;
        private const double NoiseMm = 4;

        /// <summary>As the tracker says at 30 frames a second.</summary>
        private const long TimeSigmaUs = 13_608;
        private const double FirstS = 1;
        private const double EveryS = 1.37;
        private static readonly Vector3D Eyes = new Vector3D(1.4, 0.9, -2.9);

        private static readonly HandCamera Camera = new HandCamera(
            new PinholeCamera(504, 504, 320, 288, 640, 576),
            new Pose(new Vector3D(1865, 0, 0), Rotation3D.AboutAxis(new Vector3D(0, 1, 0), Math.PI)));

        private ShooterAssignment _assignment = null!;
        private int _shots;
        private int _named;

        /// <summary>The bore lies so far below the eyes.</summary>
        private static readonly Vector3D Sights = new Vector3D(0, new FusionSettings().SightHeightM, 0);

        [SetUp]
        public void SetUp()
        {
            _assignment = new ShooterAssignment(Camera);
            _shots = _named = 0;
        }

        [TestCase(70_000)]
        [TestCase(-50_000)]
        [TestCase(30_000)]
        public void Clock_Off_IsFoundWithinTenMilliseconds(int offsetUs)
        {
            Run(90, offsetUs, 0, 30, true);
            Assert.That(_assignment.HandClockOffsetUs, Is.EqualTo(offsetUs).Within(10_000));
            Assert.That(_assignment.HandClockSigmaUs, Is.InRange(1, 10_000));
        }

        [Test]
        public void Clock_Right_IsLeftAlone()
        {
            Run(120, 0, 0, 30, true);
            Assert.That(_assignment.HandClockOffsetUs, Is.Zero);
            Assert.That(_named, Is.GreaterThan(0.9 * _shots));
        }

        [Test]
        public void Clock_DriftsByAHundredPartsInAMillion_IsFollowed()
        {
            Run(600, 0, 100, 30, true);
            Assert.That(_assignment.HandClockOffsetUs, Is.EqualTo(60_000).Within(15_000));
            Assert.That(_named, Is.GreaterThan(0.9 * _shots));
        }

        [Test]
        public void Clock_DotsThatStandStill_TellNothing()
        {
            Run(60, 70_000, 0, 30, false);
            Assert.That(_assignment.HandClockOffsetUs, Is.Zero);
        }

        [TestCase(70_000)]
        [TestCase(-70_000)]
        public void Clock_FewShotsFromASwing_IsFoundWithinTenMilliseconds(int offsetUs)
        {
            Run(60, offsetUs, 0, 30, IsSwing, HoldsOrSwings);
            Assert.That(_assignment.HandClockOffsetUs, Is.EqualTo(offsetUs).Within(10_000));
        }

        [Test]
        public void Clock_RightWithFewShotsFromASwing_IsLeftAlone()
        {
            Run(120, 0, 0, 30, IsSwing, HoldsOrSwings);
            Assert.That(_assignment.HandClockOffsetUs, Is.Zero);
            Assert.That(_named, Is.GreaterThan(0.9 * _shots));
        }

        [Test]
        public void Clock_OneShotFromASwing_TellsNothing()
        {
            Run(6, 70_000, 0, 30, IsSwing, HoldsOrSwings);
            Assert.That(_assignment.HandClockOffsetUs, Is.Zero);
        }

        [TestCase(230_000)]
        [TestCase(-230_000)]
        [TestCase(300_000)]
        [TestCase(-300_000)]
        public void Clock_FarOff_IsFoundWithinTwentyMilliseconds(int offsetUs)
        {
            Run(60, offsetUs, 0, 30, IsSwing, HoldsOrSwings);
            Assert.That(_assignment.HandClockOffsetUs, Is.EqualTo(offsetUs).Within(20_000));
        }

        [TestCase(450_000)]
        [TestCase(-600_000)]
        [TestCase(850_000)]
        [TestCase(-850_000)]
        public void Clock_OffByMoreThanIsLookedFor_IsNotSaid(int offsetUs)
        {
            Run(60, offsetUs, 0, 30, IsSwing, HoldsOrSwings);
            Assert.That(_assignment.HandClockOffsetUs, Is.Zero);
        }

        [TestCase(15)]
        [TestCase(12.5)]
        [TestCase(5)]
        public void Fuse_CameraOneAtAnotherRate_StillNames(double framesPerSecond)
        {
            Run(60, 0, 0, framesPerSecond, true);
            Assert.That(_named, Is.GreaterThan(0.7 * _shots));
        }

        [Test]
        public void Reset_ForgetsTheClock()
        {
            Run(90, 70_000, 0, 30, true);
            _assignment.Reset();
            Assert.That(_assignment.HandClockOffsetUs, Is.Zero);
        }

        private void Run(double seconds, double offsetUs, double driftPpm, double framesPerSecond, bool showsMotion) =>
            Run(seconds, offsetUs, driftPpm, framesPerSecond, _ => showsMotion, AimedAt);

        private void Run(double seconds, double offsetUs, double driftPpm, double framesPerSecond, Func<int, bool> showsMotion, Func<double, Vector3D> aimedAt)
        {
            var hands = new HandObservations();
            var random = new Random(7);
            double frame = 0;
            long Stamp(double time) => (long)(time * 1e6 + offsetUs + time * driftPpm);
            for (double shot = FirstS; shot < seconds; shot += EveryS)
            {
                // What camera 1 has delivered by then, as the stamps say with what is known of its clock.
                while (Stamp(frame) - _assignment.HandClockOffsetUs <= shot * 1e6)
                {
                    hands.Begin(0, Stamp(frame));
                    hands.Add(new PersonObservation { PersonId = 1, EyeMm = Camera.ToCameraMm(Eyes - Sights), SigmaMm = 60 });
                    Vector3D aim = (aimedAt(frame) - Eyes).Normalized;
                    var noise = new Vector3D(Noise(random), Noise(random), Noise(random));
                    Vector3D muzzle = Camera.ToCameraMm(Eyes + aim * ReachM) + noise;
                    hands.Add(new HandObservation { TrackId = 1, PersonId = 1, MuzzleMm = muzzle, PalmMm = muzzle, SigmaMm = 12, MuzzleSigmaMm = 7 });
                    _assignment.AddHands(hands);
                    frame += 1 / framesPerSecond;
                }

                var fired = new Shot { TimeUs = (long)(shot * 1e6), TimeSigmaUs = TimeSigmaUs, Dot = new Dot { Color = LaserColor.Green, StreakPx = new Vector2D(showsMotion(_shots) ? 4 : 0, 0) } };
                Vector3D dot = aimedAt(shot);
                _shots++;
                _named += _assignment.Fuse(fired, new Vector2D(dot.X, dot.Y)).Shooter > 0 ? 1 : 0;
            }
        }

        /// <summary>Up to 1.9 m/s on the screen, and a slower way up and down.</summary>
        private static Vector3D AimedAt(double time) => new Vector3D(1.8 + 0.8 * Math.Sin(2 * Math.PI * 0.37 * time), 1.1 + 0.4 * Math.Sin(2 * Math.PI * 0.11 * time), 0);

        /// <summary>Every fourth shot.</summary>
        private static bool IsSwing(int shot) => shot % 4 == 3;

        /// <summary>Holds still on a mark from 0.3 s before to 0.3 s after a shot, or goes by it at 1 m/s, to and fro; from mark to mark in between.</summary>
        private static Vector3D HoldsOrSwings(double time)
        {
            const double held = 0.3;
            int shot = Math.Max(0, (int)Math.Round((time - FirstS) / EveryS));
            double since = time - FirstS - shot * EveryS;
            int other = since > 0 ? shot + 1 : Math.Max(0, shot - 1);
            double away = Math.Max(0, Math.Min(1, (Math.Abs(since) - held) / (EveryS - 2 * held)));
            Vector3D from = Mark(shot, Math.Max(-held, Math.Min(held, since))), to = Mark(other, since > 0 ? -held : held);
            return from + (to - from) * away;
        }

        private static Vector3D Mark(int shot, double since) =>
            new Vector3D(1.8 + 1.2 * Math.Sin(2.1 * shot) + (IsSwing(shot) ? (shot % 8 == 3 ? since : -since) : 0), 1.1 + 0.6 * Math.Sin(1.3 * shot), 0);

        private static double Noise(Random random) => NoiseMm * (random.NextDouble() + random.NextDouble() + random.NextDouble() - 1.5) * 2;
    }
}
