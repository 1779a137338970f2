// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using System.Reflection;
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>Sets what Unity reads from a scene or asset file: public fields and private ones marked SerializeField.</summary>
    public static class SerializedFields
    {
        /// <exception cref="ArgumentException">Unity would not serialise a field of this name: the value would be lost silently.</exception>
        public static void Set(object target, string name, object value)
        {
            FieldInfo field = Find(target.GetType(), name);
            if (field == null)
                throw new ArgumentException(target.GetType().Name + " has no serialised field " + name);
            if (field.FieldType == typeof(LayerMask) && value is int bits)
                value = (LayerMask)bits;
            field.SetValue(target, value);
        }

        /// <summary>Null when Unity serialises no field of this name.</summary>
        public static FieldInfo Find(Type type, string name)
        {
            const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
            for (Type at = type; at != null; at = at.BaseType)
            {
                FieldInfo field = at.GetField(name, Own);
                if (field != null && !field.IsInitOnly && !field.IsNotSerialized && (field.IsPublic || field.IsDefined(typeof(SerializeField), false)))
                    return field;
            }

            return null;
        }
    }
}
