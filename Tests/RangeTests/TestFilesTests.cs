using System.IO;
using NUnit.Framework;

namespace LaserTracking
{
    public sealed class TestFilesTests
    {
        [Test]
        public void Repository_OfTheseTests_HoldsThePackage()
        {
            Assert.That(File.Exists(Path.Combine(TestFiles.Repository, "Packages", "com.range.lasertracking", "package.json")), Is.True);
        }
    }
}
