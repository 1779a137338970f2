using LaserTracking.Imaging;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>What one row of the position study paints.</summary>
    /// <param name="Name">For the table.</param>
    /// <param name="Amplitude">Height of the green channel over the background before clipping, levels; blue and red rise by 0.4 and 0.3 of it.</param>
    /// <param name="Noise">Standard deviation of each channel, levels.</param>
    /// <param name="Speckle">Standard deviation of each pixel's light relative to the light.</param>
    /// <param name="Background">Dark, bright or textured.</param>
    /// <param name="Width">Picture width, px; the height is nine sixteenths of it.</param>
    /// <param name="Format">Bgra32 or Nv12.</param>
    internal sealed record SpotCase(
        string Name, double Amplitude, double Noise = 2, double Speckle = 0, SpotBackground Background = SpotBackground.Dark, int Width = 1280,
        PixelFormat Format = PixelFormat.Bgra32)
    {
        public int Height => Width * 9 / 16 / 2 * 2;
    }
}
