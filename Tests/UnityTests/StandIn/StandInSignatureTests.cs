using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace LaserTracking.Unity
{
    /// <summary>The stand-in may not offer what Unity does not have: then the package would compile here and not there.</summary>
    public sealed class StandInSignatureTests
    {
        private static readonly Type[] Types = typeof(UnityEngine.Object).Assembly.GetExportedTypes();

        [Test]
        public void StandIn_EveryPublicTypeAndMember_IsOneOfUnitys()
        {
            SignatureList list = ReadList();
            var wrong = new List<string>();
            int checkedMembers = 0;
            foreach (Type type in Types.Where(IsUnitys))
            {
                string name = SignatureText.FullName(type);
                bool isDelegate = typeof(Delegate).IsAssignableFrom(type);
                if (!isDelegate)
                    wrong.AddRange(ProblemsOf(list, type, name));
                foreach (string member in SignatureText.Members(type))
                {
                    checkedMembers++;
                    Check(list, name + " | " + member, wrong);
                }
            }

            Assert.That(wrong, Is.Empty);
            Assert.That(checkedMembers, Is.GreaterThan(250), "members compared");
        }

        [Test]
        public void StandIn_HarnessTypes_LieInTheirOwnNamespace()
        {
            Assert.That(Types.Where(type => !IsUnitys(type)).Select(type => type.Namespace).Distinct(), Is.EqualTo(new[] { "UnityStandIn" }));
        }

        [Test]
        public void StandIn_EveryFile_SaysThatItIsTestCode()
        {
            string folder = Path.Combine(TestFiles.Repository, "Tests", "UnityStandIn");
            string[] files = Directory.GetFiles(folder, "*.cs", SearchOption.AllDirectories);
            Assert.That(files.Where(file => !File.ReadLines(file).First().StartsWith("// Test code, never shipped", StringComparison.Ordinal)), Is.Empty);
            Assert.That(files, Is.Not.Empty);
        }

        [TestCase("UnityEngine.Transform | method Vector3 TransformPoint(Vector3 point)", Description = "a parameter's name is part of the signature")]
        [TestCase("UnityEngine.Transform | static method Vector3 TransformPoint(Vector3 position)")]
        [TestCase("UnityEngine.Object | static method T FindFirstObjectByType<T>() where T : Object", Description = "goes away")]
        [TestCase("UnityEngine.Vector3 | method bool Equals(in Vector3 other)", Description = "not in 2022.3")]
        public void Check_SignatureThatMayNotBeUsed_IsAProblem(string entry)
        {
            var wrong = new List<string>();
            Check(ReadList(), entry, wrong);
            Assert.That(wrong, Has.Count.EqualTo(1));
        }

        private static SignatureList ReadList()
        {
            string folder = Path.Combine(TestFiles.Data, "..", "api");
            string runtime = Path.Combine(folder, "unity-runtime.txt"), burst = Path.Combine(folder, "unity-burst.txt");
            if (!File.Exists(runtime) || !File.Exists(burst))
                Assert.Ignore("lists of Unity's signatures not there: " + Path.GetFullPath(folder));
            return new SignatureList(runtime, burst);
        }

        private static bool IsUnitys(Type type) =>
            type.Namespace == "UnityEngine" || type.Namespace!.StartsWith("UnityEngine.", StringComparison.Ordinal) || type.Namespace.StartsWith("Unity.", StringComparison.Ordinal);

        internal static IEnumerable<string> ProblemsOf(SignatureList list, Type type, string name)
        {
            var wrong = new List<string>();
            if (!Check(list, name, wrong))
                return wrong;
            // C# 9 has no record structs; to whoever uses one it is a struct.
            if (list.KindOf(name).Replace("readonly record struct", "struct").Replace("record struct", "struct") != SignatureText.Kind(type))
                wrong.Add(name + " is \"" + SignatureText.Kind(type) + "\", Unity's is \"" + list.KindOf(name) + "\"");
            IEnumerable<Type> bases = type.GetInterfaces().Except(type.BaseType?.GetInterfaces() ?? Type.EmptyTypes);
            Type[] roots = { typeof(object), typeof(ValueType), typeof(Enum) };
            if (type.IsEnum)
                bases = Type.EmptyTypes;
            else if (type.BaseType != null && !roots.Contains(type.BaseType))
                bases = bases.Append(type.BaseType);
            foreach (string extra in bases.Select(SignatureText.NameOf).Except(list.BasesOf(name)))
                wrong.Add(name + " : " + (extra == "Attribute" ? "System." : "") + extra + " is not Unity's");
            return wrong;
        }

        internal static bool Check(SignatureList list, string entry, List<string> wrong)
        {
            if (!list.TryGetTags(entry, out string tags))
            {
                wrong.Add(entry + ": not listed");
                return false;
            }

            if (tags != "" && tags != "implicit")
                wrong.Add(entry + ": may not be used, it is tagged " + tags);
            return true;
        }
    }
}
