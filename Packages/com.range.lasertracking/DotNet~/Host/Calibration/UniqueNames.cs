using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace LaserTracking.Host.Calibration
{
    /// <summary>Short names of files that tell them apart: the file's own, with as many of its folders as that takes.</summary>
    internal static class UniqueNames
    {
        /// <summary>"left1.jpg" where that is the only one, else "morning/left1.jpg"; one that comes twice gets a number behind it.</summary>
        public static string[] Of(IEnumerable<string> paths)
        {
            string[][] parts = paths.Select(path => path.Split('/', Path.DirectorySeparatorChar)).ToArray();
            int most = parts.Select(part => part.Length).DefaultIfEmpty(1).Max();
            string[] names = [];
            for (int kept = 1; kept <= most; kept++)
            {
                names = parts.Select(part => string.Join('/', part.TakeLast(kept))).ToArray();
                if (names.Distinct(StringComparer.OrdinalIgnoreCase).Count() == names.Length)
                    break;
            }

            return Numbered(names, string.Empty);
        }

        /// <summary>The same as names of pictures in one folder: flat, ending in .png, different also where only the ending was.</summary>
        public static string[] OfPictures(IEnumerable<string> names)
        {
            string[] flat = names.Select(name => name.Replace('/', '-').Replace('\\', '-')).ToArray(), stems = flat.Select(name => Path.GetFileNameWithoutExtension(name)!).ToArray();
            for (int i = 0; i < flat.Length; i++)
                flat[i] = stems.Count(stem => stem.Equals(stems[i], StringComparison.OrdinalIgnoreCase)) == 1 ? stems[i] : flat[i].Replace('.', '-');
            return Numbered(flat, ".png");
        }

        private static string[] Numbered(string[] names, string ending)
        {
            var taken = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
            return names.Select(name =>
            {
                string free = name;
                for (int i = 2; !taken.Add(free); i++)
                    free = FormattableString.Invariant($"{name} ({i})");
                return free + ending;
            }).ToArray();
        }
    }
}
