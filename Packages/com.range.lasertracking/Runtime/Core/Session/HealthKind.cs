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

        /// <summary>The expected view of the rendered pictures begins or ceases to be relied on. Value: delay from drawing to seeing, s.</summary>
        Rendered = 4,
    }
}
