using System;
using System.Collections.Generic;
using System.Linq;
using Mono.Cecil;
using Mono.Cecil.Cil;

namespace LaserTracking.Burst
{
    /// <summary>
    /// Walks over the IL of everything that a kernel can reach and names what Burst's manual does not allow, or allows with
    /// reservations: its rules are stricter than Burst's, which nobody could run here. Instructions that are not known to be fine are
    /// problems.
    /// </summary>
    internal sealed class KernelLint
    {
        private static readonly HashSet<string> Plain = new HashSet<string>((
            "nop ret pop dup break br brtrue brfalse beq bne.un bge bgt ble blt bge.un bgt.un ble.un blt.un switch ceq cgt cgt.un clt clt.un "
            + "add sub mul div div.un rem rem.un and or xor not neg shl shr shr.un "
            + "conv.i1 conv.i2 conv.i4 conv.i8 conv.u1 conv.u2 conv.u4 conv.u8 conv.r4 conv.r8 conv.r.un conv.i conv.u "
            + "ldind.i1 ldind.u1 ldind.i2 ldind.u2 ldind.i4 ldind.u4 ldind.i8 ldind.i ldind.r4 ldind.r8 "
            + "stind.i1 stind.i2 stind.i4 stind.i8 stind.i stind.r4 stind.r8 ldobj stobj cpobj initobj ldfld ldflda stfld "
            + "ldarg ldarga starg ldloc ldloca stloc ldc.i4 ldc.i8 ldc.r4 ldc.r8 ldnull sizeof localloc cpblk initblk constrained. readonly. volatile. unaligned. tail.").Split(' '));

        private readonly HashSet<string> _seen = new HashSet<string>();
        private readonly List<string> _problems = new List<string>();

        /// <summary>Every method walked over.</summary>
        public IReadOnlyCollection<string> Methods => _seen;

        /// <summary>Where and what, one line each.</summary>
        public IReadOnlyList<string> Problems => _problems;

        public void Walk(MethodDefinition method)
        {
            if (!_seen.Add(method.FullName))
                return;
            CheckSignature(method);
            if (!method.HasBody)
            {
                Report(method, "native or abstract code");
                return;
            }

            if (method.Body.HasExceptionHandlers)
                Report(method, "try: exceptions");
            foreach (VariableDefinition local in method.Body.Variables)
                CheckType(method, local.VariableType, "local variable");
            TypeReference? constraint = null;
            foreach (Instruction instruction in method.Body.Instructions)
            {
                Check(method, instruction, constraint);
                constraint = instruction.OpCode == OpCodes.Constrained ? (TypeReference)instruction.Operand : null;
            }
        }

        private void CheckSignature(MethodDefinition method)
        {
            if (method.HasGenericParameters || method.DeclaringType.HasGenericParameters)
                Report(method, "generic, which this lint does not follow");
            if (method.HasThis && !method.DeclaringType.IsValueType)
                Report(method, "method of an object");
            CheckType(method, method.ReturnType, "result");
            foreach (ParameterDefinition parameter in method.Parameters)
                CheckType(method, parameter.ParameterType, "parameter " + parameter.Name);
            if (method.HasThis)
                CheckType(method, method.DeclaringType, "this");
        }

        private void CheckType(MethodDefinition method, TypeReference type, string what)
        {
            string? reason = BurstTypes.ProblemOf(type);
            if (reason != null)
                Report(method, what + " " + type.FullName + ": " + reason);
        }

        private void Check(MethodDefinition method, Instruction instruction, TypeReference? constraint)
        {
            switch (instruction.OpCode.Code)
            {
                case Code.Newarr:
                    Report(method, "newarr: managed allocation");
                    break;
                case Code.Box:
                case Code.Unbox:
                case Code.Unbox_Any:
                    Report(method, instruction.OpCode.Name + ": boxing");
                    break;
                case Code.Throw:
                case Code.Rethrow:
                    Report(method, instruction.OpCode.Name + ": exceptions");
                    break;
                case Code.Ldstr:
                    Report(method, "ldstr: strings");
                    break;
                case Code.Stsfld:
                case Code.Ldsflda:
                    Report(method, instruction.OpCode.Name + " " + instruction.Operand + ": static write");
                    break;
                case Code.Ldsfld:
                    CheckStatic(method, (FieldReference)instruction.Operand);
                    break;
                case Code.Ldftn:
                case Code.Ldvirtftn:
                case Code.Calli:
                    Report(method, instruction.OpCode.Name + ": delegates");
                    break;
                case Code.Newobj:
                    CheckConstructor(method, (MethodReference)instruction.Operand);
                    break;
                case Code.Call:
                    Follow(method, (MethodReference)instruction.Operand);
                    break;
                case Code.Callvirt:
                    CheckVirtual(method, (MethodReference)instruction.Operand, constraint);
                    break;
                default:
                    if (!Plain.Contains(GeneralName(instruction.OpCode)))
                        Report(method, instruction.OpCode.Name + ": not known to be fine");
                    break;
            }
        }

        /// <summary>Without the operand that some instructions have in their names, and without the short form.</summary>
        private static string GeneralName(OpCode code)
        {
            string name = code.Name.EndsWith(".s", StringComparison.Ordinal) ? code.Name.Substring(0, code.Name.Length - 2) : code.Name;
            foreach (string general in new[] { "ldarg", "ldloc", "stloc", "ldc.i4" })
            {
                if (name.StartsWith(general + ".", StringComparison.Ordinal))
                    return general;
            }

            return name;
        }

        private void CheckStatic(MethodDefinition method, FieldReference reference)
        {
            FieldDefinition? field = reference.Resolve();
            if (field == null || !field.IsInitOnly)
                Report(method, "ldsfld " + reference + ": a static that can change");
            else if (!BurstTypes.IsNumber(field.FieldType))
                Report(method, "ldsfld " + reference + ": a static that is no number");
        }

        private void CheckConstructor(MethodDefinition method, MethodReference constructor)
        {
            if (constructor.DeclaringType.Resolve()?.IsValueType == true)
                Follow(method, constructor);
            else
                Report(method, "newobj " + constructor.DeclaringType + ": managed allocation");
        }

        private void CheckVirtual(MethodDefinition method, MethodReference called, TypeReference? constraint)
        {
            TypeDefinition? type = constraint?.IsGenericParameter == false ? constraint.Resolve() : null;
            MethodDefinition? target = type?.IsValueType == true
                ? type.Methods.FirstOrDefault(own => own.Name == called.Name && own.Parameters.Count == called.Parameters.Count) : null;
            if (target == null)
                Report(method, "callvirt " + called + ": virtual call");
            else
                Follow(method, target);
        }

        private void Follow(MethodDefinition method, MethodReference called)
        {
            MethodDefinition? target = called.Resolve();
            if (target == null)
                Report(method, "call " + called + ": not found");
            else if (BurstTypes.IsSupportedMath(target))
                return;
            else if (target.Module.Assembly.Name.Name.StartsWith("System", StringComparison.Ordinal))
                Report(method, "call " + called + ": of the class library");
            else
                Walk(target);
        }

        private void Report(MethodDefinition method, string problem) => _problems.Add(method.DeclaringType.Name + "." + method.Name + ": " + problem);
    }
}
