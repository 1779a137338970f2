using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using NUnit.Framework;

namespace LaserTracking.Simulation
{
    public sealed class SimulationTruthTests
    {
        [Test]
        public void SimulationTruth_LineFromMuzzle_MeetsTheDot()
        {
            SimulatedRange range = ThreeShooters();
            Assert.That(range.Truth.Shots.Count, Is.GreaterThan(20));
            foreach (TrueShot shot in range.Truth.Shots)
            {
                Vector3D meets = shot.MuzzleM + shot.Direction * (-shot.MuzzleM.Z / shot.Direction.Z);
                Assert.That((new Vector2D(meets.X, meets.Y) - shot.ScreenM).Length, Is.LessThan(1e-9));
                Assert.That((range.Calibration.Screen.ToImagePx(shot.ScreenM) - shot.FirstLightPx).Length, Is.LessThan(1e-6));
                TrueHand hand = range.Truth.HandAt(shot.Shooter, shot.SceneTimeUs);
                Assert.That((hand.MuzzleM - shot.MuzzleM).Length, Is.LessThan(1e-5));
                Assert.That((hand.MuzzleM - hand.PalmM).Length, Is.InRange(0.1, 0.2));
                Assert.That((hand.PalmM - hand.ElbowM).Length, Is.InRange(0.25, 0.42));
                Assert.That((hand.ElbowM - hand.ShoulderM).Length, Is.InRange(0.25, 0.42));
            }
        }

        [Test]
        public void SimulationTruth_Barrel_DiffersFromTheLightByTheBoresightError()
        {
            SimulatedRange range = ThreeShooters();
            for (int shooter = 1; shooter <= 3; shooter++)
            {
                TrueHand early = range.Truth.HandAt(shooter, 2e6), late = range.Truth.HandAt(shooter, 25e6);
                double a = Vector3D.Cross(early.LightDirection, early.BarrelDirection).Length;
                double b = Vector3D.Cross(late.LightDirection, late.BarrelDirection).Length;
                Assert.That(a, Is.InRange(0.0001, 0.03));
                Assert.That(b, Is.EqualTo(a).Within(0.2 * a), "a fixed error of the weapon");
            }
        }

        [Test]
        public void SimulationTruth_Hands_MoveAsHandsDo()
        {
            SimulatedRange range = ThreeShooters();
            double fastest = 0;
            for (double t = 0; t < 30e6; t += 5000)
            {
                TrueHand a = range.Truth.HandAt(2, t), b = range.Truth.HandAt(2, t + 1000);
                double speed = (b.PalmM - a.PalmM).Length / 0.001;
                fastest = Math.Max(fastest, speed);
                Assert.That(speed, Is.LessThan(6), "at " + t);
            }

            Assert.That(fastest, Is.GreaterThan(0.1));
        }

        [Test]
        public void SimulationTruth_AimedShot_HitsWhatItAimedAtUnlessTheAimWasOff()
        {
            SimulationScenario scenario = SimulationExamples.Small(8);
            scenario.Projector.DelayMs = 0;
            scenario.Projector.RefreshHz = 1000;
            string[] names = { "Popper 1", "Paper 1", "Silhouette 2", "No-shoot 1", "Paper 2", "Silhouette 1" };
            for (int i = 0; i < names.Length; i++)
                scenario.Shots.Add(new ShotSettings { TimeS = 0.5 + i, Target = names[i] });
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            for (int i = 0; i < names.Length; i++)
            {
                Assert.That(range.Truth.Shots[i].Target, Is.EqualTo(names[i]));
                Assert.That(range.Truth.Shots[i].ShownTarget, Is.EqualTo(names[i]));
                Assert.That(range.Truth.Shots[i].AimedAt, Is.EqualTo(names[i]));
            }

            Assert.That(range.Truth.Shots[0].Zone, Is.EqualTo("steel"));
            Assert.That(range.Truth.Shots[1].Zone, Is.EqualTo("10"));
            Assert.That(range.Truth.Shots[1].Points, Is.EqualTo(10));
            Assert.That(range.Truth.Shots[3].Points, Is.EqualTo(-10));
        }

