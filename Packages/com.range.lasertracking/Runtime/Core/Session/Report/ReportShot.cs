using LaserTracking.Scoring;

namespace LaserTracking.Session
{
    /// <summary>A shot with what the report derives from its neighbours and from the scene.</summary>
    internal sealed class ReportShot
    {
        public ReportShot(in ShotEvent shot)
        {
            Event = shot;
        }

        public ShotEvent Event { get; }

        public int Id => Event.Shot.Id;

        /// <summary>Since the session's start.</summary>
        public double TimeS { get; set; }

        /// <summary>Since the same shooter's shot before; NaN for the first.</summary>
        public double IntervalS { get; set; } = double.NaN;

        /// <summary>The shot before met another target: the interval is a transition, not a split.</summary>
        public bool IsTransition { get; set; }

        /// <summary>Index in <see cref="ReportData.Shooters"/>.</summary>
        public int ShooterIndex { get; set; }

        /// <summary>What was hit: index in the scene's objects, or -1.</summary>
        public int ObjectIndex { get; set; } = -1;

        public TargetDefinition? Definition { get; set; }

        /// <summary>A hit that counts against the shooter.</summary>
        public bool IsMistake => Event.HasHit && (Definition?.Kind == TargetKind.NoShoot || Event.Hit.Points < 0);

        public string? TargetName => Event.HasHit ? Event.Hit.Target : null;
    }
}
