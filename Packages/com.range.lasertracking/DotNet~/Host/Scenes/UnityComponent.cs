namespace LaserTracking.Host.Scenes
{
    /// <summary>A component that the reader looks into.</summary>
    /// <param name="ClassId">Unity's class number.</param>
    /// <param name="FileId">Its id in the scene.</param>
    /// <param name="Script">Class name of one of the product's scripts, or empty.</param>
    /// <param name="Fields">Its serialised fields.</param>
    internal sealed record UnityComponent(int ClassId, long FileId, string Script, UnityFields Fields);
}
