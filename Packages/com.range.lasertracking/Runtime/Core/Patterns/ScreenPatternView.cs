using System;

namespace LaserTracking.Patterns
{
    /// <summary>What a camera saw of the projected boards: every point of each, measured or with the reason why not. Immutable.</summary>
    public sealed class ScreenPatternView
    {
        public ScreenPatternView(int imageWidth, int imageHeight, int frames, int pictures, bool isMirrored, ScreenPoint[] first, ScreenPoint[] second)
        {
            ImageWidth = imageWidth;
            ImageHeight = imageHeight;
            Frames = frames;
            Pictures = pictures;
            IsMirrored = isMirrored;
            First = first;
            Second = second;
        }

        public int ImageWidth { get; }

        public int ImageHeight { get; }

        /// <summary>Frames looked at.</summary>
        public int Frames { get; }

        /// <summary>Different pictures among them that stood still.</summary>
        public int Pictures { get; }

        /// <summary>Seen from behind the screen, or through a mirror.</summary>
        public bool IsMirrored { get; }

        /// <summary>All points of the first board; none when it was not found.</summary>
        public ScreenPoint[] First { get; }

        /// <summary>All points of the shifted board; none when it was not found.</summary>
        public ScreenPoint[] Second { get; }

        public static int CountMeasured(ScreenPoint[] points) => Array.FindAll(points, p => p.State == ScreenPointState.Measured).Length;
    }
}
