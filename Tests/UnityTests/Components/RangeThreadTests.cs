using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Threading;
using LaserTracking.Session;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;
using Object = UnityEngine.Object;

namespace LaserTracking.Unity
{
    /// <summary>What happens between the camera's thread and Unity's: nothing is lost, nothing stays, nothing hangs.</summary>
    public sealed class RangeThreadTests : StandInTests
    {
        [Test]
        public void LaserRange_ShotOnTheDetectorsThread_IsRaisedWithinTheNextUpdate()
        {
            var rig = new RangeRig(new StubSource(45, 0, (10, 320, 240)));
            rig.Range.gameObject.SetActive(true);
            bool wasWaiting = false;
            for (int i = 0; i < 90 && rig.Shots.Count == 0; i++)
            {
                PlayerLoop.Step(1 / 60.0);
                wasWaiting = rig.Shots.Count == 0;
                rig.Range.WaitForDueFrames();
                Assert.That(rig.Shots.Count == 0, Is.EqualTo(wasWaiting), "no event from another thread, and none between two Updates");
            }

            Assert.That(rig.Shots, Has.Count.EqualTo(1));
            Assert.That(Time.timeAsDouble, Is.LessThan(0.55), "a flash at a third of a second, told once it had ended");
        }

        [Test]
        public void LaserRange_FramesAreReadAndWorkedAt_OnAnotherThread()
        {
            var rig = new RangeRig(new StubSource(20, 0));
            rig.Play(0.3);
            Assert.That(rig.Source.Reader, Is.Not.Null.And.Not.SameAs(Thread.CurrentThread));
        }

        [Test]
        public void DetectorsThread_OnceWarm_AllocatesNothingFromFrameToFrame()
        {
            var rig = new RangeRig(new StubSource(300, 0, (70, 320, 240), (150, 200, 240)));
            rig.Play(10.5);
            Assert.That(rig.Range.IsRunning, Is.False);
            Assert.That(rig.Shots, Has.Count.EqualTo(2));
            Assert.That(rig.Source.LeastAllocatedIn20Frames(140, 290), Is.Zero);
        }

