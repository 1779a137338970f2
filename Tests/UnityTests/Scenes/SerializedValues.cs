using System;
using System.Globalization;
using System.Linq;
using System.Reflection;
using UnityEngine;
using UnityEngine.Events;
using UnityStandIn;
using YamlDotNet.RepresentationModel;
using Object = UnityEngine.Object;

namespace LaserTracking.Unity
{
    /// <summary>Gives an object its serialised fields. A name that the class does not serialise is an error: Unity would drop the value.</summary>
    internal sealed class SerializedValues
    {
        private readonly Func<long, string?, Type, Object?> _resolve;

        /// <param name="resolve">Finds what a reference (id, GUID or null, type of the field) means.</param>
        public SerializedValues(Func<long, string?, Type, Object?> resolve)
        {
            _resolve = resolve;
        }

        public void Apply(object target, YamlMappingNode fields, Func<string, bool> isUnitysOwn)
        {
            foreach ((YamlNode key, YamlNode value) in fields.Children.Select(pair => (pair.Key, pair.Value)))
            {
                string name = ((YamlScalarNode)key).Value!;
                if (isUnitysOwn(name))
                    continue;
                FieldInfo? field = SerializedFields.Find(target.GetType(), name);
                if (field == null)
                    throw new InvalidOperationException(target.GetType().Name + " serialises no field " + name);
                if (!typeof(UnityEventBase).IsAssignableFrom(field.FieldType))
                    field.SetValue(target, Convert(value, field.FieldType));
            }
        }

        private object? Convert(YamlNode node, Type type)
        {
            if (typeof(Object).IsAssignableFrom(type))
            {
                (long id, string? guid) = UnityYamlObject.Reference(node);
                return id == 0 ? null : _resolve(id, guid, type);
            }

            if (type == typeof(LayerMask))
                return (LayerMask)unchecked((int)uint.Parse(((YamlScalarNode)node["m_Bits"]).Value!, CultureInfo.InvariantCulture));
            if (type == typeof(Vector2))
                return new Vector2(UnityYamlObject.Number(node["x"]), UnityYamlObject.Number(node["y"]));
            if (type == typeof(Vector3))
                return UnityYamlObject.Vector(node);
            if (type == typeof(Color))
                return new Color(UnityYamlObject.Number(node["r"]), UnityYamlObject.Number(node["g"]), UnityYamlObject.Number(node["b"]), UnityYamlObject.Number(node["a"]));
            if (type == typeof(bool))
                return ((YamlScalarNode)node).Value == "1";
            if (type.IsArray)
            {
                YamlNode[] items = ((YamlSequenceNode)node).ToArray();
                Array array = Array.CreateInstance(type.GetElementType()!, items.Length);
                for (int i = 0; i < items.Length; i++)
                    array.SetValue(Convert(items[i], type.GetElementType()!), i);
                return array;
            }

            if (node is YamlScalarNode scalar)
            {
                if (type.IsEnum)
                    return Enum.ToObject(type, int.Parse(scalar.Value!, CultureInfo.InvariantCulture));
                return System.Convert.ChangeType(scalar.Value, type, CultureInfo.InvariantCulture);
            }

            if (!type.IsDefined(typeof(SerializableAttribute), false))
                throw new InvalidOperationException(type.Name + " is not marked Serializable");
            object value = Activator.CreateInstance(type)!;
            Apply(value, (YamlMappingNode)node, _ => false);
            return value;
        }
    }
}
