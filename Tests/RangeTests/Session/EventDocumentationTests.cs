using System;
using System.IO;
using LaserTracking.Detection;
using LaserTracking.Hands;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class EventDocumentationTests
    {
        [Test]
        public void Documentation_EveryWordOfTheFormat_IsListed()
        {
            string text = File.ReadAllText(Path.Combine(TestFiles.Repository, "Packages", "com.range.lasertracking", "Documentation~", "events.md"));
            foreach (RejectionReason reason in Enum.GetValues<RejectionReason>())
                Assert.That(text, Does.Contain("| `" + EventWords.Of(reason) + "` |"));
            foreach (HealthKind kind in Enum.GetValues<HealthKind>())
                Assert.That(text, Does.Contain("| `" + EventWords.Of(kind) + "` |"));
            foreach (DepthSource source in Enum.GetValues<DepthSource>())
                Assert.That(text, Does.Contain("| `" + EventWords.Of(source) + "` |"));
            foreach (LaserColor color in Enum.GetValues<LaserColor>())
                Assert.That(text, Does.Contain("`" + EventWords.Of(color) + "`"));
        }
    }
}
