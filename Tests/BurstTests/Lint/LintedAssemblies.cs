using System;
using System.IO;
using Mono.Cecil;

namespace LaserTracking.Burst
{
    /// <summary>The assemblies beside this one, as Cecil reads them.</summary>
    internal static class LintedAssemblies
    {
        private static readonly DefaultAssemblyResolver Resolver = CreateResolver();

        public static AssemblyDefinition Jobs { get; } = Read("Range.LaserTracking.Burst");

        public static AssemblyDefinition Core { get; } = Read("Range.LaserTracking.Core");

        public static AssemblyDefinition Tests { get; } = Read("BurstTests");

        private static AssemblyDefinition Read(string name) =>
            AssemblyDefinition.ReadAssembly(Path.Combine(AppContext.BaseDirectory, name + ".dll"), new ReaderParameters { AssemblyResolver = Resolver });

        private static DefaultAssemblyResolver CreateResolver()
        {
            var resolver = new DefaultAssemblyResolver();
            resolver.AddSearchDirectory(AppContext.BaseDirectory);
            resolver.AddSearchDirectory(Path.GetDirectoryName(typeof(object).Assembly.Location)!);
            return resolver;
        }
    }
}
