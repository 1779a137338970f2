namespace LaserTracking.Imaging
{
    /// <summary>An <see cref="Image"/> as kernels see it: pointers and numbers only. Valid as long as the picture's pixels are.</summary>
    internal readonly unsafe struct PictureView
    {
        public readonly byte* Pixels;
        public readonly int Width;
        public readonly int Height;
        public readonly int Stride;
        public readonly PixelFormat Format;

        public PictureView(Image image)
        {
            Pixels = image.Pixels;
            Width = image.Width;
            Height = image.Height;
            Stride = image.Stride;
            Format = image.Format;
        }

        public static implicit operator PictureView(Image image) => new PictureView(image);

        public byte* Row(int y) => Pixels + (long)y * Stride;

        /// <summary>The row of U V that goes with a row of luma, NV12 only.</summary>
        public byte* ChromaRow(int y) => Pixels + (long)Height * Stride + (long)(y >> 1) * Stride;
    }
}
