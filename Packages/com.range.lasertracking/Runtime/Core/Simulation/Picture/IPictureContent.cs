using LaserTracking.Imaging;

namespace LaserTracking.Simulation
{
    /// <summary>What a projected picture shows behind the targets in place of the bay, all of it anew at every time. Immutable.</summary>
    internal interface IPictureContent
    {
        /// <summary>Fills a part of the picture as it stands at a time.</summary>
        void Draw(Image picture, PixelRect rect, double timeS);
    }
}
