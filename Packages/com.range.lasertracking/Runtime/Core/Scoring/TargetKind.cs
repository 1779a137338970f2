namespace LaserTracking.Scoring
{
    /// <summary>What a target is to the trainee; decides how it is drawn and whether a hit is a mistake.</summary>
    public enum TargetKind
    {
        SteelPopper = 0,
        RingPaper = 1,
        Silhouette = 2,
        NoShoot = 3,
    }
}
