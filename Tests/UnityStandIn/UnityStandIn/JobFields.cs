// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using System.Linq;
using System.Reflection;
using Unity.Collections.LowLevel.Unsafe;

namespace UnityStandIn
{
    /// <summary>What Unity's job system looks at once per type of job.</summary>
    internal static class JobFields<T> where T : struct
    {
        public static readonly string Name = typeof(T).Name;

        /// <summary>Why the type cannot be a job; null: it can.</summary>
        public static readonly string Problem =
            typeof(T).GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).Select(ProblemOf).FirstOrDefault(problem => problem != null);

        private static string ProblemOf(FieldInfo field)
        {
            Type type = field.FieldType;
            if (type.IsPointer && !field.IsDefined(typeof(NativeDisableUnsafePtrRestrictionAttribute)))
                return Name + "." + field.Name + " is a pointer, which the job system refuses without NativeDisableUnsafePtrRestriction";
            return type.IsPointer || type.IsValueType ? null : Name + "." + field.Name + " is a reference, which no job can have";
        }
    }
}
