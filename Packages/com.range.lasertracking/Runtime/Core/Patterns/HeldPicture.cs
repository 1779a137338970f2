using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>The sum of successive frames in which the projector showed the same.</summary>
    internal sealed class HeldPicture
    {
        public LightPlane Sum { get; } = new LightPlane();

        public int Frames { get; private set; }

        public void Begin(Image image)
        {
            Sum.Fit(image.Width, image.Height);
            System.Array.Clear(Sum.Values, 0, image.Width * image.Height);
            Frames = 0;
            Add(image);
        }

        public void Add(Image image)
        {
            Sum.Add(image);
            Frames++;
        }
    }
}
