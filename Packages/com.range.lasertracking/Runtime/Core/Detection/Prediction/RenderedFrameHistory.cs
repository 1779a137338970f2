using System;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The pictures that the projector was given lately, with the times at which they were drawn. Whoever draws adds, the detector looks
    /// back; both may be on threads of their own. Pictures wider than 640 px, or than the camera can see them, are reduced to less by a whole number. Keeps 48 of them
    /// (0.8 s at 60 a second); no allocation once that many have come. Their clock may differ from the camera's by up to the range of
    /// delays that is searched.
    /// </summary>
    public sealed class RenderedFrameHistory
    {
        /// <summary>Give pictures of this width or less where it costs nothing: more is not looked at.</summary>
        public const int MaxWidthPx = 640;

        internal const int Capacity = 48;

        private readonly RenderedPicture[] _pictures = new RenderedPicture[Capacity];
        private int[] _looks = Array.Empty<int>();
        private int _sourceWidth;
        private int _sourceHeight;
        private int _factor = 1;
        private int _maxWidth = MaxWidthPx;
        private int _newest = -1;

        public RenderedFrameHistory()
        {
            for (int i = 0; i < Capacity; i++)
                _pictures[i] = new RenderedPicture();
        }

        /// <summary>Pictures kept.</summary>
        public int Count { get; private set; }

        /// <summary>Size of the kept pictures, px; 0 before the first.</summary>
        internal int Width { get; private set; }

        internal int Height { get; private set; }

        /// <summary>Whoever reads several pictures holds this.</summary>
        internal object Gate { get; } = new object();

        /// <summary>
        /// Adds a picture, drawn at this time on a clock that runs like the camera's, µs. Another size, or a time before the last one's,
        /// starts the history anew; of two with the same time the second stays.
        /// </summary>
        /// <exception cref="ArgumentException">The picture has no format that shows colours.</exception>
        public void Add(Image picture, long drawnUs)
        {
            if (!picture.IsPresent || !PixelRow.CanRead(picture.Format))
                throw new ArgumentException("a rendered picture must be present and in a colour format, this is " + picture.Format);
            lock (Gate)
            {
                if (picture.Width != _sourceWidth || picture.Height != _sourceHeight)
                    Resize(picture);
                if (Count > 0 && drawnUs < At(0).TimeUs)
                    Count = 0;
                bool isSame = Count > 0 && drawnUs == At(0).TimeUs;
                if (!isSame)
                {
                    _newest = (_newest + 1) % Capacity;
                    Count = Math.Min(Capacity, Count + 1);
                }

                _pictures[_newest].Fill(picture, _factor, Width, Height, _looks, drawnUs);
            }
        }

        public void Clear()
        {
            lock (Gate)
                Count = 0;
        }

        /// <summary>
        /// Keeps pictures of this width or less, px: finer than the camera sees the screen is no use, and its blur would reach farther than what is
        /// allowed for. Starts the history anew where that changes their size.
        /// </summary>
        internal void LimitWidth(int px)
        {
            int before = FactorFor(_sourceWidth, _sourceHeight);
            _maxWidth = Math.Max(1, Math.Min(MaxWidthPx, px));
            if (FactorFor(_sourceWidth, _sourceHeight) == before)
                return;
            _sourceWidth = 0;
            Count = 0;
        }

        /// <summary>0: the newest.</summary>
        internal RenderedPicture At(int age) => _pictures[(_newest - age + Capacity) % Capacity];

        /// <summary>When the next picture replaced this one, or will have done by the pace of the last ones.</summary>
        internal long EndUs(int age)
        {
            if (age > 0)
                return At(age - 1).TimeUs;
            return At(0).TimeUs + (Count > 1 ? At(0).TimeUs - At(1).TimeUs : 16_667);
        }

        private void Resize(Image picture)
        {
            _sourceWidth = picture.Width;
            _sourceHeight = picture.Height;
            _factor = FactorFor(picture.Width, picture.Height);
            Width = picture.Width / _factor;
            Height = picture.Height / _factor;
            _looks = ScreenGrid.Looks(Width, Height);
            Count = 0;
        }

        private int FactorFor(int width, int height) => Math.Min(Math.Min(width, height), (width + _maxWidth - 1) / _maxWidth);
    }
}
