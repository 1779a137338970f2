using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace LaserTracking.Repository
{
    /// <summary>
    /// Compiles assemblies as Unity does: sources, references, unsafe code and nullable by the .asmdef and its csc.rsp, C# 9 against .NET
    /// Standard 2.1, warnings as errors; engine, editor and vendors are the stand-ins of Tests. What a symbol does not change is
    /// compiled once for all combinations. One thread.
    /// </summary>
    internal sealed class UnityCompiler
    {
        private const string Standard = "netstandard.library.ref/2.1.0/ref/netstandard2.1";

        // Unity's own packages, by the name an .asmdef uses: their members that we use are in the stand-in for the engine.
        private static readonly string[] InTheEngine = { "Unity.Burst", "UnityEngine.TestRunner", "UnityEditor.TestRunner" };

        private static readonly Dictionary<string, string> Packages = new Dictionary<string, string>
        {
            ["Newtonsoft.Json.dll"] = "newtonsoft.json/13.0.3/lib/netstandard2.0",
            ["MathNet.Numerics.dll"] = "mathnet.numerics/5.0.0/lib/netstandard2.0",
            ["nunit.framework.dll"] = "nunit/3.14.0/lib/netstandard2.0",
        };

        private static readonly Dictionary<string, string> VendorStandIns = new Dictionary<string, string>
        {
            ["Microsoft.Azure.Kinect.Sensor.dll"] = "KinectStandIn",
            ["OpenCvSharp.dll"] = "OpenCvStandIn",
        };

        private static readonly Regex Directive = new Regex(@"^[ \t]*#[ \t]*(?:if|elif)[ \t]+(.*)$", RegexOptions.Multiline);

        private readonly string _packageRoot = typeof(UnityCompiler).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>().Single(attribute => attribute.Key == "NuGetPackageRoot").Value!;
        private readonly Dictionary<string, (string[] Texts, HashSet<string> Asked)> _sources = new Dictionary<string, (string[] Texts, HashSet<string> Asked)>();
        private readonly Dictionary<string, bool> _usesEditor = new Dictionary<string, bool>();
        private readonly Dictionary<string, CSharpCompilation> _compiled = new Dictionary<string, CSharpCompilation>();
        private readonly Dictionary<CSharpCompilation, IReadOnlyList<string>> _errors = new Dictionary<CSharpCompilation, IReadOnlyList<string>>();
        private readonly Dictionary<string, MetadataReference> _files = new Dictionary<string, MetadataReference>();

        /// <summary>Compilations that were made, each distinct.</summary>
        public int CompilationCount => _compiled.Count;

        /// <summary>Whether Unity compiles the assembly at all.</summary>
        public static bool IsActive(AssemblyDefinition assembly, ISet<string> symbols, bool isEditor)
        {
            string platform = isEditor ? "Editor" : "WindowsStandalone64";
            bool isHere = assembly.IncludePlatforms.Count == 0 || assembly.IncludePlatforms.Contains(platform);
            return isHere && assembly.DefineConstraints.All(constraint => constraint[0] == '!' ? !symbols.Contains(constraint.Substring(1)) : symbols.Contains(constraint));
        }

        /// <summary>Symbols that directives of a source ask for.</summary>
        public static IEnumerable<string> SymbolsAskedFor(string source) =>
            Directive.Matches(source).SelectMany(match => Regex.Matches(match.Groups[1].Value.Split("//")[0], @"[A-Za-z_]\w*")).Select(match => match.Value).Where(name => name != "true" && name != "false").Distinct();

        /// <summary>Errors and warnings; none when it compiles as it should.</summary>
        public IReadOnlyList<string> Compile(AssemblyDefinition assembly, ISet<string> symbols, bool isEditor) =>
            Errors(Assembly(assembly, symbols, isEditor));

        /// <summary>The same for source text in place of an assembly's files: does the compiler complain where Unity's would?</summary>
        public IReadOnlyList<string> CompileText(AssemblyDefinition assembly, string source, ISet<string> symbols, bool isEditor)
        {
            CSharpCompilation compilation = Assembly(assembly, symbols, isEditor);
            SyntaxTree added = CSharpSyntaxTree.ParseText(source, (CSharpParseOptions)compilation.SyntaxTrees.First().Options, "added.cs");
            return Texts(compilation.AddSyntaxTrees(added).GetSemanticModel(added).GetDiagnostics());
        }

        private IReadOnlyList<string> Errors(CSharpCompilation compilation) =>
            _errors.TryGetValue(compilation, out IReadOnlyList<string>? known) ? known : _errors[compilation] = Texts(compilation.GetDiagnostics());

        private static IReadOnlyList<string> Texts(IEnumerable<Diagnostic> diagnostics) =>
            diagnostics.Where(found => found.Severity >= DiagnosticSeverity.Warning && !found.IsSuppressed).Select(found => found.ToString().Replace(TestFiles.Repository, "")).ToList();

        private CSharpCompilation Assembly(AssemblyDefinition assembly, ISet<string> symbols, bool isEditor)
        {
            string[] sources = RepositoryFiles.UnitySources.Where(path => OwnerOf(path) == assembly).ToArray();
            var references = new List<MetadataReference>(StandardReferences());
            var keys = new List<string>();
            if (!assembly.HasNoEngineReferences)
                references.Add(StandIn("UnityStandIn"));
            // Assemblies that never name it are the same in the editor and in a player.
            if (!_usesEditor.TryGetValue(assembly.Name, out bool usesEditor))
                _usesEditor[assembly.Name] = usesEditor = !assembly.HasNoEngineReferences && sources.Any(path => RepositoryFiles.Read(path).Contains("UnityEditor"));
            usesEditor &= isEditor;
            if (usesEditor)
                references.Add(StandIn("UnityEditorStandIn", "UnityStandIn"));
            foreach (string name in assembly.References.Where(name => !InTheEngine.Contains(name)))
            {
                AssemblyDefinition other = AssemblyDefinition.All.Single(candidate => candidate.Name == name);
                if (!IsActive(other, symbols, isEditor))
                    continue;
                CSharpCompilation compiled = Assembly(other, symbols, isEditor);
                references.Add(compiled.ToMetadataReference());
                keys.Add(KeyOf(compiled));
            }

            references.AddRange(assembly.PrecompiledReferences.Select(Precompiled));
            return Create(assembly.Name, sources, symbols, references, string.Join("+", keys) + (usesEditor ? " editor" : ""), assembly.AllowsUnsafeCode, assembly.HasFile("csc.rsp"));
        }

        private CSharpCompilation Create(string name, IReadOnlyList<string> sources, IEnumerable<string> symbols, IEnumerable<MetadataReference> references, string referenceKey, bool isUnsafe, bool isNullable)
        {
            if (!_sources.TryGetValue(name, out (string[] Texts, HashSet<string> Asked) read))
            {
                string[] texts = sources.Select(RepositoryFiles.Read).ToArray();
                _sources[name] = read = (texts, new HashSet<string>(texts.SelectMany(SymbolsAskedFor)));
            }

            string[] relevant = symbols.Where(read.Asked.Contains).OrderBy(symbol => symbol, StringComparer.Ordinal).ToArray();
            string key = name + "(" + string.Join(",", relevant) + ")[" + referenceKey + "]";
            if (_compiled.TryGetValue(key, out CSharpCompilation? known))
                return known;
            CSharpParseOptions parse = new CSharpParseOptions(LanguageVersion.CSharp9, DocumentationMode.None, preprocessorSymbols: relevant);
            var options = new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, allowUnsafe: isUnsafe, nullableContextOptions: isNullable ? NullableContextOptions.Enable : NullableContextOptions.Disable)
                // CS0649: Unity assigns serialised fields, and its compiler knows. CS1701, CS1702: unified versions of .NET's own assemblies.
                .WithSpecificDiagnosticOptions(new[] { "CS0649", "CS1701", "CS1702" }.ToDictionary(id => id, _ => ReportDiagnostic.Suppress));
            CSharpCompilation made = CSharpCompilation.Create(name, read.Texts.Select((text, i) => CSharpSyntaxTree.ParseText(text, parse, RepositoryFiles.Absolute(sources[i]), System.Text.Encoding.UTF8)), references, options);
            _compiled[key] = made;
            return made;
        }

        private string KeyOf(CSharpCompilation compiled) => _compiled.Single(entry => entry.Value == compiled).Key;

        private MetadataReference StandIn(string folder, params string[] others)
        {
            if (_files.TryGetValue(folder, out MetadataReference? known))
                return known;
            string[] sources = RepositoryFiles.Sources.Where(path => path.StartsWith("Tests/" + folder + "/", StringComparison.Ordinal)).ToArray();
            string assemblyName = VendorStandIns.FirstOrDefault(entry => entry.Value == folder).Key?.Replace(".dll", "") ?? folder;
            CSharpCompilation compiled = Create(assemblyName, sources, Array.Empty<string>(), StandardReferences().Concat(others.Select(other => StandIn(other))), "", true, false);
            return _files[folder] = compiled.ToMetadataReference();
        }

        private IEnumerable<MetadataReference> StandardReferences() =>
            Directory.GetFiles(Path.Combine(_packageRoot, Standard), "*.dll").OrderBy(path => path, StringComparer.Ordinal).Select(FileReference);

        private MetadataReference Precompiled(string file) =>
            VendorStandIns.TryGetValue(file, out string? folder) ? StandIn(folder) : FileReference(Path.Combine(_packageRoot, Packages[file], file));

        private MetadataReference FileReference(string path) => _files.TryGetValue(path, out MetadataReference? known) ? known : _files[path] = MetadataReference.CreateFromFile(path);

        /// <summary>A source belongs to the .asmdef that is nearest above it.</summary>
        private static AssemblyDefinition? OwnerOf(string path) =>
            AssemblyDefinition.All.Where(assembly => path.StartsWith(assembly.Folder + "/", StringComparison.Ordinal)).OrderByDescending(assembly => assembly.Folder.Length).FirstOrDefault();
    }
}
