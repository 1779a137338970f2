using System.IO;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class TrainCommandTests
    {
        [Test]
        public void Train_OneSimulatedRange_PrintsTheTableAndWritesTheCurves()
        {
            using var folder = new TemporaryFolder();
            string curves = folder.File("Curves.cs");
            (int exitCode, string output, string error) = CommandLine.Run("train", "--only", "simulated", "--seeds", "2", "--write", curves);
            Assert.That(exitCode, Is.Zero, error);
            Assert.That(output, Does.Contain("simulated").And.Contain("expected calibration error"));
            Assert.That(File.ReadAllText(curves), Does.Contain("internal static class DotEvidenceCurves").And.Contain("RejectionReason.TooElongated"));
        }

        [Test]
        public void Train_WhatCannotBe_IsRefused()
        {
            using var folder = new TemporaryFolder();
            CommandLine.AssertRefused("no range of seeds", "train", "--seeds", "5..1");
            CommandLine.AssertRefused("its folder does not exist", "train", "--write", folder.File("none/Curves.cs"));
            CommandLine.AssertRefused("no dots", "train", "--only", "no such case");
        }
    }
}
