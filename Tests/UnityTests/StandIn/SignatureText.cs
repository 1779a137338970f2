using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace LaserTracking.Unity
{
    /// <summary>Writes types and members as the lists of Unity's public signatures do: "modifiers kind signature".</summary>
    internal static class SignatureText
    {
        private const BindingFlags Declared = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

        private static readonly Dictionary<Type, string> Keywords = new Dictionary<Type, string>
        {
            [typeof(void)] = "void", [typeof(bool)] = "bool", [typeof(byte)] = "byte", [typeof(int)] = "int", [typeof(uint)] = "uint",
            [typeof(long)] = "long", [typeof(ushort)] = "ushort", [typeof(float)] = "float", [typeof(double)] = "double",
            [typeof(string)] = "string", [typeof(object)] = "object", [typeof(char)] = "char", [typeof(short)] = "short",
        };

        private static readonly Dictionary<string, string> Operators = new Dictionary<string, string>
        {
            ["op_Addition"] = "+", ["op_Subtraction"] = "-", ["op_UnaryNegation"] = "-", ["op_Multiply"] = "*", ["op_Division"] = "/",
            ["op_Equality"] = "==", ["op_Inequality"] = "!=",
        };

        /// <summary>"Namespace.Outer.Inner&lt;T&gt;".</summary>
        public static string FullName(Type type) => (type.Namespace == null ? "" : type.Namespace + ".") + NameOf(type);

        /// <summary>"sealed class", with flags and attribute usage before it.</summary>
        public static string Kind(Type type)
        {
            string text = "";
            var usage = type.GetCustomAttribute<AttributeUsageAttribute>(false);
            if (usage != null)
                text = UsageText(type) + " ";
            if (type.IsEnum)
                return (type.IsDefined(typeof(FlagsAttribute), false) ? "[Flags] " : "") + "enum";
            if (type.IsInterface)
                return "interface";
            if (type.IsValueType)
                return text + "struct";
            return text + (type.IsAbstract && type.IsSealed ? "static " : type.IsAbstract ? "abstract " : type.IsSealed ? "sealed " : "") + "class";
        }

        /// <summary>Every member that code outside can name, in no particular order.</summary>
        public static IEnumerable<string> Members(Type type)
        {
            if (typeof(Delegate).IsAssignableFrom(type))
            {
                MethodInfo invoke = type.GetMethod("Invoke")!;
                yield return "delegate " + NameOf(invoke.ReturnType) + " (" + Parameters(invoke) + ")";
                yield break;
            }

            foreach (FieldInfo field in type.GetFields(Declared).Where(field => IsOpen(field.IsPublic, field.IsFamily || field.IsFamilyOrAssembly)))
            {
                if (!type.IsEnum)
                    yield return FieldText(field);
                else if (field.IsLiteral)
                    yield return "value " + field.Name + " = " + Convert.ToInt64(field.GetRawConstantValue(), CultureInfo.InvariantCulture);
            }

            foreach (ConstructorInfo made in type.GetConstructors(Declared).Where(made => !made.IsStatic && IsOpen(made)))
                yield return Modifiers(made) + "constructor " + SimpleName(type) + "(" + Parameters(made) + ")";
            foreach (PropertyInfo property in type.GetProperties(Declared).Where(property => property.GetAccessors(true).Any(IsOpen)))
                yield return PropertyText(property);
            foreach (EventInfo raised in type.GetEvents(Declared).Where(raised => IsOpen(raised.AddMethod!)))
                yield return Modifiers(raised.AddMethod!) + "event " + NameOf(raised.EventHandlerType!) + " " + raised.Name;
            foreach (MethodInfo method in type.GetMethods(Declared).Where(IsOpen))
            {
                if (!method.IsSpecialName)
                    yield return Modifiers(method) + "method " + NameOf(method.ReturnType) + " " + method.Name + GenericList(method) + "(" + Parameters(method) + ")" + Constraints(method);
                else if (method.Name == "op_Implicit" || method.Name == "op_Explicit")
                    yield return "static operator " + method.Name.Substring(3).ToLowerInvariant() + " " + NameOf(method.ReturnType) + "(" + Parameters(method) + ")";
                else if (method.Name.StartsWith("op_", StringComparison.Ordinal))
                    yield return "static operator " + NameOf(method.ReturnType) + " " + Operators[method.Name] + "(" + Parameters(method) + ")";
            }
        }

        /// <summary>Simple name with containing types, C# keywords and type arguments.</summary>
        public static string NameOf(Type type)
        {
            if (Keywords.TryGetValue(type, out string? keyword))
                return keyword;
            if (type.IsArray)
                return NameOf(type.GetElementType()!) + "[]";
            if (type.IsByRef)
                return NameOf(type.GetElementType()!);
            if (type.IsPointer)
                return NameOf(type.GetElementType()!) + "*";
            if (type.IsGenericParameter)
                return type.Name;
            string name = SimpleName(type);
            if (type.IsGenericType)
                name += "<" + string.Join(", ", type.GetGenericArguments().Select(NameOf)) + ">";
            return type.DeclaringType == null ? name : NameOf(type.DeclaringType) + "." + name;
        }

        private static string SimpleName(Type type) => type.Name.Split('`')[0];

        private static bool IsOpen(MethodBase method) => IsOpen(method.IsPublic, method.IsFamily || method.IsFamilyOrAssembly);

        private static bool IsOpen(bool isPublic, bool isProtected) => isPublic || isProtected;

        private static string Modifiers(MethodBase method)
        {
            string text = method.IsPublic ? "" : "protected ";
            if (method.IsStatic)
                return text + "static ";
            // In an interface the lists write no abstract: everything is.
            if (!(method is MethodInfo info) || !info.IsVirtual || info.DeclaringType!.IsInterface)
                return text;
            if (info.GetBaseDefinition() != info)
                return text + (info.IsFinal ? "sealed override " : "override ");
            return text + (info.IsAbstract ? "abstract " : info.IsFinal ? "" : "virtual ");
        }

        private static string FieldText(FieldInfo field)
        {
            string text = field.IsPublic ? "" : "protected ";
            if (field.IsLiteral)
                return text + "const " + NameOf(field.FieldType) + " " + field.Name + " = " + Literal(field.GetRawConstantValue());
            return text + (field.IsStatic ? "static " : "") + (field.IsInitOnly ? "readonly " : "") + "field " + NameOf(field.FieldType) + " " + field.Name;
        }

        private static string PropertyText(PropertyInfo property)
        {
            MethodInfo first = property.GetAccessors(true).First(IsOpen);
            string accessors = (property.GetMethod != null && IsOpen(property.GetMethod) ? "get; " : "") + (property.SetMethod != null && IsOpen(property.SetMethod) ? "set; " : "");
            ParameterInfo[] index = property.GetIndexParameters();
            string name = index.Length == 0 ? "property " + NameOf(property.PropertyType) + " " + property.Name
                : "indexer " + NameOf(property.PropertyType) + " this[" + string.Join(", ", index.Select(ParameterText)) + "]";
            return Modifiers(first) + name + " { " + accessors + "}";
        }

        private static string GenericList(MethodInfo method) =>
            method.IsGenericMethodDefinition ? "<" + string.Join(", ", method.GetGenericArguments().Select(NameOf)) + ">" : "";

        private static string Constraints(MethodInfo method)
        {
            if (!method.IsGenericMethodDefinition)
                return "";
            return string.Concat(method.GetGenericArguments().Select(argument =>
            {
                bool isStruct = (argument.GenericParameterAttributes & GenericParameterAttributes.NotNullableValueTypeConstraint) != 0;
                string[] parts = argument.GetGenericParameterConstraints().Where(type => type != typeof(ValueType)).Select(NameOf).ToArray();
                if (isStruct)
                    parts = parts.Prepend("struct").ToArray();
                return parts.Length == 0 ? "" : " where " + argument.Name + " : " + string.Join(", ", parts);
            }));
        }

        private static string Parameters(MethodBase method) =>
            (method.IsDefined(typeof(ExtensionAttribute), false) ? "this " : "") + string.Join(", ", method.GetParameters().Select(ParameterText));

        private static string ParameterText(ParameterInfo parameter)
        {
            string way = parameter.IsOut ? "out " : parameter.IsIn ? "in " : parameter.ParameterType.IsByRef ? "ref "
                : parameter.IsDefined(typeof(ParamArrayAttribute), false) ? "params " : "";
            return way + NameOf(parameter.ParameterType) + " " + parameter.Name + (parameter.HasDefaultValue ? " = " + Default(parameter) : "");
        }

        private static string Default(ParameterInfo parameter) =>
            parameter.ParameterType.IsEnum ? NameOf(parameter.ParameterType) + "." + Enum.GetName(parameter.ParameterType, parameter.RawDefaultValue!) : Literal(parameter.RawDefaultValue);

        private static string Literal(object? value) => value switch
        {
            null => "null",
            bool flag => flag ? "true" : "false",
            string text => "\"" + text + "\"",
            _ => Convert.ToString(value, CultureInfo.InvariantCulture)!,
        };

        private static string UsageText(Type type)
        {
            CustomAttributeData data = type.GetCustomAttributesData().Single(attribute => attribute.AttributeType == typeof(AttributeUsageAttribute));
            var targets = (AttributeTargets)data.ConstructorArguments[0].Value!;
            IEnumerable<string> names = targets == AttributeTargets.All ? new[] { "All" }
                : Enum.GetValues<AttributeTargets>().Where(target => target != AttributeTargets.All && (targets & target) != 0).Select(target => target.ToString());
            IEnumerable<string> named = data.NamedArguments.Select(argument => argument.MemberName + " = " + Literal(argument.TypedValue.Value));
            return "[AttributeUsage(" + string.Join(", ", new[] { string.Join("+", names) }.Concat(named)) + ")]";
        }
    }
}
