using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using NUnit.Framework;

namespace LaserTracking.Unity
{
    /// <summary>The vendors' stand-ins may not offer what the vendors do not: then the package would compile here and not there.</summary>
    public sealed class VendorSignatureTests
    {
        [TestCase("KinectStandIn", "Microsoft.Azure.Kinect.Sensor", "Microsoft.Azure.Kinect.Sensor", "azure-kinect-sensor.txt", 45)]
        [TestCase("OpenCvStandIn", "OpenCvSharp", "OpenCvSharp", "opencvsharp.txt", 35)]
        [TestCase("UnityEditorStandIn", "UnityEditor", "UnityEditorStandIn", "unity-editor.txt", 45)]
        public void VendorStandIn_EveryPublicTypeAndMember_IsOneOfTheVendors(string harness, string vendor, string assembly, string file, int leastMembers)
        {
            string folder = Path.Combine(TestFiles.Data, "..", "api"), path = Path.Combine(folder, file);
            if (!File.Exists(path))
                Assert.Ignore("list of the vendor's signatures not there: " + Path.GetFullPath(path));
            var list = new SignatureList(path);
            var wrong = new List<string>();
            int members = 0;
            Type[] types = Assembly.Load(assembly).GetExportedTypes();
            foreach (Type type in types.Where(type => type.Namespace != harness))
            {
                string name = SignatureText.FullName(type);
                // A delegate's line is its only member.
                if (!typeof(Delegate).IsAssignableFrom(type))
                    wrong.AddRange(StandInSignatureTests.ProblemsOf(list, type, name));
                foreach (string member in SignatureText.Members(type))
                {
                    members++;
                    StandInSignatureTests.Check(list, name + " | " + member, wrong);
                }
            }

            Assert.That(wrong, Is.Empty);
            Assert.That(members, Is.GreaterThan(leastMembers), "members compared");
            Assert.That(types.Where(type => type.Namespace != harness && type.Namespace != vendor && !type.Namespace!.StartsWith(vendor + ".", StringComparison.Ordinal)), Is.Empty);
        }

        [TestCase("KinectStandIn")]
        [TestCase("OpenCvStandIn")]
        [TestCase("UnityEditorStandIn")]
        public void VendorStandIn_EveryFile_SaysThatItIsTestCode(string folder)
        {
            string[] files = Directory.GetFiles(Path.Combine(TestFiles.Repository, "Tests", folder), "*.cs", SearchOption.AllDirectories);
            Assert.That(files, Is.Not.Empty);
            Assert.That(files.Where(file => !File.ReadLines(file).First().StartsWith("// Test code, never shipped", StringComparison.Ordinal)), Is.Empty);
        }
    }
}
