using System;
using LaserTracking.Imaging;

namespace LaserTracking.Capture
{
    /// <summary>
    /// What one camera saw at one moment: any of a colour, a depth and an infrared picture. The caller owns it and hands the same
    /// one to the source again and again, so that a warm frame loop allocates nothing.
    /// </summary>
    public sealed class Frame : IDisposable
    {
        /// <summary>0-based index in decode order. A frame whose picture is damaged keeps its index.</summary>
        public int Index { get; set; }

        /// <summary>Mid-exposure time of the frame's first picture on the device's clock, in microseconds.</summary>
        public long TimeUs { get; set; }

        public Image Color { get; private set; } = new Image();

        public Image Depth { get; private set; } = new Image();

        public Image Infrared { get; private set; } = new Image();

        /// <summary>Empties the pictures and sets index and time, before a source fills it.</summary>
        public void Begin(int index, long timeUs)
        {
            Index = index;
            TimeUs = timeUs;
            Color.Clear();
            Depth.Clear();
            Infrared.Clear();
        }

        /// <summary>Exchanges the whole content with another frame without copying a pixel.</summary>
        public void SwapWith(Frame other)
        {
            (Index, other.Index) = (other.Index, Index);
            (TimeUs, other.TimeUs) = (other.TimeUs, TimeUs);
            (Color, other.Color) = (other.Color, Color);
            (Depth, other.Depth) = (other.Depth, Depth);
            (Infrared, other.Infrared) = (other.Infrared, Infrared);
        }

        public void Dispose()
        {
            Color.Dispose();
            Depth.Dispose();
            Infrared.Dispose();
        }
    }
}