        [Test]
        public void LaserRange_SwitchedOffWhilePlaying_EndsItsThreadAndClosesTheSource()
        {
            var rig = new RangeRig(new StubSource(2000, 0));
            rig.Play(0.3);
            rig.Range.enabled = false;
            Assert.That(rig.Source.IsDisposed, Is.True);
            Assert.That(rig.Source.Reader!.Join(1000), Is.True);
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void LaserRange_SceneLeftAndLoadedAgain_LeavesNothingBehindAndPlays()
        {
            var readers = new List<Thread>();
            for (int round = 0; round < 3; round++)
            {
                var rig = new RangeRig(new StubSource(400, 0, (10, 320, 240)));
                rig.Play(0.8);
                Assert.That(rig.Shots, Has.Count.EqualTo(1), "round " + round);
                readers.Add(rig.Source.Reader!);
                Object.DestroyImmediate(rig.Range.gameObject);
                Assert.That(rig.Source.IsDisposed, Is.True);
                Assert.That(ShotEmitters.Count, Is.Zero);
                PlayerLoop.Reset();
            }

            Assert.That(readers.Where(thread => !thread.Join(1000)), Is.Empty);
        }

        [Test]
        public void Statics_OfTheAssembly_AreEitherConstantOrEmptiedWhenPlayBegins()
        {
            const BindingFlags Statics = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
            Type[] types = typeof(LaserRange).Assembly.GetTypes().Where(type => type.Name[0] != '<').ToArray();
            Assert.That(types.SelectMany(type => type.GetFields(Statics)).Where(field => !field.IsInitOnly && !field.IsLiteral), Is.Empty, "no domain reload: a value would survive from play to play");

            // Play is left without domain reload and even without OnDisable: the editor's own bookkeeping is gone, ours is not.
            var rig = new RangeRig(new StubSource(2000, 0));
            RangeRig.AddPlate("Runner", new Vector3(0, 0, 4), 0.2f).gameObject.AddComponent<TargetMotion>().gameObject.SetActive(true);
            rig.Play(0.1);
            Assert.That((ShotEmitters.Count, MovingTargets.Count), Is.EqualTo((1, 1)));
            foreach (MethodInfo method in types.SelectMany(type => type.GetMethods(Statics)))
            {
                var attribute = method.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>();
                if (attribute != null && attribute.loadType == RuntimeInitializeLoadType.SubsystemRegistration)
                    method.Invoke(null, null);
            }

            Assert.That((ShotEmitters.Count, MovingTargets.Count), Is.EqualTo((0, 0)));
        }

        [Test]
        public void LaserRange_CameraUnpluggedAndBack_SaysSoTwiceAndGoesOn()
        {
            RangeRig rig = LiveRig(new StubSource(15, 0) { PaceMs = 2 });
            int tries = 0;
            rig.Range.gameObject.SetActive(true);
            Until(() => rig.Health.Any(health => health.Kind == HealthKind.SetUp));
            rig.SourceAsset.Create = () => ++tries < 3 ? throw new InputException("camera", "not there", "plug it in") : new StubSource(4000, 9_000_000, Flashes) { PaceMs = 2 };
            Until(() => rig.Shots.Count > 0, 0.25);
            Assert.That(tries, Is.EqualTo(3));
            // A busy machine may also have lost frames, and says so.
            string[] said = rig.Health.Where(health => health.Kind == HealthKind.SetUp).Select(health => health.Text).ToArray();
            Assert.That(said, Has.Length.EqualTo(2));
            Assert.That(said[0], Does.Contain("gives no more pictures"));
            Assert.That(said[1], Does.Contain("is there again"));
            Assert.That(ConsoleLog.Entries.Select(entry => entry.Message), Is.SupersetOf(said));
        }

        [Test]
        public void LaserRange_CameraMissingAtStart_SaysSoOnceAndBeginsWhenItComes()
        {
            RangeRig rig = LiveRig(new StubSource(1, 0));
            bool isThere = false;
            rig.SourceAsset.Create = () => isThere ? new StubSource(4000, 0, Flashes) { PaceMs = 2 } : throw new InputException("camera 7", "is not there", "plug it in");
            rig.Range.gameObject.SetActive(true);
            for (int i = 0; i < 20; i++)
                PlayerLoop.Step(0.5);
            Assert.That(ConsoleLog.Entries.Single().Message, Is.EqualTo("camera 7: is not there; plug it in"));
            Assert.That(rig.Health.Single().Text, Is.EqualTo("camera 7: is not there; plug it in"));
            isThere = true;
            Until(() => rig.Shots.Count > 0, 0.25);
            Assert.That(rig.Shots[0].HasScreenPosition, Is.True);
        }

        [TestCase(0)]
        [TestCase(5)]
        public void LaserRange_Camera1UnpluggedAndBack_IsLookedForWhileCamera0PlaysOn(int breaksAfter)
        {
            RangeRig rig = LiveRig(new StubSource(100_000, 0) { PaceMs = 2 });
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset(RangeRig.TwoCameraCalibration));
            StubSourceAsset hands = ScriptableObject.CreateInstance<StubSourceAsset>();
            (hands.Live, hands.Latency) = (true, 0.05);
            var back = new StubSource(100_000, 0) { PaceMs = 2 };
            int tries = 0;
            hands.Create = () => ++tries == 1 ? new StubSource(10, 0) { BreaksAfter = breaksAfter } : tries < 4 ? throw new InputException("camera 1", "not there", "plug it in") : back;
            SerializedFields.Set(rig.Range, "_handSource", hands);
            rig.Range.gameObject.SetActive(true);
            Until(() => back.Reader != null, 0.25);
            Until(() => rig.Health.Any(health => health.Text.EndsWith("is there again")), 0.25);
            Assert.That((tries, rig.Range.IsRunning), Is.EqualTo((4, true)));
            string[] said = rig.Health.Where(health => health.Text.Contains("camera 1,")).Select(health => health.Text).ToArray();
            Assert.That(said, Has.Length.EqualTo(2));
            Assert.That(said[0], Does.Contain("gives no more pictures, so nobody knows who fires"));
            rig.Range.enabled = false;
            Assert.That(SpinWait.SpinUntil(() => back.IsDisposed, 2000), Is.True);
        }

