using System.Linq;
using Mono.Cecil;

namespace LaserTracking.Burst
{
    /// <summary>What Burst's manual says of types and of System.Math.</summary>
    internal static class BurstTypes
    {
        /// <summary>A primitive number or an enum; neither bool nor char, whose size a native call does not know.</summary>
        public static bool IsNumber(TypeReference type)
        {
            if (type is OptionalModifierType || type is RequiredModifierType)
                return IsNumber(((TypeSpecification)type).ElementType);
            return (type.IsPrimitive && type.MetadataType != MetadataType.Boolean && type.MetadataType != MetadataType.Char)
                || (!(type is TypeSpecification) && type.Resolve()?.IsEnum == true);
        }

        /// <summary>Numbers, pointers, structs of them in their natural layout.</summary>
        public static bool IsBlittable(TypeReference type)
        {
            if (type.IsPointer || IsNumber(type))
                return true;
            TypeDefinition? definition = type is TypeSpecification ? null : type.Resolve();
            return definition != null && definition.IsValueType && !definition.IsPrimitive && !definition.HasGenericParameters && IsNaturallyLaidOut(definition)
                && definition.Fields.Where(field => !field.IsStatic).All(field => IsBlittable(field.FieldType));
        }

        /// <summary>Why Burst has no use for a variable of the type; null: it has.</summary>
        public static string? ProblemOf(TypeReference type)
        {
            switch (type)
            {
                case PointerType pointer:
                    return pointer.ElementType.MetadataType == MetadataType.Void ? null : ProblemOf(pointer.ElementType);
                case ByReferenceType reference:
                    return ProblemOf(reference.ElementType);
                case RequiredModifierType modified:
                    return ProblemOf(modified.ElementType);
                case PinnedType pinned:
                    return ProblemOf(pinned.ElementType);
                case TypeSpecification _:
                    return "object";
            }

            if (type.MetadataType == MetadataType.Void || type.MetadataType == MetadataType.Boolean)
                return null;
            if (type.MetadataType == MetadataType.Char)
                return "char";
            if (type.IsPrimitive)
                return null;
            TypeDefinition? definition = type.Resolve();
            if (definition == null || !definition.IsValueType)
                return "object";
            if (definition.FullName == "System.Decimal")
                return "decimal";
            if (definition.IsEnum)
                return null;
            if (!IsNaturallyLaidOut(definition))
                return "packed";
            return definition.Fields.Where(field => !field.IsStatic).Select(field => ProblemOf(field.FieldType)).FirstOrDefault(problem => problem != null);
        }

        /// <summary>All of System.Math but what the manual excepts, and but decimals.</summary>
        public static bool IsSupportedMath(MethodDefinition method) => method.DeclaringType.FullName == "System.Math" && method.Name != "IEEERemainder"
            && !(method.Name == "Round" && method.Parameters.Count > 1) && IsNumber(method.ReturnType) && method.Parameters.All(parameter => IsNumber(parameter.ParameterType));

        private static bool IsNaturallyLaidOut(TypeDefinition type) => type.PackingSize <= 0 && !type.IsAutoLayout;
    }
}
