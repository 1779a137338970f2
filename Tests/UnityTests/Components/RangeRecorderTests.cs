using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Pipeline;
using LaserTracking.Scoring;
using LaserTracking.Session;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    public sealed class RangeRecorderTests : StandInTests
    {
        private string _folder = "";

        [SetUp]
        public void MakeFolder() => _folder = Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), "range-unity-recorder-" + Guid.NewGuid().ToString("N"))).FullName;

        [TearDown]
        public void RemoveFolder() => Directory.Delete(_folder, true);

        private RangeRecorder Add(RangeRig rig)
        {
            rig.Range.gameObject.SetActive(false);
            RangeRecorder recorder = rig.Range.gameObject.AddComponent<RangeRecorder>();
            SerializedFields.Set(recorder, "_folder", _folder);
            return recorder;
        }

        private static List<Frame> Read(string session)
        {
            using var source = new KinectRecordingSource(KinectRecording.Open(Path.Combine(session, SessionLog.ScreenFramesName)));
            var frames = new List<Frame>();
            for (var frame = new Frame(); source.TryRead(frame); frame = new Frame())
                frames.Add(frame);
            Assert.That(source.Problems, Is.Empty);
            return frames;
        }

        /// <summary>The shots of a session, run again from its files alone.</summary>
        private static IReadOnlyList<ShotEvent> Replay(string session)
        {
            var found = new SessionRecorder();
            Replay(session, found);
            return found.Shots;
        }

        private static void Replay(string session, IEventSink sink)
        {
            SessionLog log = SessionLogFile.Read(session);
            RangeCalibration? calibration = log.HasCalibration ? RangeCalibrationFile.Read(Path.Combine(session, SessionLog.CalibrationFileName)) : null;
            SceneModel? scene = log.HasScene ? ScenePoseLog.Read(Path.Combine(session, SessionLog.SceneFileName)) : null;
            RangePipeline pipeline = RangePipeline.CreateDefault(new ShotDetector(), calibration, false, scene == null ? null : new ShotScorer(scene), sink, new PipelineSettings { SceneTimeZeroUs = log.SceneTimeZeroUs });
            pipeline.Begin(log.Header);
            using var source = new KinectRecordingSource(KinectRecording.Open(Path.Combine(session, SessionLog.ScreenFramesName)));
            using var runner = new SessionRunner(pipeline, source, null, 0);
            runner.Run(default);
            pipeline.End(log.SecondsWall ?? 0);
        }

        private static string[] ReplayLines(string session)
        {
            var bytes = new MemoryStream();
            Replay(session, new JsonLinesSink(bytes));
            return Lines(System.Text.Encoding.UTF8.GetString(bytes.ToArray()));
        }

        private static string[] EventLines(string session) => Lines(File.ReadAllText(Path.Combine(session, SessionLog.EventsFileName)));

        private static string[] Lines(string text)
        {
            Assert.That(text, Does.EndWith("\n"));
            return text.TrimEnd('\n').Split('\n');
        }

        [Test]
        public void RangeRecorder_Session_HoldsEveryFrameToTheBit()
        {
            var rig = new RangeRig(new StubSource(40, 7_000_000));
            RangeRecorder recorder = Add(rig);
            rig.Play(1.6);
            Assert.That(recorder.IsRecording, Is.False, "the source has ended, so has the session");
            List<Frame> frames = Read(recorder.SessionFolder);
            var again = new StubSource(40, 7_000_000);
            using var expected = new Frame();
            foreach (Frame frame in frames)
            {
                Assert.That(again.TryRead(expected), Is.True);
                Assert.That((frame.Index, frame.TimeUs), Is.EqualTo((expected.Index, expected.TimeUs)));
                Assert.That(frame.Color.Bytes.SequenceEqual(expected.Color.Bytes), Is.True);
            }

            Assert.That(frames, Has.Count.EqualTo(40));
            SessionLog log = SessionLogFile.Read(recorder.SessionFolder);
            Assert.That((log.IsComplete, log.Lost, log.Frames, log.HasCalibration), Is.EqualTo((true, 0L, 40L, true)));
            Assert.That(log.Doubts(log.Build), Is.Empty);
        }

        [Test]
        public void RangeRecorder_SourceThatKnowsItsDevicesCalibration_HasItInTheRecording()
        {
            var rig = new RangeRig(new StubSource(20, 0));
            byte[] json = { (byte)'{', (byte)'}' };
            // As a device that is opened by its own thread: known with the first frame.
            rig.SourceAsset.Create = () =>
            {
                rig.SourceAsset.Device = json;
                return rig.Source;
            };
            RangeRecorder recorder = Add(rig);
            rig.Play(1);
            using KinectRecording recording = KinectRecording.Open(Path.Combine(recorder.SessionFolder, SessionLog.ScreenFramesName));
            Assert.That(recording.TryReadCalibration(out byte[] read), Is.True);
            Assert.That(read, Is.EqualTo(json));

            string streaming = Desk.StreamingAssetsPath;
            Desk.StreamingAssetsPath = recorder.SessionFolder;
            RecordingSource source = ScriptableObject.CreateInstance<RecordingSource>();
            SerializedFields.Set(source, "_file", SessionLog.ScreenFramesName);
            source.CreateSource(rig.Range).Dispose();
            Desk.StreamingAssetsPath = streaming;
            Assert.That(source.DeviceCalibration, Is.EqualTo(json), "it goes from recording to recording");
        }

        [Test]
        public void RangeRecorder_Replay_FindsTheSameShotsAndHits()
        {
            var rig = new RangeRig(new StubSource(60, 0, (10, 320, 240), (30, 100, 100)));
            LaserTarget plate = RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.5f);
            plate.gameObject.SetActive(true);
            RangeRecorder recorder = Add(rig);
            rig.Play(2.2);
            IReadOnlyList<ShotEvent> replayed = Replay(recorder.SessionFolder);
            Assert.That(rig.Shots, Has.Count.EqualTo(2));
            Assert.That(replayed.Select(s => (s.Shot.Id, s.Shot.TimeUs, s.Shot.Dot.PositionPx.X, s.ScreenM.X, s.HasHit)), Is.EqualTo(rig.Shots.Select(s => (s.Shot.Id, s.Shot.TimeUs, s.Shot.Dot.PositionPx.X, s.ScreenM.X, s.HasHit))));
            Assert.That((replayed[0].Hit.Target, replayed[0].Hit.Zone), Is.EqualTo((rig.Shots[0].Hit.Target, rig.Shots[0].Hit.Zone)).And.EqualTo(("plate", "plate")));
        }

        [Test]
        public void RangeRecorder_Replay_WritesTheSameEventsToTheByte()
        {
            // A hit, a miss, and one in the last frames: it is told when the source has ended.
            var rig = new RangeRig(new StubSource(60, 0, (10, 320, 240), (30, 100, 100), (56, 320, 240)));
            RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.5f).gameObject.SetActive(true);
            RangeRecorder recorder = Add(rig);
            rig.Play(2.4);
            Assert.That(recorder.IsRecording, Is.False);
            Assert.That(rig.Shots, Has.Count.EqualTo(3));
            string[] written = EventLines(recorder.SessionFolder);
            Assert.That(written, Is.EqualTo(ReplayLines(recorder.SessionFolder)));
            Assert.That(written.Count(line => line.Contains("\"type\":\"shot\"")), Is.EqualTo(3));
            Assert.That(written.Count(line => line.Contains("\"hit\":{\"target\":\"plate\"")), Is.EqualTo(2));
        }

        [Test]
        public void RangeRecorder_OnceWarm_AllocatesNothingOnTheDetectorsThreadNorInUpdate()
        {
            var rig = new RangeRig(new StubSource(300, 0, (70, 320, 240), (150, 200, 240)));
            RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.5f).gameObject.SetActive(true);
            RangeRecorder recorder = Add(rig);
            rig.Play(9);
            Assert.That(recorder.IsRecording, Is.True);
            var update = (Action)Delegate.CreateDelegate(typeof(Action), rig.Range, "Update");
            var lateUpdate = (Action)Delegate.CreateDelegate(typeof(Action), recorder, "LateUpdate");
            long allocated = Allocation.Of(() =>
            {
                PlayerLoop.AdvanceTime(1 / 60.0);
                update();
                lateUpdate();
            });
            Assert.That(allocated, Is.Zero, "Update");
            rig.Play(1.5);
            Assert.That(rig.Shots, Has.Count.EqualTo(2));
            Assert.That(rig.Source.LeastAllocatedIn20Frames(140, 290), Is.Zero, "the detector's thread");
        }

        [Test]
        public void RangeRecorder_StoppedByTheFirstShotsListener_HasThatShotsHit()
        {
            var rig = new RangeRig(new StubSource(500, 0, (10, 320, 240), (60, 320, 240)));
            RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.5f).gameObject.SetActive(true);
            RangeRecorder recorder = Add(rig);
            rig.Range.ShotFired += _ => recorder.StopRecording();
            rig.Play(3);
            Assert.That(rig.Shots, Has.Count.EqualTo(2), "the range goes on");
            string[] lines = EventLines(recorder.SessionFolder);
            Assert.That(lines.Count(line => line.Contains("\"target\":\"plate\"")), Is.EqualTo(1));
            Assert.That(lines.Last(), Does.StartWith("{\"type\":\"end\",\"frames\":" + Read(recorder.SessionFolder).Count + ","));
        }

        [Test]
        public void RangeRecorder_TargetThatAScriptMoves_IsHitInTheReplayWhereItWas()
        {
            // It stands behind the middle only around the first flash.
            var rig = new RangeRig(new StubSource(60, 0, (10, 320, 240), (40, 320, 240)));
            LaserTarget plate = RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.5f);
            plate.gameObject.AddComponent<TargetMotion>();
            plate.gameObject.AddComponent<Mover>();
            plate.gameObject.SetActive(true);
            RangeRecorder recorder = Add(rig);
            rig.Play(2.2);
            Assert.That(rig.Shots.Select(s => s.HasHit), Is.EqualTo(new[] { true, false }));
            Assert.That(Replay(recorder.SessionFolder).Select(s => s.HasHit), Is.EqualTo(new[] { true, false }));
            Assert.That(File.ReadLines(Path.Combine(recorder.SessionFolder, SessionLog.SceneFileName)).Count(), Is.GreaterThan(20));
        }

        [Test]
        public void RangeRecorder_ScreenAndEyeThatMove_AreWhereTheyWereInTheReplay()
        {
            // They stand before the plate only around the first flash.
            var rig = new RangeRig(new StubSource(60, 0, (10, 320, 240), (40, 320, 240)));
            RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.5f).gameObject.SetActive(true);
            rig.Screen.gameObject.AddComponent<Slider>();
            rig.Range.Viewpoint!.gameObject.AddComponent<Slider>();
            RangeRecorder recorder = Add(rig);
            rig.Play(2.2);
            Assert.That(rig.Shots.Select(s => s.HasHit), Is.EqualTo(new[] { true, false }));
            Assert.That(Replay(recorder.SessionFolder).Select(s => s.HasHit), Is.EqualTo(new[] { true, false }));
        }

        [Test]
        public void RangeRecorder_StartedAndStopped_WritesOneSessionFromItsFirstFrame()
        {
            var rig = new RangeRig(new StubSource(500, 0));
            rig.SourceAsset.Create = () => new StubSource(500, 0);
            RangeRecorder recorder = Add(rig);
            SerializedFields.Set(recorder, "_recordsAlways", false);
            rig.Play(0.3);
            Assert.That((recorder.IsRecording, Directory.GetDirectories(_folder).Length), Is.EqualTo((false, 0)));
            recorder.StartRecording();
            for (int i = 0; i < 30; i++)
                rig.Step(1 / 60.0);
            Assert.That(recorder.IsRecording, Is.True);
            recorder.StopRecording();
            Assert.That((recorder.IsRecording, rig.Range.IsRunning), Is.EqualTo((false, true)));
            List<Frame> frames = Read(recorder.SessionFolder);
            Assert.That(frames.Select(f => f.Index), Is.EqualTo(Enumerable.Range(0, frames.Count)));
            Assert.That(frames, Has.Count.InRange(10, 18));
            rig.Step(0.1);
            Assert.That(Directory.GetDirectories(_folder), Has.Length.EqualTo(1));
        }

        [Test]
        public void RangeRecorder_SwitchedOff_CompletesTheSession([Values] bool byRange)
        {
            var rig = new RangeRig(new StubSource(500, 0));
            RangeRecorder recorder = Add(rig);
            rig.Play(0.4);
            if (byRange)
                rig.Range.gameObject.SetActive(false);
            else
                recorder.enabled = false;
            Assert.That(recorder.IsRecording, Is.False);
            Assert.That(Read(recorder.SessionFolder), Is.Not.Empty);
            Assert.That(SessionLogFile.Read(recorder.SessionFolder).IsComplete, Is.True);
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void RangeRecorder_ScreenOnly_KeepsThatPartAndSaysThatItIsReduced()
        {
            var rig = new RangeRig(new StubSource(10, 0));
            string half = RangeRig.Calibration.Replace("[[0.005828125,0,0],[0,0.004708333333,0],[0,0,1]]", "[[0.01165625,0,-1],[0,0.009416666667,-0.8],[0,0,1]]");
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset(half));
            RangeRecorder recorder = Add(rig);
            SerializedFields.Set(recorder, "_screenOnly", true);
            rig.Play(0.5);
            using KinectRecording recording = KinectRecording.Open(Path.Combine(recorder.SessionFolder, SessionLog.ScreenFramesName));
            Assert.That(recording.Configuration.ColorRegion, Is.Not.Null);
            Assert.That(recording.Configuration.ColorRegion!.Value.Width, Is.InRange(380, 400));
            Assert.That(SessionLogFile.Read(recorder.SessionFolder).IsReduced, Is.True);
        }

        [Test]
        public void RangeRecorder_PathThatCannotBeWritten_SaysSoAndTheRangeGoesOn()
        {
            File.WriteAllText(Path.Combine(_folder, "file"), "");
            var rig = new RangeRig(new StubSource(40, 0, (10, 320, 240)));
            RangeRecorder recorder = Add(rig);
            SerializedFields.Set(recorder, "_folder", Path.Combine(_folder, "file"));
            var health = new List<HealthEvent>();
            rig.Range.HealthChanged += health.Add;
            rig.Play(1);
            Assert.That(recorder.IsRecording, Is.False);
            Assert.That(rig.Shots, Has.Count.EqualTo(1));
            Assert.That(ConsoleLog.Entries.Count(e => e.Message.Contains("nothing is recorded")), Is.EqualTo(1));
            Assert.That(health.Count(h => h.Text.Contains("nothing is recorded") && !h.Text.Contains('\n')), Is.EqualTo(1));
            ConsoleLog.Clear();
        }

        [Test]
        public void RangeRecorder_EveryRun_GetsAFolderOfItsOwn()
        {
            for (int i = 1; i <= 3; i++)
            {
                var rig = new RangeRig(new StubSource(5, 0));
                RangeRecorder recorder = Add(rig);
                rig.Play(0.4);
                Assert.That(Path.GetFileName(recorder.SessionFolder), Is.EqualTo("session-000" + i));
                rig.Range.gameObject.SetActive(false);
            }
        }

        /// <summary>Puts its object far away after half a second.</summary>
        private sealed class Slider : MonoBehaviour
        {
            private void Update() => transform.position = new Vector3(Time.timeAsDouble < 0.6 ? 0 : 3, 0, transform.position.z);
        }

        private sealed class Mover : MonoBehaviour
        {
            private void Update()
            {
                float x = Time.timeAsDouble < 0.6 ? 0 : 3 + (float)Time.timeAsDouble;
                transform.position = new Vector3(x, 0, 4);
            }
        }
    }
}
