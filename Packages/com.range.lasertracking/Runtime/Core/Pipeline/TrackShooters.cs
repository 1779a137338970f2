namespace LaserTracking.Pipeline
{
    /// <summary>Remembers who fired the last shots, so that the dots which follow carry the shooter too. Bounded.</summary>
    internal sealed class TrackShooters
    {
        private const int Capacity = 256;

        private readonly int[] _tracks = new int[Capacity];
        private readonly int[] _shooters = new int[Capacity];

        public void Set(int trackId, int shooter)
        {
            _tracks[trackId % Capacity] = trackId;
            _shooters[trackId % Capacity] = shooter;
        }

        /// <summary>1-based, or 0: unknown.</summary>
        public int Get(int trackId) => _tracks[trackId % Capacity] == trackId ? _shooters[trackId % Capacity] : 0;
    }
}
