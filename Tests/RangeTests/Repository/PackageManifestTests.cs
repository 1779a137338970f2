using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Repository
{
    /// <summary>After the rules of Unity's package validation suite.</summary>
    public sealed class PackageManifestTests
    {
        private static readonly JObject Manifest = JObject.Parse(RepositoryFiles.Read(RepositoryFiles.Package + "/package.json"));

        private static string Version => (string)Manifest["version"]!;

        [Test]
        public void Manifest_Name_IsTheFoldersAndAllowed()
        {
            Assert.That((string?)Manifest["name"], Is.EqualTo(Path.GetFileName(RepositoryFiles.Package)));
            Assert.That((string?)Manifest["name"], Does.Match("^[a-z0-9][a-z0-9-._]{0,213}$"));
            Assert.That((string?)Manifest["displayName"], Does.Match("^[A-Za-z0-9 ]+$"));
            Assert.That((string?)Manifest["unity"], Is.EqualTo("2022.3"));
            Assert.That((string?)Manifest["license"], Is.EqualTo("MIT"));
        }

        [Test]
        public void Version_Everywhere_IsTheSame()
        {
            Assert.That(Version, Does.Match(@"^\d+\.\d+\.\d+(-[a-z0-9.]+)?$"));
            Match newest = Regex.Match(RepositoryFiles.Read(RepositoryFiles.Package + "/CHANGELOG.md"), @"^## \[([^\]]+)\] - \d{4}-\d{2}-\d{2}$", RegexOptions.Multiline);
            Assert.That(newest.Success, Is.True, "CHANGELOG.md has headings \"## [x.y.z] - YYYY-MM-DD\"");
            Assert.That(newest.Groups[1].Value, Is.EqualTo(Version), "CHANGELOG.md");
            Assert.That(RepositoryFiles.Read(RepositoryFiles.Package + "/DotNet~/Directory.Build.props"), Does.Contain("<Version>" + Version + "</Version>"));
            Assert.That(RepositoryFiles.Read(RepositoryFiles.Package + "/Runtime/Unity/PackageVersion.cs"), Does.Contain("\"" + Version + "\""));
        }

        [Test]
        public void Dependencies_AreThoseThatTheDesignAllows()
        {
            string[] allowed = { "com.unity.burst", "com.unity.nuget.newtonsoft-json" };
            var dependencies = (JObject)Manifest["dependencies"]!;
            Assert.That(dependencies.Properties().Select(entry => entry.Name).Where(name => !allowed.Contains(name) && !name.StartsWith("com.unity.modules.", StringComparison.Ordinal)), Is.Empty);
            Assert.That(dependencies.Properties().Select(entry => (string?)entry.Value), Is.All.Match(@"^\d+\.\d+\.\d+$"));
            var project = (JObject)JObject.Parse(RepositoryFiles.Read("Packages/manifest.json"))["dependencies"]!;
            foreach (JProperty entry in dependencies.Properties().Where(entry => project.ContainsKey(entry.Name)))
                Assert.That((string?)project[entry.Name], Is.EqualTo((string?)entry.Value), "Packages/manifest.json: " + entry.Name);
        }

        [Test]
        public void Manifest_WhatItNames_Exists()
        {
            Assert.That(File.Exists(RepositoryFiles.Absolute(RepositoryFiles.Package + "/LICENSE.md")), Is.True);
        }

        [Test]
        public void Samples_AreTheFoldersThere_WithNameDescriptionReadmeAndScene()
        {
            var samples = (JArray)Manifest["samples"]!;
            string[] folders = Directory.GetDirectories(RepositoryFiles.Absolute(RepositoryFiles.Samples)).Select(folder => "Samples~/" + Path.GetFileName(folder)).ToArray();
            Assert.That(samples.Select(sample => (string?)sample["path"]), Is.EquivalentTo(folders));

            // The name becomes a folder below Assets/Samples.
            Assert.That(samples.Select(sample => (string?)sample["displayName"]), Is.Unique.And.All.Match("^[A-Za-z][A-Za-z0-9 -]*$"));
            Assert.That(samples.Select(sample => (string?)sample["description"]), Is.All.Not.Null.And.All.Not.Empty);
            foreach (string folder in folders.Select(folder => RepositoryFiles.Absolute(RepositoryFiles.Package + "/" + folder)))
            {
                Assert.That(File.Exists(Path.Combine(folder, "README.md")), Is.True, folder);
                Assert.That(Directory.GetFiles(folder, "*.unity"), Has.Length.EqualTo(1), folder);
            }
        }
    }
}
