namespace LaserTracking.Session
{
    /// <summary>What a "health" line speaks of. The names are part of events.jsonl: add, never rename.</summary>
    public enum HealthKind : byte
    {
        /// <summary>A frame or its picture is missing or damaged.</summary>
        FrameGap = 0,

        /// <summary>Part of the searched picture is too bright or too busy to see a dot in. Value: share.</summary>
        Blind = 1,

        /// <summary>The input is damaged but usable. The text says where.</summary>
        Input = 2,

        /// <summary>More was found than there is room for. Value: how many were dropped.</summary>
        Overflow = 3,

        /// <summary>Part of the screen is so bright that a dot has no room above it. Value: share.</summary>
        Overexposed = 4,

        /// <summary>The picture is almost black. Value: brightness of its brightest parts, 0…255.</summary>
        Underexposed = 5,

        /// <summary>The picture flickers, as a whole or in bands. Value: swing to either side, levels.</summary>
        Flicker = 6,

        /// <summary>The whole picture grew brighter or darker by itself. Value: factor on the light.</summary>
        ExposureChange = 7,

        /// <summary>The whole picture changed its colours by itself. Value: factor on the colour named, against green.</summary>
        ColorChange = 8,

        /// <summary>The camera was bumped and looks elsewhere. Value: displacement, px.</summary>
        CameraMoved = 9,

        /// <summary>The same picture again and again. Value: for how long, seconds.</summary>
        PictureFrozen = 10,

        /// <summary>What can be seen here and what cannot. Value: smallest power or contrast that is caught.</summary>
        Advice = 11,

        /// <summary>The expected view of the rendered pictures begins or ceases to be relied on. Value: delay from drawing to seeing, s.</summary>
        Rendered = 12,

        /// <summary>Packets for the remote input were dropped; the text says why. Value: how many for this reason until then.</summary>
        Remote = 13,

        /// <summary>Camera 1 falls silent or comes back. Value: seconds without a picture of it.</summary>
        HandCamera = 14,

        /// <summary>Something is missing or set wrongly, in the scene or at the camera, or is well again. Value: 0.</summary>
        SetUp = 15,

        /// <summary>Camera 1's clock is off camera 0's. Value: seconds that it is ahead.</summary>
        HandClock = 16,

        /// <summary>All of the picture moves, and whether the camera does cannot be told without a calibrated screen. Value: displacement, px.</summary>
        MotionUnclear = 17,
    }
}