        [Test]
        public void LaserRange_Camera1MissingAtStart_SaysSoOnceAndJoinsWhenItComes()
        {
            RangeRig rig = LiveRig(new StubSource(100_000, 0) { PaceMs = 2 });
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset(RangeRig.TwoCameraCalibration));
            StubSourceAsset hands = ScriptableObject.CreateInstance<StubSourceAsset>();
            hands.Live = true;
            bool isThere = false;
            var source = new StubSource(100_000, 0) { PaceMs = 2 };
            hands.Create = () => isThere ? source : throw new InputException("camera 1", "not there", "plug it in");
            SerializedFields.Set(rig.Range, "_handSource", hands);
            rig.Range.gameObject.SetActive(true);
            for (int i = 0; i < 20; i++)
                PlayerLoop.Step(0.5);
            Assert.That(rig.Health.Single(health => health.Kind == HealthKind.SetUp).Text, Is.EqualTo("camera 1: not there; plug it in; until it is there nobody knows who fires"));
            isThere = true;
            Until(() => source.Reader != null, 0.25);
        }

        [Test]
        public void LaserRange_SourceThatBreaksInTheMiddle_SaysWhyAndKeepsTheShotsBefore()
        {
            var rig = new RangeRig(new StubSource(60, 0, (10, 320, 240)) { BreaksAfter = 50 });
            rig.Play(2.5);
            Assert.That(rig.Shots, Has.Count.EqualTo(1));
            Assert.That(ConsoleLog.Entries.Single().Message, Is.EqualTo("stub: breaks; mend it"));
            Assert.That(rig.Range.IsRunning, Is.False);
        }

        [Test]
        public void LaserRange_DriverThatHangs_DoesNotHangUnity()
        {
            using var comesBack = new ManualResetEventSlim();
            RangeRig rig = LiveRig(new StubSource(100, 0) { HangsUntil = comesBack });
            rig.Range.gameObject.SetActive(true);
            PlayerLoop.Step(0.1);
            var watch = System.Diagnostics.Stopwatch.StartNew();
            rig.Range.enabled = false;
            Assert.That(watch.Elapsed.TotalSeconds, Is.LessThan(4));
            comesBack.Set();
            Assert.That(SpinWait.SpinUntil(() => rig.Source.IsDisposed, 2000), Is.True, "its own thread closes it when it comes back");
        }

        [Test]
        public void LaserRange_LiveCameraWithSlowReader_KeepsTheNewestAndCounts()
        {
            RangeRig rig = LiveRig(new StubSource(100, 0));
            int last = -1, seen = 0;
            rig.Range.SetLook(frame =>
            {
                seen++;
                last = frame.Index;
                Thread.Sleep(20);
            });
            rig.Range.gameObject.SetActive(true);
            Until(() => last == 99, 0.001);
            Assert.That(seen, Is.LessThan(20), "a hundred frames came at once, four of them can wait");
            Until(() => rig.Health.Any(health => health.Kind == HealthKind.FrameGap && health.Text.Contains("left out")));
            Assert.That(rig.Health.First(health => health.Text.Contains("left out")).Value, Is.GreaterThan(0));
        }

        [Test]
        public void EventInbox_MoreThanFits_KeepsTheFirstInOrderAndSaysHowManyAreLost()
        {
            var inbox = new EventInbox();
            for (int i = 0; i < EventInbox.ShotCapacity + 7; i++)
            {
                var shot = new ShotEvent();
                shot.Shot.Id = i;
                inbox.OnShot(shot);
            }

            for (int i = 0; i < EventInbox.ShotCapacity; i++)
            {
                Assert.That(inbox.TryTakeShot(out ShotEvent shot), Is.True);
                Assert.That(shot.Shot.Id, Is.EqualTo(i));
            }

            Assert.That(inbox.TryTakeShot(out _), Is.False);
            Assert.That(inbox.TryTakeHealth(out HealthEvent health), Is.True);
            Assert.That((health.Kind, health.Value), Is.EqualTo((HealthKind.Overflow, 7.0)));
            Assert.That(inbox.TryTakeHealth(out _), Is.False, "said once");
        }

