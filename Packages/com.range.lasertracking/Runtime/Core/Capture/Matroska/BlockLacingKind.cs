namespace LaserTracking.Capture.Matroska
{
    /// <summary>How several frames share one block; the values are those of the flag bits 0x06.</summary>
    public enum BlockLacingKind : byte
    {
        None = 0,
        Xiph = 1,
        FixedSize = 2,
        Ebml = 3,
    }
}
