namespace LaserTracking.Hands.Model
{
    /// <summary>An activation in memory: height × width × channels floats, channels next to each other.</summary>
    internal readonly unsafe struct FeatureMap
    {
        public FeatureMap(float* data, int height, int width, int channels)
        {
            Data = data;
            Height = height;
            Width = width;
            Channels = channels;
        }

        public float* Data { get; }

        public int Height { get; }

        public int Width { get; }

        public int Channels { get; }

        public int Pixels => Height * Width;

        public int Count => Height * Width * Channels;

        public float* Row(int y) => Data + (long)y * Width * Channels;
    }
}