        [Test]
        public void EventInbox_ManyThreads_LoseNoShot()
        {
            var inbox = new EventInbox();
            const int Shots = 20000;
            var writer = new Thread(() =>
            {
                for (int i = 0; i < Shots; i++)
                {
                    var shot = new ShotEvent();
                    shot.Shot.Id = i;
                    while (i - Volatile.Read(ref _taken) >= EventInbox.ShotCapacity)
                        Thread.Yield();
                    inbox.OnShot(shot);
                }
            });
            _taken = 0;
            writer.Start();
            while (_taken < Shots)
            {
                if (!inbox.TryTakeShot(out ShotEvent shot))
                    continue;
                if (shot.Shot.Id != _taken)
                    Assert.Fail("shot " + shot.Shot.Id + " after " + _taken);
                Volatile.Write(ref _taken, _taken + 1);
            }

            writer.Join();
            Assert.That(inbox.Overflow, Is.Zero);
        }

        private int _taken;

        [Test]
        public void EventInbox_DotsAndHands_AreThoseOfTheNewestFrame()
        {
            var inbox = new EventInbox();
            var dots = new DotEvent[EventInbox.LatestCapacity];
            var hands = new HandEvent[EventInbox.LatestCapacity];
            for (int frame = 1; frame <= 3; frame++)
            {
                for (int track = 0; track < frame; track++)
                {
                    inbox.OnDot(new DotEvent { FrameIndex = frame, TrackId = 10 * frame + track });
                    inbox.OnHand(new HandEvent { FrameIndex = frame, TrackId = 10 * frame + track });
                }
            }

            Assert.That(inbox.TakeDots(dots), Is.EqualTo(3));
            Assert.That(dots.Take(3).Select(dot => dot.TrackId), Is.EqualTo(new[] { 30, 31, 32 }));
            Assert.That(inbox.TakeHands(hands), Is.EqualTo(3));
            Assert.That(inbox.TakeDots(dots) + inbox.TakeHands(hands), Is.Zero, "each frame once");
            for (int i = 0; i < 2 * EventInbox.LatestCapacity; i++)
                inbox.OnDot(new DotEvent { FrameIndex = 4, TrackId = i });
            Assert.That(inbox.TakeDots(dots), Is.EqualTo(EventInbox.LatestCapacity));
        }

        [Test]
        public void EventInbox_OnceWarm_AllocatesNothing()
        {
            var inbox = new EventInbox();
            var dots = new DotEvent[EventInbox.LatestCapacity];
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 100; i++)
                {
                    inbox.OnShot(default);
                    inbox.OnDot(new DotEvent { FrameIndex = i });
                    inbox.TakeDots(dots);
                    inbox.TryTakeShot(out _);
                    inbox.TryTakeHealth(out _);
                }
            }), Is.Zero);
        }

        // Live frames may be left out on a busy machine: one flash alone might never be seen.
        private static (int Frame, int X, int Y)[] Flashes => Enumerable.Range(1, 100).Select(i => (30 * i, 320, 240)).ToArray();

        private static RangeRig LiveRig(StubSource source)
        {
            var rig = new RangeRig(source);
            rig.SourceAsset.Live = true;
            return rig;
        }

        /// <summary>Plays until it is so, at most half a real minute.</summary>
        private static void Until(Func<bool> isSo, double stepS = 1 / 60.0)
        {
            var watch = System.Diagnostics.Stopwatch.StartNew();
            while (!isSo() && watch.Elapsed.TotalSeconds < 30)
            {
                PlayerLoop.Step(stepS);
                Thread.Sleep(2);
            }

            Assert.That(isSo(), Is.True, string.Join("\n", ConsoleLog.Entries));
        }
    }
}
