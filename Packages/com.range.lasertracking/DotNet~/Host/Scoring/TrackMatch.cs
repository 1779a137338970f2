namespace LaserTracking.Host.Scoring
{
    /// <summary>When a tracked box may be taken for a true one, and how far apart they then are.</summary>
    internal enum TrackMatch
    {
        /// <summary>Centres at most 20 px apart; the distance in px.</summary>
        Centre20,

        /// <summary>Intersection over union at least 0.5; the distance is 1 less that.</summary>
        Iou05,
    }
}
