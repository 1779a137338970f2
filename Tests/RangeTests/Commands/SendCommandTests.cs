using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Threading;
using LaserTracking.Host;
using LaserTracking.Host.Remote;
using LaserTracking.Remote;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class SendCommandTests
    {
        private const string KeyText = "00112233445566778899aabbccddeeff";
        private const string Header = "{\"type\":\"header\",\"v\":1,\"tool\":\"range\",\"version\":\"0.1.0\",\"inputs\":[],\"calibration\":null,\"detector\":\"shots\",\"seed\":null}";

        [Test]
        public void Send_Events_ArriveSigned()
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("key"), KeyText + "\n");
            File.WriteAllLines(folder.File("events.jsonl"),
            [
                Header,
                Shot(1, 1000), Shot(2, 60000),
                "{\"type\":\"hand\",\"frame\":1,\"time_us\":70000,\"hand\":\"left\",\"palm_m\":[1,1,-2],\"muzzle_m\":[1,1,-2],\"depth_source\":\"measured\",\"track\":4}",
                "{\"type\":\"end\",\"frames\":2,\"dropped\":0,\"seconds_media\":1,\"seconds_wall\":1}",
            ]);
            using RemoteReceiver receiver = Listen(RemoteKey.Parse(KeyText, "key"));
            (int exitCode, string output, string error) = CommandLine.Run("send", folder.File("events.jsonl"), "--to", receiver.EndPoint.ToString(), "--key-file", folder.File("key"));
            Assert.That((exitCode, error), Is.EqualTo((ExitCodes.Done, "")));
            Assert.That(output, Does.StartWith("2 shots, 1 hands sent"));
            Assert.That(Shots(receiver, 2).Select(shot => (shot.Event.Shot.Id, shot.Event.ScreenM.X)), Is.EqualTo(new[] { (1, 1.2), (2, 1.2) }));
            Assert.That(receiver.Inbox.TryGetPose(out RemotePose pose) ? pose.TrackId : 0, Is.EqualTo(4));
            Assert.That(receiver.Inbox.TryTakeHealth(out _), Is.False);
        }

        [Test]
        public void Send_TestMessages_Arrive()
        {
            using RemoteReceiver receiver = Listen(null);
            string to = receiver.EndPoint.ToString();
            Assert.That(CommandLine.Run("send", "--shot", "1.5,0.8", "--hand", "1,1,-2", "--published", "--to", to).ExitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(Shots(receiver, 1).Single().Event.ScreenM, Is.EqualTo(new Geometry.Vector2D(1.5, 0.8)));
            var poses = new RemotePose[RemoteInbox.PoseCapacity];
            int count = receiver.Inbox.CopyPoses(poses);
            Assert.That(poses.Take(count).Select(pose => pose.Space), Is.EquivalentTo(new[] { RemoteSpace.ScreenM, RemoteSpace.CameraMm }));
        }

        [Test]
        public void Send_ThroughAFile_IsReceivedAsEvents()
        {
            using var folder = new TemporaryFolder();
            File.WriteAllLines(folder.File("events.jsonl"), [Header, Shot(1, 1000), Shot(2, 60000), Shot(7, 90000)]);
            using var receiver = new RangeProcess(folder.Path, null, "receive", "--from-file", "detector.json", "--shots", "3", "--seconds", "20");
            string lines = receiver.Output.ReadLine() + "\n";
            (int exitCode, string output, string error) = CommandLine.Run("send", folder.File("events.jsonl"), "--to-file", folder.File("detector.json"));
            lines += receiver.Output.ReadToEnd();
            (int receivedCode, string told) = receiver.WaitForExit();
            Assert.That(receivedCode, Is.EqualTo(ExitCodes.Done), told);
            Assert.That(told, Does.EndWith("detector.json: 3 shots, 0 hands, 0 published rays\n"));
            File.WriteAllText(folder.File("received.jsonl"), lines);
            Assert.That((exitCode, error), Is.EqualTo((ExitCodes.Done, "")));
            Assert.That(output, Does.StartWith("3 shots, 0 hands sent"));
            var received = new LaserTracking.Session.SessionRecorder();
            LaserTracking.Host.Events.EventReader.Read(folder.File("received.jsonl"), received);
            Assert.That(received.ShotsByTime().Select(shot => (shot.Shot.Id, shot.ScreenM.X, shot.HasHit)), Is.EqualTo(new[] { (1, 1.2, false), (2, 1.2, false), (7, 1.2, false) }));
        }

        [Test]
        public void Receive_NothingComes_IsOverAfterItsTimeWithAFailedCheck()
        {
            using var folder = new TemporaryFolder();
            (int exitCode, string output, string error) = CommandLine.Run("receive", "--listen", "127.0.0.1:0", "--shots", "1", "--seconds", "0.05", "--events", folder.File("received.jsonl"));
            Assert.That((exitCode, output), Is.EqualTo((ExitCodes.CheckFailed, "")));
            Assert.That(error, Does.Contain("0 shots, 0 hands"));
            Assert.That(File.ReadLines(folder.File("received.jsonl")).Count(), Is.EqualTo(2), "header and end");
        }

        [Test]
        public void Receive_BadLine_IsRefused()
        {
            using var folder = new TemporaryFolder();
            CommandLine.AssertRefused("anybody on the network", "receive", "--listen", "0.0.0.0:0");
            CommandLine.AssertRefused("is no HOST:PORT", "receive", "--listen", "here:x");
            CommandLine.AssertRefused("is no address", "receive", "--allow", "somebody");
            CommandLine.AssertRefused("belong to the network", "receive", "--from-file", folder.File("a"), "--listen", "127.0.0.1:9");
            CommandLine.AssertRefused("also read", "receive", "--from-file", folder.File("a"), "--events", folder.File("a"));
            CommandLine.AssertRefused("no name for a file", "receive", "--from-file", "");
            CommandLine.AssertRefused("no name for a file", "receive", "--from-file", folder.Path);
            CommandLine.AssertRefused("--seconds", "receive", "--seconds", "-1");
            CommandLine.AssertRefused("--to names another way", "send", "--shot", "1,1", "--to-file", folder.File("a"), "--to", "127.0.0.1:9");
            CommandLine.AssertRefused("is not signed", "send", "--shot", "1,1", "--to-file", folder.File("a"), "--key-file", folder.File("k"));
            CommandLine.AssertRefused("cannot be written", "send", "--shot", "1,1", "--to-file", Path.Combine(folder.File("none"), "a"));
        }

        [Test]
        public void Send_BadLine_IsRefused()
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("key"), "secret words");
            CommandLine.AssertRefused("needs either", "send");
            CommandLine.AssertRefused("needs either", "send", folder.File("a.jsonl"), "--shot", "1,1");
            CommandLine.AssertRefused("--shot: \"1\" is not 2 numbers", "send", "--shot", "1");
            CommandLine.AssertRefused("--hand: \"1,2,NaN\"", "send", "--hand", "1,2,NaN");
            CommandLine.AssertRefused("\"here:x\" is no HOST:PORT", "send", "--shot", "1,1", "--to", "here:x");
            CommandLine.AssertRefused("add --key-file", "send", "--shot", "1,1", "--to", "192.0.2.1:9997");
            Assert.That(CommandLine.AssertRefused("no key", "send", "--shot", "1,1", "--key-file", folder.File("key")), Does.Not.Contain("secret words"));
            CommandLine.AssertRefused("cannot be read", "send", "--shot", "1,1", "--key-file", folder.File("none"));
            CommandLine.AssertRefused("--speed", "send", "--shot", "1,1", "--speed", "NaN");
            CommandLine.AssertRefused("is not there", "send", folder.File("none.jsonl"));
            CommandLine.AssertRefused("--send", "replay", folder.File("a.mkv"), "--send", ":0");
        }

        private static RemoteReceiver Listen(RemoteKey? key) => new(new RemoteSettings { Port = 0, Address = IPAddress.Loopback, Key = key }, new WallClock());

        private static List<RemoteShot> Shots(RemoteReceiver receiver, int count)
        {
            var shots = new List<RemoteShot>();
            for (int waited = 0; waited < 5000 && shots.Count < count; waited++)
            {
                while (receiver.Inbox.TryTakeShot(out RemoteShot shot))
                    shots.Add(shot);
                Thread.Sleep(1);
            }

            return shots;
        }

        private static string Shot(int id, long timeUs) =>
            "{\"type\":\"shot\",\"id\":" + id + ",\"frame\":1,\"first_frame\":1,\"last_frame\":1,\"time_us\":" + timeUs + ",\"time_sigma_us\":10,\"x_px\":1,\"y_px\":2," +
            "\"sigma_px\":0.1,\"cov_px\":[0.01,0,0.01],\"peak\":200,\"area_px\":9,\"color\":\"green\",\"confidence\":0.9,\"factors\":null,\"streak_px\":[0,0]," +
            "\"screen_m\":[1.2,0.8],\"screen_cov_mm2\":[1,0,1],\"shooter\":null,\"shooter_p\":null,\"hand\":null,\"muzzle_m\":null,\"direction\":null,\"pair_dt_us\":null," +
            "\"hit\":{\"target\":\"A\",\"zone\":\"B\",\"points\":5,\"point_m\":[0,0,0],\"distance_m\":1,\"p_zone\":1}}";
    }
}
