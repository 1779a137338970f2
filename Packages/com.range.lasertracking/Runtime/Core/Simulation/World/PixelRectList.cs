using System;

namespace LaserTracking.Simulation
{
    /// <summary>A few rectangles that never overlap: those that touch are merged. Fixed room; when it is full the last one grows.</summary>
    internal sealed class PixelRectList
    {
        private readonly PixelRect[] _rects = new PixelRect[32];
        private int _count;

        public ReadOnlySpan<PixelRect> Rects => new ReadOnlySpan<PixelRect>(_rects, 0, _count);

        public void Clear() => _count = 0;

        public void Add(PixelRect rect)
        {
            if (rect.IsEmpty)
                return;
            for (int i = 0; i < _count; i++)
            {
                if (!_rects[i].Touches(rect) && _count < _rects.Length)
                    continue;
                rect = rect.Union(_rects[i]);
                _rects[i] = _rects[--_count];
                i = -1;
            }

            _rects[_count++] = rect;
        }

        public void AddAll(PixelRectList other)
        {
            foreach (PixelRect rect in other.Rects)
                Add(rect);
        }
    }
}
