using System;
using System.IO;
using NUnit.Framework;

namespace LaserTracking
{
    /// <summary>Finds the repository and the reference data; a test whose data is absent is skipped and says what it missed.</summary>
    internal static class TestFiles
    {
        /// <summary>The repository's root folder.</summary>
        public static string Repository { get; } = FindRepository();

        /// <summary>Folder of the reference data: RANGE_DATA, or ../shared/data beside the repository.</summary>
        public static string Data { get; } =
            Environment.GetEnvironmentVariable("RANGE_DATA") ?? Path.GetFullPath(Path.Combine(Repository, "..", "shared", "data"));

        /// <summary>Path below the reference data. Skips the running test when it is not there.</summary>
        public static string Reference(params string[] parts)
        {
            string path = Path.Combine(Data, Path.Combine(parts));
            if (!File.Exists(path) && !Directory.Exists(path))
                Assert.Ignore("reference data not there: " + path);
            return path;
        }

        private static string FindRepository()
        {
            for (DirectoryInfo? folder = new DirectoryInfo(AppContext.BaseDirectory); folder != null; folder = folder.Parent)
            {
                if (Directory.Exists(Path.Combine(folder.FullName, "Packages", "com.range.lasertracking")))
                    return folder.FullName;
            }

            throw new InvalidOperationException("the tests do not lie below the repository");
        }
    }
}
