using System;
using System.IO;

namespace LaserTracking.Unity
{
    /// <summary>Paths as people enter them in the Inspector: Windows' "Copy as path" puts them in quotation marks, which Mono refuses.</summary>
    internal static class UserPath
    {
        /// <summary>The path, or where it lies below a folder when it is relative.</summary>
        /// <exception cref="InputException">It has characters that no path may have.</exception>
        public static string Under(string folder, string path)
        {
            string plain = path.Trim().Trim('"');
            try
            {
                if (plain.IndexOf('\0') < 0)
                    return Path.Combine(folder, plain);
            }
            catch (ArgumentException)
            {
                // Which characters are not allowed depends on system and runtime.
            }

            throw new InputException("\"" + plain.Replace("\0", "\\0") + "\"", "this is no path", "enter it without characters such as < > | * ?");
        }
    }
}
