using LaserTracking.Imaging;

namespace LaserTracking.Host.Sources
{
    /// <summary>One picture of a folder.</summary>
    /// <param name="Path">Full path.</param>
    /// <param name="Number">The last number in the file's name, or the capture it is from, or null.</param>
    /// <param name="TimeUs">Its time in microseconds.</param>
    /// <param name="RawFormat">Set when the file holds nothing but pixels, without row padding; then the size is known as well.</param>
    /// <param name="RawWidth">Width of raw pixels.</param>
    /// <param name="RawHeight">Height of raw pixels.</param>
    internal readonly record struct ImageFolderEntry(
        string Path, long? Number, long TimeUs, PixelFormat RawFormat = PixelFormat.None, int RawWidth = 0, int RawHeight = 0)
    {
        public string Name => System.IO.Path.GetFileName(Path);

        /// <summary>In lower case, with the dot.</summary>
        public string Extension => System.IO.Path.GetExtension(Path).ToLowerInvariant();

        public bool IsRaw => RawFormat != PixelFormat.None;

        public bool IsJpeg => Extension is ".jpg" or ".jpeg";
    }
}
