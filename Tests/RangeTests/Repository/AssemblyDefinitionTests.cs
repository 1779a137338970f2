using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace LaserTracking.Repository
{
    /// <summary>Unity builds by .asmdef, .NET by .csproj: both must mean the same assemblies.</summary>
    public sealed class AssemblyDefinitionTests
    {
        // What Unity's own packages provide; nothing else may be asked for.
        private static readonly string[] Foreign = { "Unity.Burst", "UnityEngine.TestRunner", "UnityEditor.TestRunner" };

        [Test]
        public void AssemblyDefinition_Name_IsThatOfItsFileAndOfAProject()
        {
            Assert.That(AssemblyDefinition.All, Is.Not.Empty);
            foreach (AssemblyDefinition assembly in AssemblyDefinition.All)
            {
                Assert.That(Path.GetFileNameWithoutExtension(assembly.Path), Is.EqualTo(assembly.Name));
                Assert.That(File.Exists(RepositoryFiles.Absolute(assembly.ProjectFile)), Is.True, assembly.ProjectFile);
            }

            Assert.That(AssemblyDefinition.All.Select(assembly => assembly.Name), Is.Unique);
        }

        [Test]
        public void AssemblyDefinition_RootNamespace_IsTheProjects()
        {
            Assert.That(AssemblyDefinition.All.Where(assembly => assembly.RootNamespace != "LaserTracking").Select(assembly => assembly.Path), Is.Empty);
            Assert.That(AssemblyDefinition.All.Where(assembly => !RepositoryFiles.Read(assembly.ProjectFile).Contains("<RootNamespace>LaserTracking</RootNamespace>")).Select(assembly => assembly.ProjectFile), Is.Empty);
        }

        [Test]
        public void AssemblyDefinition_References_ResolveAndAreThoseOfTheProject()
        {
            var wrong = new List<string>();
            foreach (AssemblyDefinition assembly in AssemblyDefinition.All)
            {
                string[] own = assembly.OwnReferences.Select(other => other.Name).ToArray();
                foreach (string reference in assembly.References.Except(own).Except(Foreign))
                    wrong.Add(assembly.Path + ": reference " + reference + " does not exist");
                foreach (string missing in ProjectReferences(assembly).Except(own).Except(new[] { assembly.Name }))
                {
                    if (!Reachable(assembly).Any(other => other.Name == missing))
                        wrong.Add(assembly.ProjectFile + ": references " + missing + ", the .asmdef does not");
                }

                foreach (string missing in own.Where(name => !ReachableProjects(assembly).Contains(name)))
                    wrong.Add(assembly.Path + ": references " + missing + ", the project does not");
            }

            Assert.That(wrong, Is.Empty);
        }

        [Test]
        public void AssemblyDefinition_References_HaveNoCycle()
        {
            Assert.That(AssemblyDefinition.All.Where(assembly => Reachable(assembly).Contains(assembly)).Select(assembly => assembly.Name), Is.Empty);
        }

        [Test]
        public void AssemblyDefinition_OfCore_KnowsNoEngine()
        {
            AssemblyDefinition core = AssemblyDefinition.All.Single(assembly => assembly.Name == "Range.LaserTracking.Core");
            Assert.That(core.HasNoEngineReferences, Is.True);
            Assert.That(core.References, Is.Empty);
        }

        [Test]
        public void AssemblyDefinition_OfCalibration_SleepsUntilMathNetIsThere()
        {
            AssemblyDefinition calibration = AssemblyDefinition.All.Single(assembly => assembly.Name == "Range.LaserTracking.Calibration");
            Assert.That(calibration.HasNoEngineReferences, Is.True);
            Assert.That(calibration.References, Is.EqualTo(new[] { "Range.LaserTracking.Core" }));
            Assert.That(calibration.PrecompiledReferences, Is.EqualTo(new[] { "MathNet.Numerics.dll" }));
            Assert.That(calibration.DefineConstraints, Is.EqualTo(new[] { calibration.VersionDefines["org.nuget.mathnet.numerics"] }));
            Assert.That(AssemblyDefinition.All.Where(assembly => assembly != calibration && assembly.OwnReferences.Contains(calibration)), Is.Empty, "the package works without MathNet");
        }

        [TestCase("Range.LaserTracking.Kinect", "RANGE_KINECT", "Microsoft.Azure.Kinect.Sensor.dll")]
        [TestCase("Range.LaserTracking.OpenCv", "RANGE_OPENCV", "OpenCvSharp.dll")]
        public void AssemblyDefinition_OfAVendor_SleepsUntilItsLibraryIsThere(string name, string symbol, string library)
        {
            AssemblyDefinition vendor = AssemblyDefinition.All.Single(assembly => assembly.Name == name);
            Assert.That(vendor.DefineConstraints, Is.EqualTo(new[] { symbol }));
            Assert.That(vendor.PrecompiledReferences, Is.EqualTo(new[] { library }));
            Assert.That(vendor.VersionDefines.Values, Is.All.EqualTo(symbol));
            Assert.That(vendor.IncludePlatforms, Does.Contain("Editor").And.Contain("WindowsStandalone64"));
            Assert.That(AssemblyDefinition.All.Where(assembly => assembly.OwnReferences.Contains(vendor)), Is.Empty, "the package works without it");
        }

        [Test]
        public void AssemblyDefinition_OfTests_IsBuiltForTestsOnly()
        {
            foreach (AssemblyDefinition assembly in AssemblyDefinition.All)
            {
                Assert.That(assembly.DefineConstraints.Contains("UNITY_INCLUDE_TESTS"), Is.EqualTo(assembly.IsTestAssembly), assembly.Path);
                if (assembly.IsTestAssembly)
                    Assert.That(assembly.IsAutoReferenced, Is.False, assembly.Path);
                if (assembly.Folder.StartsWith(RepositoryFiles.Package + "/Editor", StringComparison.Ordinal))
                    Assert.That(assembly.IncludePlatforms, Is.EqualTo(new[] { "Editor" }), assembly.Path);
            }
        }

        [Test]
        public void AssemblyDefinition_EveryOne_TurnsNullableOn()
        {
            IEnumerable<string> without = AssemblyDefinition.All.Where(assembly => !assembly.HasFile("csc.rsp") || RepositoryFiles.Read(assembly.Folder + "/csc.rsp").Trim() != "-nullable:enable").Select(assembly => assembly.Path);
            Assert.That(without, Is.Empty, "a csc.rsp with -nullable:enable lies beside every .asmdef");
        }

        [Test]
        public void Source_EveryOneUnityCompiles_BelongsToAnAssembly()
        {
            Assert.That(RepositoryFiles.UnitySources.Where(path => !AssemblyDefinition.All.Any(assembly => path.StartsWith(assembly.Folder + "/", StringComparison.Ordinal))), Is.Empty);
        }

        private static HashSet<AssemblyDefinition> Reachable(AssemblyDefinition from)
        {
            var found = new HashSet<AssemblyDefinition>();
            var open = new Stack<AssemblyDefinition>(from.OwnReferences);
            while (open.Count > 0)
            {
                AssemblyDefinition next = open.Pop();
                if (!found.Add(next))
                    continue;
                foreach (AssemblyDefinition reference in next.OwnReferences)
                    open.Push(reference);
            }

            return found;
        }

        /// <summary>Own assemblies that a project references, directly.</summary>
        private static IEnumerable<string> ProjectReferences(AssemblyDefinition assembly) =>
            Regex.Matches(RepositoryFiles.Read(assembly.ProjectFile), "ProjectReference Include=\"[^\"]*/([^/\"]+)\\.csproj\"").Select(match => match.Groups[1].Value)
                .Where(name => AssemblyDefinition.All.Any(other => other.Name == name));

        private static HashSet<string> ReachableProjects(AssemblyDefinition from)
        {
            var found = new HashSet<string>();
            var open = new Stack<AssemblyDefinition>(new[] { from });
            while (open.Count > 0)
            {
                foreach (string name in ProjectReferences(open.Pop()).Where(found.Add))
                    open.Push(AssemblyDefinition.All.Single(other => other.Name == name));
            }

            return found;
        }
    }
}
