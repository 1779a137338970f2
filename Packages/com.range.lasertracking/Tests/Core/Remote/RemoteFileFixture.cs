using System;
using System.IO;
using System.Threading;
using NUnit.Framework;

namespace LaserTracking.Remote
{
    /// <summary>A folder of its own for a file that one side writes and the other watches.</summary>
    public abstract class RemoteFileFixture
    {
        private const int PatienceMs = 5000;

        protected string Folder { get; private set; } = "";

        protected string FilePath { get; private set; } = "";

        [SetUp]
        public void SetUp()
        {
            Folder = Path.Combine(Path.GetTempPath(), "remote-file-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Folder);
            FilePath = Path.Combine(Folder, "detector.json");
        }

        [TearDown]
        public void TearDown() => Directory.Delete(Folder, true);

        protected RemoteFileReceiver Watch() => new RemoteFileReceiver(FilePath, new RemoteSettings(), new WallClock());

        protected static bool Wait(Func<bool> condition)
        {
            for (int waited = 0; waited < PatienceMs; waited++)
            {
                if (condition())
                    return true;
                Thread.Sleep(1);
            }

            return false;
        }
    }
}
