using System;
using System.IO;

namespace LaserTracking.Host
{
    /// <summary>Where the program's own checkout lies: samples, scenes and tests are found from there.</summary>
    internal static class RepositoryFolder
    {
        /// <exception cref="InputException">The program does not lie in a checkout.</exception>
        public static string Find()
        {
            for (DirectoryInfo? folder = new DirectoryInfo(AppContext.BaseDirectory); folder != null; folder = folder.Parent)
            {
                if (File.Exists(Path.Combine(folder.FullName, "Packages", "com.range.lasertracking", "package.json")))
                    return folder.FullName;
            }

            throw new InputException(AppContext.BaseDirectory, "this program does not lie in a checkout of the project", "run ./range from the repository");
        }
    }
}
