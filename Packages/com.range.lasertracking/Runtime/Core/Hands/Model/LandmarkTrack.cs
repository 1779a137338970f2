namespace LaserTracking.Hands.Model
{
    /// <summary>What is known of one hand's landmarks from frame to frame.</summary>
    internal sealed class LandmarkTrack
    {
        private const int MaxVotes = 6;

        /// <summary>Of the depth tracker; 0: free.</summary>
        public int TrackId { get; private set; }

        /// <summary>Of the last run that was believed.</summary>
        public HandLandmarks Landmarks { get; } = new HandLandmarks();

        /// <summary><see cref="Landmarks"/> are of this frame, or of the one before while it is worked on.</summary>
        public bool IsSeen { get; set; }

        public long RetryUs { get; set; }

        public bool IsInFrame { get; set; }

        /// <summary>Right above zero, left below; limited, so that a new side wins in time.</summary>
        public int SideVotes { get; private set; }

        public void Begin(int trackId)
        {
            TrackId = trackId;
            IsSeen = false;
            IsInFrame = false;
            RetryUs = long.MinValue;
            SideVotes = 0;
        }

        public void Vote(double rightHandProbability)
        {
            if (rightHandProbability > 0.8 && SideVotes < MaxVotes)
                SideVotes++;
            else if (rightHandProbability < 0.2 && SideVotes > -MaxVotes)
                SideVotes--;
        }
    }
}
