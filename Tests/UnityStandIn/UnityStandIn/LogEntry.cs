// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>One line of Unity's Console.</summary>
    public sealed class LogEntry
    {
        internal LogEntry(LogType type, string message, Object context)
        {
            Type = type;
            Message = message;
            Context = context;
        }

        public LogType Type { get; }

        public string Message { get; }

        public Object Context { get; }

        public override string ToString() => Type + ": " + Message;
    }
}
