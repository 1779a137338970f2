// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using UnityStandIn;

namespace UnityEngine
{
    public class Debug
    {
        public static void Log(object message) => ConsoleLog.Add(LogType.Log, message, null);

        public static void Log(object message, Object context) => ConsoleLog.Add(LogType.Log, message, context);

        public static void LogWarning(object message) => ConsoleLog.Add(LogType.Warning, message, null);

        public static void LogWarning(object message, Object context) => ConsoleLog.Add(LogType.Warning, message, context);

        public static void LogError(object message) => ConsoleLog.Add(LogType.Error, message, null);

        public static void LogError(object message, Object context) => ConsoleLog.Add(LogType.Error, message, context);

        public static void LogException(Exception exception) => ConsoleLog.Add(LogType.Exception, exception, null);

        public static void LogException(Exception exception, Object context) => ConsoleLog.Add(LogType.Exception, exception, context);
    }
}
