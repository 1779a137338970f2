using System;
using System.Collections.Generic;
using System.Formats.Tar;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Threading;
using LaserTracking.Hands.Model;
using LaserTracking.Host.Terminal;

namespace LaserTracking.Host.HandModels
{
    /// <summary>Where the optional hand models lie, and how they get there: by the package client, out of the package that holds them.</summary>
    internal static class HandModelStore
    {
        private const string Client = "npm";

        /// <summary>The environment variable RANGE_MODELS, or models/ in the checkout, which is not under version control.</summary>
        public static string Folder => Environment.GetEnvironmentVariable("RANGE_MODELS") is { Length: > 0 } folder
            ? Path.GetFullPath(folder)
            : Path.Combine(RepositoryFolder.Find(), "models");

        public static IReadOnlyList<HandModelFile> All { get; } = new[] { HandModelFile.Lite, HandModelFile.Full };

        public static string PathOf(HandModelFile file) => Path.Combine(Folder, file.FileName);

        /// <exception cref="InputException">There is no model of that name.</exception>
        public static HandModelFile Named(string name) => All.FirstOrDefault(file => file.Name == name)
            ?? throw new InputException("--model", $"\"{name}\" is no hand model", "known are " + string.Join(", ", All.Select(file => file.Name)));

        /// <exception cref="InputException">Its file is missing, cut, or another one.</exception>
        public static HandLandmarkNetwork Open(HandModelFile file) => HandLandmarkNetwork.Open(PathOf(file), file);

        /// <summary>For work that goes on with depth alone: null and, on standard error too, one line that says why.</summary>
        /// <param name="name">"lite" or "full"; null: none is asked for, and there is no problem.</param>
        /// <param name="problem">Empty, or why there is none.</param>
        /// <exception cref="InputException">There is no model of that name.</exception>
        public static HandLandmarkNetwork? TryOpen(string? name, out string problem)
        {
            problem = string.Empty;
            if (name == null)
                return null;
            HandModelFile file = Named(name);
            try
            {
                return Open(file);
            }
            catch (InputException refused)
            {
                problem = refused.Message + "; hands are found by depth alone";
                Console.Error.WriteLine("range: " + problem);
                return null;
            }
        }

        /// <summary>Empty when the file is there and the right one, else what is wrong with it.</summary>
        public static string ProblemOf(HandModelFile file)
        {
            try
            {
                file.Read(PathOf(file));
                return string.Empty;
            }
            catch (InputException problem)
            {
                return problem.Message;
            }
        }

        /// <summary>Fetches both files and puts those in place that are missing or wrong; only right ones ever get there.</summary>
        /// <exception cref="InputException">The package client is not there or cannot reach its registry, or brings other files.</exception>
        public static void Fetch(CancellationToken interrupted)
        {
            Prerequisites.InstallIfAsked(Client);
            if (!OperatingSystem.IsWindows() && Prerequisites.Locate(Client) == null)
                throw new InputException("models", $"fetching them needs the package client {Client}, which is not on PATH", "install it with: " + Prerequisites.InstallCommand(Client));
            DirectoryInfo scratch = Directory.CreateTempSubdirectory("range-models-");
            try
            {
                Extract(Pack(scratch.FullName, interrupted), scratch.FullName);
                Directory.CreateDirectory(Folder);
                foreach (HandModelFile file in All)
                {
                    byte[] bytes = file.Read(Path.Combine(scratch.FullName, file.FileName));
                    string part = PathOf(file) + ".part";
                    File.WriteAllBytes(part, bytes);
                    File.Move(part, PathOf(file), overwrite: true);
                }
            }
            finally
            {
                scratch.Delete(recursive: true);
            }
        }

        private static string Pack(string folder, CancellationToken interrupted)
        {
            string[] arguments = { "pack", HandModelFile.Package, "--pack-destination", folder };
            (int exitCode, string output) = OperatingSystem.IsWindows()
                ? ChildProcess.Run("cmd", new[] { "/c", Client }.Concat(arguments), null, interrupted)
                : ChildProcess.Run(Client, arguments, null, interrupted);
            string? archive = Directory.EnumerateFiles(folder, "*.tgz").FirstOrDefault();
            if (exitCode == 0 && archive != null)
                return archive;
            string reason = output.Split('\n').Select(line => line.Trim()).FirstOrDefault(line => line.Contains("error", StringComparison.OrdinalIgnoreCase)) ?? "no archive came";
            throw new InputException("models", $"{Client} could not fetch {HandModelFile.Package} ({reason})", $"check the network and {Client}'s settings; without a model hands are found by depth alone");
        }

        private static void Extract(string archive, string folder)
        {
            try
            {
                using var packed = new GZipStream(File.OpenRead(archive), CompressionMode.Decompress);
                using var tar = new TarReader(packed);
                while (tar.GetNextEntry() is { } entry)
                {
                    string name = Path.GetFileName(entry.Name);
                    if (All.Any(file => file.FileName == name))
                        entry.ExtractToFile(Path.Combine(folder, name), overwrite: true);
                }
            }
            catch (Exception problem) when (problem is InvalidDataException or EndOfStreamException)
            {
                throw new InputException("models", "the fetched package is damaged (" + problem.Message.TrimEnd('.') + ")", "run './range models' again");
            }
        }
    }
}
