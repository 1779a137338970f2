using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>Runs an expected view on working pictures made beforehand: for measuring what it costs by itself. One thread.</summary>
    public sealed unsafe class ExpectedViewProbe
    {
        private readonly ExpectedView _expected;
        private readonly List<uint[]> _pictures = new List<uint[]>();
        private int _width, _height, _imageWidth, _imageHeight;

        public ExpectedViewProbe(ExpectedView expected) => _expected = expected;

        /// <summary>Keeps the half-size working picture of a frame; all of the same size.</summary>
        public void Load(Frame frame)
        {
            Image image = frame.Color;
            _imageWidth = image.Width;
            _imageHeight = image.Height;
            _width = ReductionKernel.ReducedSize(image.Width, 2);
            _height = ReductionKernel.ReducedSize(image.Height, 2);
            var picture = new uint[_width * _height];
            fixed (uint* pixels = picture)
            {
                for (int y = 0; y < _height; y++)
                    ReductionKernel.Row(image, y, 2, pixels + (long)y * _width, true);
            }

            _pictures.Add(picture);
        }

        /// <summary>Looks at a kept picture as at a frame of this time; true when the expected view can be relied on.</summary>
        public bool Update(int index, long timeUs)
        {
            fixed (uint* now = _pictures[index])
            {
                var view = new FrameView { Width = _width, Height = _height, Now = now, Before = now };
                return _expected.Update(view, 2, _imageWidth, _imageHeight, timeUs, 1, true);
            }
        }
    }
}
