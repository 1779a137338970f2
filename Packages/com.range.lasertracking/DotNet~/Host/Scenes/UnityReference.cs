namespace LaserTracking.Host.Scenes
{
    /// <summary>A reference to an object: in the same file when the guid is empty, to nothing when the id is 0.</summary>
    internal readonly record struct UnityReference(long FileId, string Guid)
    {
        public bool IsNull => FileId == 0;
    }
}
