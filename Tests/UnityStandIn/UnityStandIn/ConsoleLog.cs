// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Collections.Generic;
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>What was written to Unity's Console since the last <see cref="PlayerLoop.Reset"/>.</summary>
    public static class ConsoleLog
    {
        private static readonly List<LogEntry> Written = new List<LogEntry>();

        public static IReadOnlyList<LogEntry> Entries => Written;

        public static void Clear() => Written.Clear();

        internal static void Add(LogType type, object message, Object context) =>
            Written.Add(new LogEntry(type, message == null ? "Null" : message.ToString(), context));
    }
}
