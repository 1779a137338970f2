// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using System.Collections.Concurrent;
using System.Reflection;

namespace UnityStandIn
{
    /// <summary>Finds Unity's messages: instance methods without parameters, by name, private ones of base classes too.</summary>
    internal static class MessageMethods
    {
        private static readonly ConcurrentDictionary<(Type, string), MethodInfo> Found = new ConcurrentDictionary<(Type, string), MethodInfo>();

        public static MethodInfo Find(Type type, string message) => Found.GetOrAdd((type, message), key => Search(key.Item1, key.Item2));

        private static MethodInfo Search(Type type, string message)
        {
            const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
            for (Type at = type; at != null; at = at.BaseType)
            {
                MethodInfo method = at.GetMethod(message, Own, null, Type.EmptyTypes, null);
                if (method != null)
                    return method;
            }

            return null;
        }
    }
}
