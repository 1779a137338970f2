using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    /// <summary>The folders of the reference data that hold dots with their truth.</summary>
    internal static class ClearMotScenes
    {
        public static IEnumerable<TestCaseData> All()
        {
            string folder = Path.Combine(TestFiles.Data, "clearmot");
            return Directory.Exists(folder)
                ? Directory.GetDirectories(folder).Where(scene => File.Exists(Path.Combine(scene, "metrics.json"))).Order(StringComparer.Ordinal)
                    .Select(scene => new TestCaseData(scene).SetArgDisplayNames(Path.GetFileName(scene)))
                : [];
        }
    }
}
