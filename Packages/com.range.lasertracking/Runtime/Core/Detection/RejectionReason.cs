namespace LaserTracking.Detection
{
    /// <summary>Why a candidate was not a shot. The names are part of events.jsonl: add, never rename.</summary>
    public enum RejectionReason : byte
    {
        None = 0,

        /// <summary>Outside the screen's polygon in the image. Value: distance to it, px.</summary>
        OutsideScreen,

        /// <summary>Fewer pixels than a laser dot has. Value: area, px.</summary>
        TooSmall,

        /// <summary>More pixels than a laser dot has. Value: area, px.</summary>
        TooLarge,

        /// <summary>Too little of its bounding box is lit. Value: share of the box.</summary>
        NotCompact,

        /// <summary>Longer than a streak can be for its width. Value: length through width.</summary>
        TooElongated,

        /// <summary>Risen too little above its own past. Value: rise through the room left to full brightness, or levels.</summary>
        TooFaint,

        /// <summary>Other pixels around it rose as well. Value: share of the ring around it.</summary>
        NotIsolated,

        /// <summary>Its surroundings move. Value: share of changing pixels around it.</summary>
        MovingSurroundings,

        /// <summary>Its colour is no laser's. Value: the measure of the detector in use.</summary>
        WrongColor,

        /// <summary>Confidence below the limit. Value: confidence.</summary>
        LowConfidence,

        /// <summary>Not conclusive, and neither vanished sharply nor came again in time. Value: frames waited.</summary>
        NotConfirmed,

        /// <summary>Belongs to a dot that was reported already. Value: distance to it, px.</summary>
        Duplicate,

        /// <summary>Was there in the frame before already, and no dot. Value: share of its rise that came with this frame.</summary>
        NotNew,

        /// <summary>Faint, and brightest where the picture ends: most of it lies outside. Value: distance to the edge, working px.</summary>
        CutByEdge,

        /// <summary>The rendered picture shows light as bright as this there. Value: levels above the expected view.</summary>
        Rendered,
    }
}
