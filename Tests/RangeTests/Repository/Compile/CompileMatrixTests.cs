using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace LaserTracking.Repository
{
    /// <summary>
    /// Every assembly compiles in every combination of optional libraries, Unity versions, editor and player. The engine is our stand-in:
    /// this proves that the sources fit together and to C# 9, not that Unity has the members; StandInSignatureTests compares those.
    /// </summary>
    public sealed class CompileMatrixTests
    {
        private static readonly UnityCompiler Compiler = new UnityCompiler();

        /// <summary>Symbols that wake an assembly up, those of tests are Unity's own; and those that a project's settings switch.</summary>
        private static readonly string[] Optional = AssemblyDefinition.All.SelectMany(assembly => assembly.DefineConstraints).Select(symbol => symbol.TrimStart('!'))
            .Concat(AssemblyDefinition.All.SelectMany(assembly => assembly.VersionDefines.Values)).Where(symbol => symbol != "UNITY_INCLUDE_TESTS").Concat(UnitySymbols.OfTheProject).Distinct().OrderBy(symbol => symbol, StringComparer.Ordinal).ToArray();

        [Test]
        public void Assemblies_EveryCombination_CompilesWithoutAWarning([ValueSource(typeof(UnitySymbols), nameof(UnitySymbols.Versions))] string version, [Values] bool isEditor)
        {
            var wrong = new List<string>();
            var active = new HashSet<string>();
            for (int combination = 0; combination < 1 << Optional.Length; combination++)
            {
                string[] there = Optional.Where((_, bit) => (combination >> bit & 1) == 1).ToArray();
                var symbols = new HashSet<string>(UnitySymbols.For(version, isEditor).Concat(there));
                foreach (AssemblyDefinition assembly in AssemblyDefinition.All.Where(assembly => UnityCompiler.IsActive(assembly, symbols, isEditor)))
                {
                    active.Add(assembly.Name);
                    wrong.AddRange(Compiler.Compile(assembly, symbols, isEditor).Select(error => assembly.Name + " with " + string.Join(", ", there.DefaultIfEmpty("nothing")) + ": " + error));
                }
            }

            Assert.That(wrong.Distinct().Take(20), Is.Empty);
            Assert.That(AssemblyDefinition.All.Where(assembly => !active.Contains(assembly.Name)).All(assembly => !isEditor && (assembly.IsTestAssembly || assembly.IncludePlatforms.Contains("Editor"))), Is.True, "each wakes up in some combination");
            TestContext.Out.WriteLine((1 << Optional.Length) + " combinations of " + string.Join(", ", Optional) + "; " + active.Count + " assemblies; " + Compiler.CompilationCount + " distinct compilations so far");
        }

        [Test]
        public void Assemblies_WithoutOptionalLibraries_AreTheOnesThatNeedNone()
        {
            var symbols = new HashSet<string>(UnitySymbols.For("6000_3", false));
            IEnumerable<string> awake = AssemblyDefinition.All.Where(assembly => UnityCompiler.IsActive(assembly, symbols, false)).Select(assembly => assembly.Name);
            Assert.That(awake, Does.Contain("Range.LaserTracking").And.Contain("Range.LaserTracking.Core").And.None.Contains("Kinect").And.None.Contains("OpenCv").And.None.Contains("Test"));
        }

        [TestCase("class A { string? _a = null; int B() => _a.Length; }", "CS8602", Description = "nullable warnings")]
        [TestCase("namespace A; class B { }", "CS8773", Description = "C# 10")]
        [TestCase("class A { System.Half _a; }", "CS0234", Description = "not in .NET Standard 2.1")]
        [TestCase("class A : UnityEngine.MonoBehaviour { }", "CS0246", Description = "no engine in Core")]
        [TestCase("class A { int B() => 0; void C() { B(); int d = 1; } }", "CS0219", Description = "a mere warning")]
        public void Compiler_WhatUnityWouldNotTake_IsAnError(string source, string code)
        {
            AssemblyDefinition core = AssemblyDefinition.All.Single(assembly => assembly.Name == "Range.LaserTracking.Core");
            Assert.That(Compiler.CompileText(core, source, new HashSet<string>(), false), Has.Some.Contains(code));
        }

        [Test]
        public void Directives_AskOnlyForSymbolsThatThereAre()
        {
            var known = new HashSet<string>(UnitySymbols.Known.Concat(Optional)) { "NET8_0_OR_GREATER" };
            IEnumerable<string> unknown = RepositoryFiles.UnitySources.SelectMany(path => UnityCompiler.SymbolsAskedFor(RepositoryFiles.Read(path)).Where(symbol => !known.Contains(symbol)).Select(symbol => path + ": " + symbol));
            Assert.That(unknown, Is.Empty, "a misspelt symbol is never defined, and the code below it never compiled");
        }

        [TestCase("#if UNITY_EDITOR && !(A_B || true) // C\n#elif D1\n#endif", new[] { "UNITY_EDITOR", "A_B", "D1" })]
        [TestCase("int x; // #if no\n", new string[0])]
        public void SymbolsAskedFor_Source_AreThoseOfItsConditions(string source, string[] symbols)
        {
            Assert.That(UnityCompiler.SymbolsAskedFor(source), Is.EqualTo(symbols));
        }
    }
}
