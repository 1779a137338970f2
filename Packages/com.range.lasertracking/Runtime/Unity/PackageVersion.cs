namespace LaserTracking.Unity
{
    /// <summary>For the header of sessions. A test compares it with package.json, which Unity does not give to programs.</summary>
    internal static class PackageVersion
    {
        public const string Text = "0.1.0";
    }
}
