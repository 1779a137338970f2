using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.Versioning;
using Mono.Cecil;
using NUnit.Framework;

namespace LaserTracking.Burst
{
    /// <summary>What Burst would be given keeps to what Burst takes. Burst itself has not seen it: nobody could run it here.</summary>
    public sealed class KernelLintTests
    {
        private static TypeDefinition[] Jobs => LintedAssemblies.Jobs.MainModule.Types.Where(type => type.Interfaces.Any(face => face.InterfaceType.Name == "IJobFor")).ToArray();

        private static TypeDefinition Loops => LintedAssemblies.Jobs.MainModule.Types.Single(type => type.Name == "BurstLoops");

        [Test]
        public void Core_ThatIsLintedHere_IsTheBuildWithoutFastPaths()
        {
            CustomAttribute target = LintedAssemblies.Core.CustomAttributes.Single(attribute => attribute.AttributeType.Name == nameof(TargetFrameworkAttribute));
            Assert.That(target.ConstructorArguments[0].Value, Is.EqualTo(".NETStandard,Version=v2.1"));
        }

        [Test]
        public void Kernels_AllThatTheyReach_StaysInsideWhatBurstAccepts()
        {
            var lint = new KernelLint();
            foreach (MethodDefinition entry in Jobs.Select(job => job.Methods.Single(method => method.Name == "Execute")).Concat(Loops.Methods))
                lint.Walk(entry);
            Assert.That(lint.Problems, Is.Empty);
            foreach (string kernel in new[] { "ReductionKernel::Row", "EnvelopeKernel::Row", "TileKernel::Greenest", "DepthGridKernel::Bridge", "PatchKernel::Match", "RatioBands::Count", "FrameView::Change", "SurfaceBands::Grow", "TorsoKernel::FindBody", "PointwiseKernel::RowScalar", "DepthwiseKernel::Row", "ExpectationKernel::Transfer", "PaperKernel::Score", "ColorConversion::YuvToBgra" })
                Assert.That(lint.Methods.Any(method => method.Contains(kernel, StringComparison.Ordinal)), Is.True, kernel + " was reached");
            Assert.That(lint.Methods, Has.Count.GreaterThan(100));
        }

        [Test]
        public void Jobs_EachOfThem_IsBlittableAndCompiledByBurstStrictly()
        {
            Assert.That(Jobs, Has.Length.EqualTo(24));
            Assert.That(Jobs.SelectMany(ProblemsOfJob), Is.Empty);
            Assert.That(Jobs.Where(job => !IsCompiledStrictly(job)).Select(job => job.Name), Is.Empty);
        }

        [Test]
        public void Loops_EachOfThem_MayBeCalledFromManagedCode()
        {
            Assert.That(Loops.Methods.Select(method => method.Name + "Job"), Is.EquivalentTo(Jobs.Select(job => job.Name)));
            Assert.That(Loops.CustomAttributes.Any(attribute => attribute.AttributeType.Name == "BurstCompileAttribute"), Is.True);
            foreach (MethodDefinition loop in Loops.Methods)
            {
                Assert.That(IsCompiledStrictly(loop), Is.True, loop.Name);
                Assert.That(loop.IsStatic && !loop.HasGenericParameters, Is.True, loop.Name);
                Assert.That(loop.Parameters.All(parameter => BurstTypes.IsBlittable(parameter.ParameterType)), Is.True, loop.Name);
            }
        }

        [Test]
        public void Runner_EveryKernelOfCore_HasAJob()
        {
            TypeDefinition runner = LintedAssemblies.Core.MainModule.Types.Single(type => type.Name == "KernelRunner");
            IEnumerable<string> kernels = runner.Methods.Where(method => method.Name == "Run").Select(method => ((PointerType)method.Parameters[0].ParameterType).ElementType.Name);
            Assert.That(Jobs.Select(job => job.Name.Substring(0, job.Name.Length - "Job".Length) + "Bands"), Is.EquivalentTo(kernels));
            IEnumerable<string> bands = LintedAssemblies.Core.MainModule.Types.Where(type => type.Interfaces.Any(one => one.InterfaceType.Name == "IKernelBands")).Select(type => type.Name);
            Assert.That(bands, Is.EquivalentTo(kernels));
        }

