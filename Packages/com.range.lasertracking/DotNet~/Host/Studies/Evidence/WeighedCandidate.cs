namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>What the detector measured on one new spot, and what it really was.</summary>
    /// <param name="Case">Index of the case it comes from.</param>
    /// <param name="Group">Clip or simulation: all of one group are left out together.</param>
    /// <param name="Label">What it was.</param>
    /// <param name="Shot">Number of the true shot within case and group; -1: none.</param>
    /// <param name="Features">In the order of DotFeature.</param>
    /// <param name="LogOdds">By the curves that the program was built with.</param>
    internal sealed record WeighedCandidate(int Case, int Group, CandidateLabel Label, int Shot, float[] Features, double LogOdds);
}
