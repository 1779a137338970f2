using System;
using LaserTracking.Imaging;
using LaserTracking.Scoring;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// The picture that the projector is given, redrawn only where something moves. Not thread-safe: every source has its own.
    /// </summary>
    internal sealed unsafe class ProjectorPicture : IDisposable
    {
        private readonly PictureAssets _assets;
        private readonly PixelRectList _moving = new PixelRectList();
        private readonly PixelRectList _dirty = new PixelRectList();
        private double _drawnS = double.NaN;

        /// <param name="assets">Shared by all pictures of a range.</param>
        public ProjectorPicture(PictureAssets assets)
        {
            _assets = assets;
            Image.Reset(PixelFormat.Bgra32, assets.Width, assets.Height, 0);
            _dirty.Add(assets.Bounds);
        }

        public Image Image { get; } = new Image();

        /// <summary>Parts that differ from the picture before; valid after <see cref="Draw"/>.</summary>
        public ReadOnlySpan<PixelRect> Changed => _dirty.Rects;

        /// <summary>Where moving targets are in the scene of a time.</summary>
        public void AddMovingBounds(double timeS, PixelRectList list)
        {
            if (_assets.MovingContent != null)
                list.Add(_assets.Bounds);
            foreach (int i in _assets.Targets)
            {
                if (SceneView.Moves(_assets.View.Scene.Objects[i]))
                    list.Add(_assets.Sprite(i).Bounds(_assets.TargetToPicture(i, timeS)).Intersect(_assets.Bounds));
            }
        }

        /// <summary>Draws the scene as it stands at a time; nothing happens when it is drawn already.</summary>
        public void Draw(double timeS)
        {
            if (timeS == _drawnS)
            {
                _dirty.Clear();
                return;
            }

            bool first = double.IsNaN(_drawnS);
            _dirty.Clear();
            _dirty.AddAll(_moving);
            _moving.Clear();
            AddMovingBounds(timeS, _moving);
            _dirty.AddAll(_moving);
            if (first)
                _dirty.Add(_assets.Bounds);
            _drawnS = timeS;
            Image.TimeUs = (long)Math.Round(timeS * 1e6);
            foreach (PixelRect rect in _dirty.Rects)
                Redraw(rect, timeS, withMoving: true);
        }

        /// <summary>Draws the scene without anything that moves; the next <see cref="Draw"/> starts afresh.</summary>
        public void DrawStill()
        {
            _dirty.Clear();
            _moving.Clear();
            _dirty.Add(_assets.Bounds);
            _drawnS = double.NaN;
            Redraw(_assets.Bounds, 0, withMoving: false);
        }

        public void Dispose() => Image.Dispose();

        private void Redraw(PixelRect rect, double timeS, bool withMoving)
        {
            int bytes = (rect.Right - rect.Left) * 4;
            if (_assets.MovingContent != null && withMoving)
                _assets.MovingContent.Draw(Image, rect, timeS);
            for (int y = rect.Top; y < rect.Bottom && !(_assets.MovingContent != null && withMoving); y++)
            {
                int offset = y * Image.Stride + rect.Left * 4;
                _assets.Background.Slice(offset, bytes).CopyTo(new Span<byte>(Image.Pixels + offset, bytes));
            }

            foreach (int i in _assets.Targets)
            {
                if (!withMoving && SceneView.Moves(_assets.View.Scene.Objects[i]))
                    continue;
                PlaneMap map = _assets.TargetToPicture(i, timeS);
                PixelRect part = _assets.Sprite(i).Bounds(map).Intersect(rect);
                if (!part.IsEmpty)
                    _assets.Sprite(i).Draw(map, Image.Pixels, Image.Stride, part);
            }
        }
    }
}
