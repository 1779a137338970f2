namespace LaserTracking.Session
{
    /// <summary>One input of a session, identified by its content.</summary>
    public sealed class SessionInput
    {
        public SessionInput(string path, string? sha256)
        {
            Path = path;
            Sha256 = sha256;
        }

        /// <summary>As the user named it.</summary>
        public string Path { get; }

        /// <summary>Lower-case hex; null for what is no file.</summary>
        public string? Sha256 { get; }
    }
}
