namespace LaserTracking.Host.Sources;

/// <summary>One picture of a folder.</summary>
/// <param name="Path">Full path.</param>
/// <param name="Number">The last number in the file's name, or null.</param>
/// <param name="TimeUs">Its time in microseconds.</param>
internal readonly record struct ImageFolderEntry(string Path, long? Number, long TimeUs)
{
    public string Name => System.IO.Path.GetFileName(Path);

    /// <summary>In lower case, with the dot.</summary>
    public string Extension => System.IO.Path.GetExtension(Path).ToLowerInvariant();

    public bool IsJpeg => Extension is ".jpg" or ".jpeg";
}