        [TestCase(nameof(Offenders.AllocateArray), "managed allocation")]
        [TestCase(nameof(Offenders.AllocateObject), "managed allocation")]
        [TestCase(nameof(Offenders.Box), "boxing")]
        [TestCase(nameof(Offenders.Throw), "exceptions")]
        [TestCase(nameof(Offenders.Catch), "exceptions")]
        [TestCase(nameof(Offenders.CallInterface), "virtual call")]
        [TestCase(nameof(Offenders.CallVirtually), "virtual call")]
        [TestCase(nameof(Offenders.WriteStatic), "static write")]
        [TestCase(nameof(Offenders.ReferToStatic), "static write")]
        [TestCase(nameof(Offenders.ReadChangingStatic), "a static that can change")]
        [TestCase(nameof(Offenders.ReadStaticObject), "a static that is no number")]
        [TestCase(nameof(Offenders.UseString), "strings")]
        [TestCase(nameof(Offenders.UseDelegate), "delegates")]
        [TestCase(nameof(Offenders.UseChar), "char")]
        [TestCase(nameof(Offenders.UseDecimal), "decimal")]
        [TestCase(nameof(Offenders.UsePacked), "packed")]
        [TestCase(nameof(Offenders.TakeObject), "object")]
        [TestCase(nameof(Offenders.UseArrayInStruct), "object")]
        [TestCase(nameof(Offenders.CallClassLibrary), "of the class library")]
        [TestCase(nameof(Offenders.RoundToDigits), "of the class library")]
        [TestCase(nameof(Offenders.CallNative), "native or abstract code")]
        [TestCase(nameof(Offenders.Generic), "generic")]
        [TestCase(nameof(Offenders.AddChecked), "not known to be fine")]
        [TestCase(nameof(Offenders.AllocateFarAway), "managed allocation")]
        public void Lint_MethodThatBreaksARule_IsNamed(string method, string reason)
        {
            IReadOnlyList<string> problems = ProblemsOf(method);
            Assert.That(problems, Is.Not.Empty);
            Assert.That(string.Join("\n", problems), Does.Contain(reason));
        }

        [TestCase(nameof(Offenders.KeepsToTheRules))]
        [TestCase(nameof(Offenders.CallsConstrained))]
        public void Lint_MethodThatKeepsToTheRules_HasNoProblem(string method)
        {
            Assert.That(ProblemsOf(method), Is.Empty);
        }

        [TestCase(nameof(Offenders.JobWithArray), "not blittable")]
        [TestCase(nameof(Offenders.JobWithBool), "not blittable")]
        [TestCase(nameof(Offenders.JobWithBarePointer), "NativeDisableUnsafePtrRestriction")]
        public void Lint_JobWithFieldsThatNoJobMayHave_IsNamed(string job, string reason)
        {
            TypeDefinition type = OffendersType.NestedTypes.Single(nested => nested.Name == job);
            Assert.That(string.Join("\n", ProblemsOfJob(type)), Does.Contain(reason));
        }

        private static TypeDefinition OffendersType => LintedAssemblies.Tests.MainModule.Types.Single(type => type.Name == nameof(Offenders));

        private static IReadOnlyList<string> ProblemsOf(string method)
        {
            var lint = new KernelLint();
            lint.Walk(OffendersType.Methods.Single(own => own.Name == method));
            return lint.Problems;
        }

        private static IEnumerable<string> ProblemsOfJob(TypeDefinition job)
        {
            if (job.HasGenericParameters)
                yield return job.Name + " is generic";
            foreach (FieldDefinition field in job.Fields)
            {
                if (!BurstTypes.IsBlittable(field.FieldType))
                    yield return job.Name + "." + field.Name + " is not blittable";
                if (field.FieldType.IsPointer && field.CustomAttributes.All(attribute => attribute.AttributeType.Name != "NativeDisableUnsafePtrRestrictionAttribute"))
                    yield return job.Name + "." + field.Name + " has no NativeDisableUnsafePtrRestriction";
            }
        }

        /// <summary>Strict: no reordering of sums and no fused multiply-add, or results would not be the plain ones.</summary>
        private static bool IsCompiledStrictly(ICustomAttributeProvider marked) => marked.CustomAttributes.Any(attribute =>
            attribute.AttributeType.FullName == "Unity.Burst.BurstCompileAttribute" && attribute.ConstructorArguments.Count == 2 && (int)attribute.ConstructorArguments[1].Value == 1);
    }
}
