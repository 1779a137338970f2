using System.Collections.Generic;

namespace LaserTracking.Host.Scoring
{
    /// <summary>The true shots of one recording.</summary>
    internal sealed record TruthClip(string File, int Width, IReadOnlyList<TruthShot> Shots);
}
