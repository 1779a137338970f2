using System;
using LaserTracking.Imaging;
using LaserTracking.Patterns;

namespace LaserTracking.Simulation
{
    /// <summary>The calibration's pictures one after the other, again and again. Immutable.</summary>
    internal sealed class PatternContent : IPictureContent
    {
        private readonly byte[][] _pictures = new byte[ScreenPattern.Pictures][];
        private readonly double _holdS;
        private readonly int _width;

        public PatternContent(ProjectorSettings projector)
        {
            _holdS = projector.PatternHoldMs / 1000;
            _width = projector.Width;
            var pattern = new ScreenPattern(projector.Width, projector.Height);
            using var drawn = new Image();
            using var colored = new Image();
            for (int i = 0; i < _pictures.Length; i++)
            {
                pattern.Draw(i, drawn);
                ColorConversion.ToBgra(drawn, colored);
                _pictures[i] = colored.Bytes.ToArray();
            }
        }

        public unsafe void Draw(Image picture, PixelRect rect, double timeS)
        {
            byte[] shown = _pictures[(int)(Math.Floor(timeS / _holdS) % _pictures.Length + _pictures.Length) % _pictures.Length];
            int bytes = (rect.Right - rect.Left) * 4;
            for (int y = rect.Top; y < rect.Bottom; y++)
                shown.AsSpan((y * _width + rect.Left) * 4, bytes).CopyTo(new Span<byte>(picture.Pixels + (long)y * picture.Stride + rect.Left * 4, bytes));
        }
    }
}
