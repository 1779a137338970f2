using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace LaserTracking.Repository
{
    public sealed partial class DocumentationLinkTests
    {
        [Test]
        public void Documents_LinksAndPictures_LeadToFiles()
        {
            string[] documents = Directory.GetFiles(TestFiles.Repository, "*.md")
                .Concat(Directory.GetFiles(Path.Combine(TestFiles.Repository, "Packages", "com.range.lasertracking"), "*.md", SearchOption.AllDirectories)).ToArray();
            var links = documents.SelectMany(document => Link().Matches(File.ReadAllText(document)).Select(match => (document, target: match.Groups[1].Value.Split('#')[0])))
                .Where(link => link.target.Length > 0 && !link.target.Contains("://", StringComparison.Ordinal)).ToArray();
            Assert.That(links, Is.Not.Empty);
            Assert.That(links.Where(link => !Path.Exists(Path.Combine(Path.GetDirectoryName(link.document)!, link.target))), Is.Empty);
        }

        [GeneratedRegex(@"\]\(([^)\s]+)\)")]
        private static partial Regex Link();
    }
}
