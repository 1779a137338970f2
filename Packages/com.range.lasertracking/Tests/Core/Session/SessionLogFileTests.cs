using System;
using System.IO;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class SessionLogFileTests
    {
        private string _folder = "";

        [SetUp]
        public void MakeFolder() => _folder = Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), "range-session-" + Guid.NewGuid().ToString("N"))).FullName;

        [TearDown]
        public void RemoveFolder() => Directory.Delete(_folder, true);

        private static SessionLog Log() => new SessionLog
        {
            Header = new SessionHeader("1.2.3", new[] { new SessionInput("a \"b\".mkv", "00ff"), new SessionInput("ö", null) }, "c.json", "paper", 77),
            Build = "abc",
            HasHandFrames = true,
            HasCalibration = true,
            HasScene = true,
            HandModel = "lite",
            HandClockOffsetUs = -1234567890123,
            SceneTimeZeroUs = 1730796756988167,
            ExposureUs = 16670.123456789,
            RowUs = -15.1,
            Frames = 36000,
            Lost = 2,
            InputProblems = 3,
            IsComplete = true,
        };

        [Test]
        public void Read_WhatWasWritten_IsTheSame()
        {
            SessionLogFile.Write(Log(), _folder);
            SessionLog read = SessionLogFile.Read(_folder), log = Log();
            Assert.That(SessionLog.IsIn(_folder), Is.True);
            Assert.That((read.Header.Version, read.Header.Calibration, read.Header.Detector, read.Header.Seed), Is.EqualTo(("1.2.3", "c.json", "paper", 77L)));
            Assert.That((read.Header.Inputs[0].Path, read.Header.Inputs[0].Sha256, read.Header.Inputs[1].Sha256), Is.EqualTo(("a \"b\".mkv", "00ff", (string?)null)));
            Assert.That((read.Build, read.HasHandFrames, read.HasCalibration, read.HasScene, read.HandModel, read.HandClockOffsetUs), Is.EqualTo((log.Build, true, true, true, "lite", log.HandClockOffsetUs)));
            Assert.That((read.SceneTimeZeroUs, read.ExposureUs, read.RowUs), Is.EqualTo((log.SceneTimeZeroUs, log.ExposureUs, log.RowUs)));
            Assert.That((read.Frames, read.Lost, read.InputProblems, read.IsComplete), Is.EqualTo((36000L, 2L, 3, true)));
        }

        [Test]
        public void Doubts_NameWhateverMakesAReplayUncertain()
        {
            Assert.That(Log().Doubts("abc"), Has.Count.EqualTo(2).And.Some.Contains("2 frames").And.Some.Contains("3 places"));
            Assert.That(new SessionLog { Build = "abc", IsComplete = true }.Doubts("abc"), Is.Empty);
            Assert.That(new SessionLog { Build = "abc" }.Doubts("def"), Has.Count.EqualTo(2).And.Some.Contains("another build").And.Some.Contains("beginning"));
        }

        [Test]
        public void Read_DamagedFile_GivesOneMessageAtMost()
        {
            SessionLogFile.Write(Log(), _folder);
            string path = Path.Combine(_folder, SessionLog.FileName), text = File.ReadAllText(path);
            var random = new Random(1);
            for (int i = 0; i < 400; i++)
            {
                char[] damaged = (i % 3 == 0 ? text.Substring(0, random.Next(text.Length)) : text).ToCharArray();
                for (int change = 0; change <= i % 4 && damaged.Length > 0; change++)
                    damaged[random.Next(damaged.Length)] = "0123456789\"{}[],:-eE.tn\n x"[random.Next(26)];
                File.WriteAllText(path, new string(damaged));
                try
                {
                    SessionLogFile.Read(_folder);
                }
                catch (InputException problem)
                {
                    Assert.That(problem.Message, Does.Not.Contain("\n"));
                }
            }
        }

        [Test]
        public void Read_OfANewerVersion_IsRefused()
        {
            SessionLogFile.Write(Log(), _folder);
            string path = Path.Combine(_folder, SessionLog.FileName);
            File.WriteAllText(path, File.ReadAllText(path).Replace("\"v\": 1", "\"v\": 2"));
            Assert.That(Assert.Throws<InputException>(() => SessionLogFile.Read(_folder))!.Message, Does.Contain("newer"));
        }
    }
}
