using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;

namespace LaserTracking.Capture.Recording
{
    /// <summary>
    /// Has the operating system put what others write to some files on the disk, once a second: a power cut then costs no more than
    /// about that. By a thread and through handles of its own, so that no writer waits for the disk. The files must be open for others
    /// to write.
    /// </summary>
    internal sealed class DiskFlusher : IDisposable
    {
        public const int IntervalMs = 1000;

        private readonly List<FileStream> _files = new List<FileStream>();
        private readonly ManualResetEventSlim _stop = new ManualResetEventSlim();
        private readonly Thread _thread;
        private long _rounds;

        /// <param name="paths">Files that exist. One that cannot be opened again is left to the system.</param>
        public DiskFlusher(params string[] paths)
        {
            foreach (string path in paths)
            {
                try
                {
                    _files.Add(new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.ReadWrite | FileShare.Delete, 1));
                }
                catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException)
                {
                    // Who writes it is the one to complain.
                }
            }

            _thread = new Thread(Run) { IsBackground = true, Name = "flushes a recording" };
            _thread.Start();
        }

        /// <summary>How often all files have been flushed.</summary>
        public long Rounds => Interlocked.Read(ref _rounds);

        /// <summary>Does not flush once more: who writes a file does, when it is whole.</summary>
        public void Dispose()
        {
            _stop.Set();
            _thread.Join();
            _stop.Dispose();
            foreach (FileStream file in _files)
                file.Dispose();
        }

        private void Run()
        {
            while (!_stop.Wait(IntervalMs))
            {
                foreach (FileStream file in _files)
                    Flush(file);
                Interlocked.Increment(ref _rounds);
            }
        }

        private static void Flush(FileStream file)
        {
            try
            {
                file.Flush(true);
            }
            catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException)
            {
                // A disk that is full or gone: who writes finds the same, and says so.
            }
        }
    }
}
