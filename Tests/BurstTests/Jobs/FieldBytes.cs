using System;
using System.Collections.Generic;
using System.Reflection;

namespace LaserTracking.Burst
{
    /// <summary>Structs field by field, to the last bit: what lies between fields is nobody's, and copies may or may not bring it along.</summary>
    internal static class FieldBytes
    {
        public static void AddAll<T>(List<byte> target, ReadOnlySpan<T> values) where T : struct
        {
            foreach (T value in values)
                Add(target, value);
        }

        private static void Add(List<byte> target, object value)
        {
            switch (value)
            {
                case double number:
                    target.AddRange(BitConverter.GetBytes(number));
                    return;
                case float number:
                    target.AddRange(BitConverter.GetBytes(number));
                    return;
                case IConvertible number:
                    target.AddRange(BitConverter.GetBytes(number.ToInt64(null)));
                    return;
            }

            foreach (FieldInfo field in value.GetType().GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
                Add(target, field.GetValue(value)!);
        }
    }
}
