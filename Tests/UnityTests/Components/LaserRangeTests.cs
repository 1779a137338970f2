using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Scoring;
using LaserTracking.Session;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;
using Object = UnityEngine.Object;

namespace LaserTracking.Unity
{
    public sealed class LaserRangeTests : StandInTests
    {
        private const int FlashFrame = 30;
        private const double FlashS = FlashFrame * StubSource.FrameIntervalUs * 1e-6;

        [Test]
        public void LaserRange_DotOnTarget_FiresShotAndTellsTheTarget()
        {
            var rig = new RangeRig(new StubSource(45, 5_000_000, (FlashFrame, 320, 240)));
            LaserTarget target = RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f);
            var hits = 0;
            target.Hit += _ => hits++;
            target.gameObject.SetActive(true);
            rig.Play(2);

            Assert.That(ConsoleLog.Entries, Is.Empty);
            Assert.That(rig.Shots, Has.Count.EqualTo(1));
            ShotEvent shot = rig.Shots[0];
            Assert.That(shot.Shot.FirstFrameIndex, Is.EqualTo(FlashFrame));
            Assert.That(shot.ScreenM.X, Is.EqualTo(1.865).Within(0.002));
            Assert.That(shot.HasHit, Is.True);
            Assert.That(shot.Hit.Target, Is.EqualTo("Plate 1"));
            Assert.That(shot.Hit.Points, Is.EqualTo(5));
            Assert.That(shot.Hit.PointM.Z, Is.EqualTo(3.995).Within(1e-3));
            Assert.That(hits, Is.EqualTo(1));
            Assert.That(rig.UnityEventShots, Has.Count.EqualTo(1));
            Assert.That(rig.Range.IsRunning, Is.False, "the source is at its end");
        }

