using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Host;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>A recorded session, run again from its folder. The ten minutes of the issue: './range study session'.</summary>
    public sealed class SessionReplayTests
    {
        private const string Scenario = "{\"name\":\"s\",\"seed\":3,\"duration_s\":3,\"color_camera\":{\"width\":320,\"height\":180,\"format\":\"nv12\",\"dropped_share\":0.05,\"exposure_us\":8000},"
            + "\"depth_camera\":{\"binned\":true,\"frames_per_second\":15,\"clock_offset_us\":5000000},\"shooters\":[{\"name\":\"A\"},{\"name\":\"B\",\"offset_x_m\":0.8}],"
            + "\"shots\":[{\"time_s\":0.8,\"shooter\":1,\"pulse_ms\":60,\"target\":\"Rings 1\"},{\"time_s\":1.5,\"shooter\":2,\"pulse_ms\":60,\"target\":\"Popper 2\"},{\"time_s\":2.2,\"shooter\":1,\"pulse_ms\":60,\"target\":\"Silhouette 1\"}]}";

        private static string Content(string path) => File.ReadAllText(path);

        private static string Record(TemporaryFolder folder)
        {
            File.WriteAllText(folder.File("s.json"), Scenario);
            string session = folder.File("session");
            (int exitCode, _, string error) = CommandLine.Run("replay", folder.File("s.json"), "--session", session);
            Assert.That((exitCode, error), Is.EqualTo((ExitCodes.Done, "")));
            return session;
        }

        [Test]
        public void Replay_RecordedSession_GivesTheSameBytesAgainAndAgain()
        {
            using var folder = new TemporaryFolder();
            string session = Record(folder), recorded = Content(Path.Combine(session, SessionLog.EventsFileName));
            Assert.That(Regex.Matches(recorded, "\"type\":\"shot\"").Count, Is.EqualTo(3));
            Assert.That(Regex.Matches(recorded, "\"target\":\"").Count, Is.GreaterThanOrEqualTo(2), "hits on targets");
            Assert.That(Regex.Matches(recorded, "\"type\":\"hand\"").Count, Is.GreaterThan(20));
            for (int i = 0; i < 2; i++)
            {
                (int exitCode, _, string error) = CommandLine.Run("replay", session, "--events", folder.File("again.jsonl"));
                Assert.That((exitCode, error), Is.EqualTo((ExitCodes.Done, "")));
                Assert.That(Content(folder.File("again.jsonl")), Is.EqualTo(recorded));
            }
        }

        [Test]
        public void Replay_SessionOfARecordedSession_GivesTheSameBytes()
        {
            using var folder = new TemporaryFolder();
            string first = Record(folder);
            (int exitCode, _, string error) = CommandLine.Run("replay", Path.Combine(first, SessionLog.ScreenFramesName), "--calibration", Path.Combine(first, SessionLog.CalibrationFileName),
                "--hand", Path.Combine(first, SessionLog.HandFramesName), "--hand-offset-us", "-5000000", "--session", folder.File("second"));
            Assert.That((exitCode, error), Is.EqualTo((ExitCodes.Done, "")));
            CommandLine.Run("replay", folder.File("second"), "--events", folder.File("again.jsonl"));
            Assert.That(Content(folder.File("again.jsonl")), Is.EqualTo(Content(Path.Combine(folder.File("second"), SessionLog.EventsFileName))));
            Assert.That(File.ReadAllBytes(Path.Combine(first, SessionLog.ScreenFramesName)), Is.EqualTo(File.ReadAllBytes(Path.Combine(folder.File("second"), SessionLog.ScreenFramesName))),
                "equal frames give equal recordings");
        }

        [Test]
        public void Replay_SessionThatMayDiffer_SaysWhy()
        {
            using var folder = new TemporaryFolder();
            string session = Record(folder), log = Path.Combine(session, SessionLog.FileName);
            File.WriteAllText(log, Regex.Replace(File.ReadAllText(log), "\"build\": \"[0-9a-f]+\"", "\"build\": \"other\"").Replace("\"complete\": true", "\"complete\": false"));
            (int exitCode, _, string error) = CommandLine.Run("replay", session, "--events", folder.File("again.jsonl"));
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(error, Does.Contain("another build (other,").And.Contain("from its beginning to its end"));
        }

        [Test]
        public void Replay_SessionThatIsNotWhole_IsRefusedInOneLine()
        {
            using var folder = new TemporaryFolder();
            string session = Record(folder), events = folder.File("e.jsonl");
            CommandLine.AssertRefused("already", "replay", folder.File("s.json"), "--session", session);
            CommandLine.AssertRefused("--calibration", "replay", session, "--calibration", "c.json");
            CommandLine.AssertRefused("--session", "replay", session, "--session", folder.File("third"));
            CommandLine.AssertRefused("--hand", "replay", folder.File("s.json"), "--hand", "c.mkv");
            CommandLine.AssertRefused("also read", "replay", session, "--events", Path.Combine(session, SessionLog.EventsFileName));
            foreach (string name in new[] { SessionLog.SceneFileName, SessionLog.CalibrationFileName, SessionLog.HandFramesName, SessionLog.ScreenFramesName })
            {
                string path = Path.Combine(session, name);
                byte[] content = File.ReadAllBytes(path);
                File.WriteAllText(path, "nonsense");
                CommandLine.AssertRefused(name, "replay", session, "--events", events);
                File.Delete(path);
                CommandLine.AssertRefused(name, "replay", session, "--events", events);
                File.WriteAllBytes(path, content);
            }

            File.WriteAllText(Path.Combine(session, SessionLog.FileName), "{");
            CommandLine.AssertRefused(SessionLog.FileName, "replay", session, "--events", events);
            Assert.That(File.Exists(events), Is.False);
        }

        [Test]
        public void Record_ScreenOnly_FindsTheSameShots()
        {
            using var folder = new TemporaryFolder();
            string session = Record(folder), whole = Path.Combine(session, SessionLog.ScreenFramesName), calibration = Path.Combine(session, SessionLog.CalibrationFileName), part = folder.File("part.mkv");
            (int exitCode, _, string error) = CommandLine.Run("record", whole, "--out", part, "--calibration", calibration);
            Assert.That((exitCode, error), Is.EqualTo((ExitCodes.Done, "")));
            using (KinectRecording recording = KinectRecording.Open(part))
                Assert.That(recording.Configuration.ColorRegion, Is.Not.Null);
            CommandLine.Run("replay", whole, "--calibration", calibration, "--events", folder.File("whole.jsonl"));
            CommandLine.Run("replay", part, "--calibration", calibration, "--events", folder.File("part.jsonl"));
            string[] Shots(string name) => File.ReadAllLines(folder.File(name)).Where(line => line.StartsWith("{\"type\":\"shot\"")).ToArray();
            Assert.That(Shots("whole.jsonl"), Has.Length.EqualTo(3));
            Assert.That(Shots("part.jsonl"), Is.EqualTo(Shots("whole.jsonl")));
        }
    }
}
