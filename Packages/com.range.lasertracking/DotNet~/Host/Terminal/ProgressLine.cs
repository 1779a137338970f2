using System;
using System.Diagnostics;

namespace LaserTracking.Host.Terminal
{
    /// <summary>One line on standard error that is written over while long work runs; silent when standard error is no terminal.</summary>
    internal sealed class ProgressLine : IDisposable
    {
        private const int MinimumMillisecondsBetween = 100;

        private readonly bool _isTerminal = !Console.IsErrorRedirected;
        private readonly Stopwatch _sinceLast = new();
        private bool _isShown;

        /// <summary>Shows a text; texts that follow too fast are left out.</summary>
        public void Show(string text)
        {
            if (!_isTerminal || (_isShown && _sinceLast.ElapsedMilliseconds < MinimumMillisecondsBetween))
                return;
            Console.Error.Write("\r\u001b[K" + text);
            _isShown = true;
            _sinceLast.Restart();
        }

        public void Clear()
        {
            if (!_isShown)
                return;
            Console.Error.Write("\r\u001b[K");
            _isShown = false;
        }

        public void Dispose() => Clear();
    }
}
