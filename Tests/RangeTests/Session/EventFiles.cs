using System;
using System.IO;

namespace LaserTracking.Session
{
    /// <summary>A folder for the files of one test, deleted with it.</summary>
    internal sealed class EventFiles : IDisposable
    {
        private readonly string _folder = Path.Combine(Path.GetTempPath(), "range-test-" + Guid.NewGuid().ToString("N"));

        public EventFiles()
        {
            Directory.CreateDirectory(_folder);
        }

        public string Write(string name, string text)
        {
            string path = Path.Combine(_folder, name);
            File.WriteAllText(path, text);
            return path;
        }

        public void Dispose() => Directory.Delete(_folder, true);
    }
}
