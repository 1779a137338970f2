using System.Collections.Generic;
using System.IO;
using System.Linq;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Repository
{
    /// <summary>One .asmdef and the project of the same name below DotNet~.</summary>
    internal sealed class AssemblyDefinition
    {
        private readonly JObject _json;

        private AssemblyDefinition(string path)
        {
            Path = path;
            _json = JObject.Parse(RepositoryFiles.Read(path));
        }

        public static IReadOnlyList<AssemblyDefinition> All { get; } =
            RepositoryFiles.Assets.Where(path => path.EndsWith(".asmdef")).Select(path => new AssemblyDefinition(path)).ToList();

        public string Path { get; }

        public string Folder => Path.Substring(0, Path.LastIndexOf('/'));

        public string Name => Text("name");

        public string RootNamespace => Text("rootNamespace");

        public bool HasNoEngineReferences => Flag("noEngineReferences");

        public bool AllowsUnsafeCode => Flag("allowUnsafeCode");

        public bool IsAutoReferenced => Flag("autoReferenced");

        public IReadOnlyList<string> References => Strings("references");

        public IReadOnlyList<string> IncludePlatforms => Strings("includePlatforms");

        public IReadOnlyList<string> DefineConstraints => Strings("defineConstraints");

        /// <summary>Libraries by file name, without those of other assemblies in the project.</summary>
        public IReadOnlyList<string> PrecompiledReferences => Strings("precompiledReferences");

        /// <summary>Symbols that are there when a package is, by the package's name.</summary>
        public IReadOnlyDictionary<string, string> VersionDefines => ((JArray)_json["versionDefines"]!).ToDictionary(entry => (string)entry["name"]!, entry => (string)entry["define"]!);

        public string ProjectFile => RepositoryFiles.Package + "/DotNet~/" + Name + "/" + Name + ".csproj";

        public bool IsTestAssembly => Path.StartsWith(RepositoryFiles.Package + "/Tests/");

        /// <summary>Own assemblies it references.</summary>
        public IEnumerable<AssemblyDefinition> OwnReferences => References.Select(name => All.FirstOrDefault(other => other.Name == name)).OfType<AssemblyDefinition>();

        public bool HasFile(string name) => File.Exists(RepositoryFiles.Absolute(Folder + "/" + name));

        private string Text(string field) => (string?)_json[field] ?? "";

        private bool Flag(string field) => (bool?)_json[field] ?? false;

        private string[] Strings(string field) => (_json[field] as JArray)?.Values<string>().Select(text => text!).ToArray() ?? new string[0];
    }
}
