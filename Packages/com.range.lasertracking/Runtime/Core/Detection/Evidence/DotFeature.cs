namespace LaserTracking.Detection
{
    /// <summary>
    /// What is measured on a candidate to weigh it, in the order of <see cref="DetectionTrace.EvidenceOf"/>. "Rise" is the largest one of its
    /// plane; "ring" reaches from half its size to a little over its size beside it; "around" means 40 px of a picture 640 wide.
    /// </summary>
    public enum DotFeature
    {
        /// <summary>Rise through the room that was left, 0…1.</summary>
        Rise,

        /// <summary>Logarithm of the area, px² at 640.</summary>
        LogArea,

        /// <summary>Area through that of the ellipse with the same moments.</summary>
        Compactness,

        /// <summary>Logarithm of length through width.</summary>
        LogElongation,

        /// <summary>Share of the ring that rose at least half as far above its past.</summary>
        RingShare,

        /// <summary>Share around that became brighter since the last frame by a sixth of the rise.</summary>
        BrightenedAround,

        /// <summary>Share around that became darker; a laser only adds light.</summary>
        DarkenedAround,

        /// <summary>The same in the ring.</summary>
        DarkenedRing,

        /// <summary>Recent onsets of the tile through the rise.</summary>
        Activity,

        /// <summary>The same of the liveliest of the tile and its eight neighbours.</summary>
        ActivityAround,

        /// <summary>Share of the rise that came with this frame.</summary>
        Freshness,

        /// <summary>Rise of the stronger of red and green per pixel of area, through the rise: grey things reach one.</summary>
        Vividness,

        /// <summary>How much of all red-green difference points one way, 0…1.</summary>
        Coherence,

        /// <summary>Levels above the brightest that the projected picture shows, through 64.</summary>
        ContentExcess,

        /// <summary>How much brighter than its ring it is now, through the rise.</summary>
        ContrastNow,

        /// <summary>How much brighter than its ring the place was before, through the rise: what was covered was darker.</summary>
        ContrastBefore,

        /// <summary>Share around that rose at least half as far above its past.</summary>
        RisenAround,

        /// <summary>Rise of the other plane (smallest or largest channel) at the same place, share of its room.</summary>
        OtherRise,

        /// <summary>Logarithm of the rise in levels times the root of the area at 640: what the eye integrates.</summary>
        LogStrength,

        /// <summary>How much the rise differs from itself turned by half a turn, within the box and half its size around it: 0 for light on an even wall.</summary>
        Asymmetry,
    }
}