        [Test]
        public void LaserRange_DotBesideTarget_FiresAShotThatMisses()
        {
            var rig = new RangeRig(new StubSource(45, 0, (FlashFrame, 420, 240)));
            LaserTarget target = RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f);
            target.Hit += _ => Assert.Fail("hit");
            target.gameObject.SetActive(true);
            rig.Play(2);
            Assert.That(rig.Shots.Single().HasHit, Is.False);
        }

        [Test]
        public void LaserRange_ShotAtMovingTarget_IsJudgedWhereItWasWhenTheLightLeft()
        {
            // At the flash it has travelled to x = 1.2; the eye is 3 m before the screen, the plate 4 m behind.
            const float Speed = 1.2f / (float)FlashS;
            double dotX = 1.2 * RangeRig.EyeDistanceM / (RangeRig.EyeDistanceM + 4);
            var rig = new RangeRig(new StubSource(60, 77_000_000, (FlashFrame, (int)Math.Round(320 + dotX / 3.73 * 640), 240)));
            LaserTarget target = RangeRig.AddPlate("Runner", new Vector3(0, 0, 4), 0.2f);
            TargetMotion motion = target.gameObject.AddComponent<TargetMotion>();
            SerializedFields.Set(motion, "_kind", MotionKind.PingPong);
            SerializedFields.Set(motion, "_travelM", new Vector3(Speed * 10, 0, 0));
            SerializedFields.Set(motion, "_periodS", 20f);
            target.gameObject.SetActive(true);

            // Unity's clock is not at zero when the range begins, and stutters just before the shot.
            PlayerLoop.Step(3.7);
            rig.Play(0.9);
            rig.Step(0.4);
            rig.Play(0.5);
            Assert.That(rig.Shots.Single().HasHit, Is.True);
            Assert.That(rig.Shots[0].Hit.LocalPointM.X, Is.EqualTo(0).Within(0.02));
            Assert.That(target.transform.localPosition.x, Is.GreaterThan(1.5f), "shown where it is now");
        }

        [Test]
        public void LaserRange_LiveSource_ShowsTargetsAheadByTheLatency()
        {
            var rig = new RangeRig(new StubSource(45, 0));
            rig.SourceAsset.Latency = 0.1;
            LaserTarget target = RangeRig.AddPlate("Runner", new Vector3(0, 0, 4), 0.2f);
            TargetMotion motion = target.gameObject.AddComponent<TargetMotion>();
            target.gameObject.SetActive(true);
            PlayerLoop.Step(2);
            rig.Range.gameObject.SetActive(true);
            rig.Step(0.5);
            Assert.That(motion.ClockOffsetS, Is.EqualTo(0.1 - 2.5).Within(1e-9));
        }

        [Test]
        public void LaserRange_ListenerThatThrows_LosesNoShot()
        {
            var rig = new RangeRig(new StubSource(90, 0, (FlashFrame, 200, 240), (FlashFrame, 440, 240), (60, 320, 300)));
            int calls = 0;
            rig.Range.ShotFired += _ =>
            {
                if (++calls == 1)
                    throw new InvalidOperationException("listener");
            };
            rig.Play(3.5);
            Assert.That(rig.Shots, Has.Count.EqualTo(3));
            Assert.That(ConsoleLog.Entries.Single().Message, Does.Contain("listener"));
        }

        [Test]
        public void LaserRange_TwoShotsInOneFrame_ArriveInTheSameUpdate()
        {
            var rig = new RangeRig(new StubSource(45, 0, (FlashFrame, 200, 240), (FlashFrame, 440, 240)));
            var updates = new List<int>();
            rig.Range.ShotFired += _ => updates.Add(Time.frameCount);
            rig.Play(2);
            Assert.That(updates, Has.Count.EqualTo(2));
            Assert.That(updates[0], Is.EqualTo(updates[1]));
        }

        [Test]
        public void LaserRange_Disabled_ClosesItsSourceAndBeginsAnew()
        {
            var rig = new RangeRig(new StubSource(200, 0));
            StubSource first = rig.Source;
            rig.Play(0.5);
            Assert.That(rig.Range.IsRunning, Is.True);
            rig.Range.enabled = false;
            Assert.That(first.IsDisposed, Is.True);
            Assert.That(rig.Range.IsRunning, Is.False);
            rig.Source = new StubSource(45, 0, (FlashFrame, 320, 240));
            rig.Range.enabled = true;
            rig.Play(2);
            Assert.That(rig.Shots, Has.Count.EqualTo(1));
            Object.DestroyImmediate(rig.Range.gameObject);
            Assert.That(rig.Source.IsDisposed, Is.True);
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void LaserRange_ShotInTheLastFrame_IsStillReported()
        {
            var rig = new RangeRig(new StubSource(FlashFrame + 1, 0, (FlashFrame, 320, 240)));
            rig.Play(2);
            Assert.That(rig.Shots, Has.Count.EqualTo(1));
        }

        [Test]
        public void Update_OfRangeAndTargets_AllocatesNothingOnceWarm()
        {
            var rig = new RangeRig(new StubSource(200, 0));
            LaserTarget onPath = RangeRig.AddPlate("path", new Vector3(0, 0, 4), 0.5f), carried = RangeRig.AddPlate("carried", new Vector3(0, 1, 4), 0.5f);
            TargetMotion path = onPath.gameObject.AddComponent<TargetMotion>(), remembered = carried.gameObject.AddComponent<TargetMotion>();
            SerializedFields.Set(path, "_kind", MotionKind.Sine);
            onPath.gameObject.SetActive(true);
            carried.gameObject.SetActive(true);
            rig.Play(1);
            Action[] calls = { Message(rig.Range, "Update"), Message(path, "Update"), Message(path, "LateUpdate"), Message(remembered, "LateUpdate") };
            long allocated = Allocation.Of(() =>
            {
                for (int i = 0; i < 20; i++)
                {
                    PlayerLoop.AdvanceTime(1 / 60.0);
                    foreach (Action call in calls)
                        call();
                }
            });
            Assert.That(allocated, Is.Zero);
            Assert.That(rig.Range.IsRunning, Is.True, "frames were processed all the time");
        }

        [Test]
        public void LaserRange_WithoutCalibration_SaysSoOnceAndStillFires()
        {
            var rig = new RangeRig(new StubSource(45, 0, (FlashFrame, 320, 240)), withCalibration: false);
            rig.Play(2);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.Contain("calibration"));
            Assert.That(rig.Shots.Single().HasScreenPosition, Is.False);
        }

        [TestCase("_source", "no source")]
        [TestCase("_viewpoint", "no viewpoint")]
        [TestCase("_screen", "no screen")]
        public void LaserRange_SomethingNotAssigned_SaysSoOnce(string field, string words)
        {
            var rig = new RangeRig(new StubSource(45, 0));
            SerializedFields.Set(rig.Range, field, null);
            rig.Play(1);
            Assert.That(ConsoleLog.Entries.Count(entry => entry.Message.Contains(words)), Is.EqualTo(1));
            Assert.That(ConsoleLog.Entries.Select(entry => entry.Type), Has.None.EqualTo(LogType.Exception));
        }

        [Test]
        public void LaserRange_ScreenOfAnotherSizeThanCalibrated_SaysSo()
        {
            var rig = new RangeRig(new StubSource(45, 0));
            SerializedFields.Set(rig.Screen, "_sizeM", new Vector2(3.5f, 2.26f));
            rig.Play(0.2);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.Contain("calibrated picture"));
        }

        [Test]
        public void LaserRange_SourceWithSceneTime_PutsTheSceneClockThere()
        {
            var rig = new RangeRig(new StubSource(45, 5_000_000));
            rig.SourceAsset.SceneZeroUs = 4_000_000;
            LaserTarget target = RangeRig.AddPlate("Runner", new Vector3(0, 0, 4), 0.2f);
            TargetMotion motion = target.gameObject.AddComponent<TargetMotion>();
            target.gameObject.SetActive(true);
            PlayerLoop.Step(2);
            rig.Range.gameObject.SetActive(true);
            rig.Step(0.5);
            Assert.That(motion.ClockOffsetS, Is.EqualTo(1 - 2.5).Within(1e-9), "the first frame is at scene time 1 s");
        }

        [Test]
        public void LaserRange_CalibrationThatIsNone_SaysWhatIsWrong()
        {
            var rig = new RangeRig(new StubSource(45, 0));
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset("{\"kind\":\"screen\"}"));
            rig.Play(1);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.StartWith("calibration of screen: "));
        }

        [Test]
        public void LaserRange_SourceThatCannotOpen_SaysWhy()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            rig.SourceAsset.Create = () => throw new InputException("camera", "not there", "plug it in");
            rig.Play(0.2);
            Assert.That(ConsoleLog.Entries.Single().Message, Is.EqualTo("camera: not there; plug it in"));
        }

        private static Action Message(MonoBehaviour component, string name) => (Action)Delegate.CreateDelegate(typeof(Action), component, name);
    }
}