        [Test]
        public void SimulationTruth_DelayedPicture_ShowsWhereTheTargetWas()
        {
            SimulationScenario scenario = SimulationExamples.Small(3);
            scenario.Projector.DelayMs = 500;
            scenario.Shots.Add(new ShotSettings { TimeS = 2, Target = "Popper 3", OffsetM = new Vector2D(0, 0.3) });
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            Assert.That(range.Truth.Shots[0].ShownTarget, Is.EqualTo("Popper 3"));
            Assert.That(range.Truth.Shots[0].Target, Is.Empty, "by the photon's time the target has moved on by a quarter of a metre");
        }

        [Test]
        public void SimulationTruth_Tremor_HasTheFrequencyAndSizeOfTheSettings()
        {
            var settings = new TremorSettings { FrequencyHz = 8, WanderHz = 0, AmplitudeMrad = 0.5, SwayMrad = 0 };
            var tremor = new Tremor(settings, 3, 0);
            double square = 0, best = 0, bestHz = 0;
            const int samples = 6000;
            for (int i = 0; i < samples; i++)
            {
                double x = tremor.AngleRad(i / 100.0).X * 1000;
                square += x * x / samples;
            }

            for (double hz = 4; hz <= 12; hz += 0.05)
            {
                double re = 0, im = 0;
                for (int i = 0; i < samples; i++)
                {
                    double x = tremor.AngleRad(i / 100.0).X;
                    re += x * Math.Cos(2 * Math.PI * hz * i / 100);
                    im += x * Math.Sin(2 * Math.PI * hz * i / 100);
                }

                if (re * re + im * im > best)
                {
                    best = re * re + im * im;
                    bestHz = hz;
                }
            }

            Assert.That(Math.Sqrt(square), Is.EqualTo(0.5).Within(0.02));
            Assert.That(bestHz, Is.EqualTo(8).Within(0.06));
        }

        [Test]
        public void SimulationTruth_DrawnTremor_StaysInThePublishedPopulation()
        {
            double sum = 0, squares = 0;
            const int people = 400;
            for (int i = 0; i < people; i++)
            {
                var tremor = new Tremor(new TremorSettings(), i, 0);
                Assert.That(tremor.FrequencyHz, Is.InRange(4, 12));
                Assert.That(tremor.AmplitudeMrad, Is.InRange(0.05, 1.4));
                sum += tremor.FrequencyHz;
                squares += tremor.FrequencyHz * tremor.FrequencyHz;
            }

            double mean = sum / people;
            Assert.That(mean, Is.EqualTo(7).Within(0.25));
            Assert.That(Math.Sqrt(squares / people - mean * mean), Is.EqualTo(1.3).Within(0.2));
        }

        [Test]
        public void SimulationTruth_GeneratedShots_FollowTheGeneratorsRules()
        {
            SimulatedRange range = ThreeShooters();
            IReadOnlyList<TrueShot> shots = range.Truth.Shots;
            int simultaneous = 0, close = 0;
            for (int i = 0; i < shots.Count; i++)
            {
                Assert.That(shots[i].Id, Is.EqualTo(i + 1));
                Assert.That(shots[i].PulseUs, Is.InRange(4999, 300001));
                for (int j = 0; j < i; j++)
                {
                    if (shots[j].Shooter == shots[i].Shooter)
                        Assert.That(shots[i].SceneTimeUs, Is.GreaterThan(shots[j].SceneTimeUs + shots[j].PulseUs));
                    simultaneous += shots[j].SceneTimeUs == shots[i].SceneTimeUs ? 1 : 0;
                    close += shots[j].Shooter == shots[i].Shooter && (shots[j].ScreenM - shots[i].ScreenM).Length < 0.05 ? 1 : 0;
                }
            }

            Assert.That(simultaneous, Is.GreaterThan(0));
            Assert.That(close, Is.GreaterThan(0), "double taps");
        }

        private static SimulatedRange ThreeShooters()
        {
            SimulationScenario scenario = SimulationExamples.Small(30);
            scenario.Shooters.Clear();
            scenario.Shooters.Add(new ShooterSettings { OffsetXM = -0.7 });
            scenario.Shooters.Add(new ShooterSettings { Hand = HandSide.Left });
            scenario.Shooters.Add(new ShooterSettings { OffsetXM = 0.7, TwoHanded = true });
            scenario.Generator.ShotsPerMinute = 40;
            scenario.Generator.SimultaneousShare = 0.3;
            scenario.Generator.DoubleTapShare = 0.4;
            return new SimulatedRange(scenario, SimulationScenes.Default());
        }
    }
}
