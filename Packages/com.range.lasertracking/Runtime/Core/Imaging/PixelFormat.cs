namespace LaserTracking.Imaging
{
    /// <summary>The raw pixel layouts that the pipeline works on. Rows run from the top; there is no padding unless the stride says so.</summary>
    public enum PixelFormat : byte
    {
        None = 0,

        /// <summary>Blue, green, red, (unused) alpha: 4 bytes a pixel.</summary>
        Bgra32 = 1,

        /// <summary>Luma plane, then interleaved U V at half width and half height with the same stride; BT.601, full range. Even sizes.</summary>
        Nv12 = 2,

        /// <summary>Y0 U Y1 V for two pixels, BT.601, full range. Even width.</summary>
        Yuy2 = 3,

        /// <summary>One byte of brightness.</summary>
        Gray8 = 4,

        /// <summary>Little-endian 16-bit distance along z in mm; 0 = nothing measured.</summary>
        Depth16 = 5,

        /// <summary>Little-endian 16-bit infrared brightness without a unit.</summary>
        Infrared16 = 6,
    }
}
