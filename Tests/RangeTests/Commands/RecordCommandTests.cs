using System.IO;
using LaserTracking.Host;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class RecordCommandTests
    {
        private const string Scenario = "{\"name\":\"s\",\"seed\":3,\"duration_s\":0.5,\"color_camera\":{\"width\":160,\"height\":90,\"format\":\"nv12\"},\"depth_camera\":{\"enabled\":true,\"binned\":true},"
            + "\"shooters\":[{\"name\":\"A\"}]}";

        [Test]
        public void Record_Simulation_GivesARecordingThatInfoReads()
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("s.json"), Scenario);
            (int exitCode, string output, string error) = CommandLine.Run("record", folder.File("s.json"), "--out", folder.File("a.mkv"));
            Assert.That((exitCode, error), Is.EqualTo((ExitCodes.Done, "")));
            Assert.That(output, Does.Contain("15 frames"));
            (_, output, _) = CommandLine.Run("info", folder.File("a.mkv"));
            Assert.That(output, Does.Contain("\"captures\": 15").And.Contain("NV12").And.Contain("\"truncated\": false").And.Contain("\"problems\": []"));
            (exitCode, _, error) = CommandLine.Run("record", folder.File("s.json"), "--out", folder.File("b.mkv"), "--camera", "hand");
            Assert.That((exitCode, error), Is.EqualTo((ExitCodes.Done, "")));
            (_, output, _) = CommandLine.Run("info", folder.File("b.mkv"));
            Assert.That(output, Does.Contain("DEPTH16").And.Contain("NFOV_2X2BINNED"));
        }

        [Test]
        public void Record_Region_IsSmallerAndStandsAtItsPlace()
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("s.json"), Scenario);
            CommandLine.Run("record", folder.File("s.json"), "--out", folder.File("all.mkv"));
            (int exitCode, _, string error) = CommandLine.Run("record", folder.File("all.mkv"), "--out", folder.File("part.mkv"), "--region", "20,10,80,60");
            Assert.That((exitCode, error), Is.EqualTo((ExitCodes.Done, "")));
            Assert.That(new FileInfo(folder.File("part.mkv")).Length, Is.LessThan(new FileInfo(folder.File("all.mkv")).Length / 2.5));
            (_, string output, _) = CommandLine.Run("info", folder.File("part.mkv"));
            Assert.That(output.Replace(" ", "").Replace("\n", ""), Does.Contain("\"region\":{\"x\":20,\"y\":10,\"full_width\":160,\"full_height\":90}"));
        }

        [Test]
        public void Record_KilledRecording_BecomesWhole()
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("s.json"), Scenario);
            CommandLine.Run("record", folder.File("s.json"), "--out", folder.File("a.mkv"));
            byte[] whole = File.ReadAllBytes(folder.File("a.mkv"));
            File.WriteAllBytes(folder.File("cut.mkv"), whole[..(whole.Length * 2 / 3)]);
            (int exitCode, string output, _) = CommandLine.Run("record", folder.File("cut.mkv"), "--out", folder.File("saved.mkv"));
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(output, Does.Contain("problems of the input"));
            (_, output, _) = CommandLine.Run("info", folder.File("saved.mkv"));
            Assert.That(output, Does.Contain("\"truncated\": false").And.Contain("\"problems\": []"));
        }

        [Test]
        public void Record_BadInput_IsRefusedInOneLine()
        {
            using var folder = new TemporaryFolder();
            string scenario = folder.File("s.json"), there = folder.File("there.mkv"), free = folder.File("free.mkv");
            File.WriteAllText(scenario, Scenario);
            string small = folder.File("small.mkv");
            CommandLine.Run("record", scenario, "--out", small);
            File.WriteAllText(there, "precious");
            CommandLine.AssertRefused("exists already", "record", scenario, "--out", there);
            CommandLine.AssertRefused("--camera", "record", small, "--out", free, "--camera", "third");
            CommandLine.AssertRefused("--jpeg", "record", small, "--out", free, "--jpeg", "101");
            CommandLine.AssertRefused("--region", "record", small, "--out", free, "--region", "1,2,3");
            CommandLine.AssertRefused("--region", "record", small, "--out", free, "--region", "500,0,10,10");
            CommandLine.AssertRefused("no name", "record", small, "--out", folder.Path);
            CommandLine.AssertRefused("cannot be written", "record", small, "--out", Path.Combine(there, "below.mkv"));
            CommandLine.AssertRefused("does not exist", "record", folder.File("none.mkv"), "--out", free);
            CommandLine.AssertRefused("also read", "record", scenario, "--out", scenario);
            Assert.That(File.Exists(free), Is.False);
            Assert.That(File.ReadAllText(there), Is.EqualTo("precious"));
        }
    }
}
