using System.Runtime.CompilerServices;

namespace LaserTracking.Detection
{
    /// <summary>Pointers to the working pictures of one frame, valid during one call of Process, and what is read off them per pixel.</summary>
    internal unsafe struct FrameView
    {
        public int Width;
        public int Height;

        /// <summary>By how much the raw picture lies beside the working one, working px.</summary>
        public int ShiftX;
        public int ShiftY;

        /// <summary>Edges do not meet their own past: see <see cref="GlobalChangeMeter.IsBetweenPixels"/>.</summary>
        public bool IsBetweenPixels;

        public uint* Now;
        public uint* Before;
        public byte* OldSmallest;
        public byte* NewSmallest;
        public byte* OldLargest;
        public byte* NewLargest;

        /// <summary>255·256 / (headroom + 8), by headroom.</summary>
        public int* Reciprocal;

        public static FrameView Of(DetectionPlanes planes, GlobalChangeMeter change, uint* now, uint* before, byte* oldSmallest, byte* newSmallest,
            byte* oldLargest, byte* newLargest, int* reciprocal) => new FrameView
        {
            Width = planes.Width,
            Height = planes.Height,
            ShiftX = change.ShiftX,
            ShiftY = change.ShiftY,
            IsBetweenPixels = change.IsBetweenPixels,
            Now = now,
            Before = before,
            OldSmallest = oldSmallest,
            NewSmallest = newSmallest,
            OldLargest = oldLargest,
            NewLargest = newLargest,
            Reciprocal = reciprocal,
        };

        /// <summary>A table for <see cref="Reciprocal"/>.</summary>
        public static int[] Reciprocals()
        {
            var table = new int[256];
            for (int headroom = 0; headroom < table.Length; headroom++)
                table[headroom] = 255 * 256 / (headroom + 8);
            return table;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int Level(uint pixel, DetectionPlane plane)
        {
            int blue = (int)(pixel & 255), green = (int)(pixel >> 8 & 255), red = (int)(pixel >> 16 & 255);
            if (plane == DetectionPlane.Smallest)
            {
                int smallest = blue < green ? blue : green;
                return red < smallest ? red : smallest;
            }

            int largest = blue > green ? blue : green;
            return red > largest ? red : largest;
        }

        /// <summary>BT.601's luma in eighths.</summary>
        public static int Luma(uint pixel) => (int)((pixel & 255) + 5 * (pixel >> 8 & 255) + 2 * (pixel >> 16 & 255)) >> 3;

        /// <summary>The brightness that the pixels' own past explains.</summary>
        public byte* Past(DetectionPlane plane) => plane == DetectionPlane.Smallest ? OldSmallest : OldLargest;

        /// <summary>The same of one pixel.</summary>
        public int Envelope(int i, DetectionPlane plane) => Past(plane)[i];

        /// <summary>Levels above the pixel's own past; may be negative.</summary>
        public int Rise(int i, DetectionPlane plane) => Level(Now[i], plane) - Envelope(i, plane);

        /// <summary>The rise as a share of the headroom, 0…255. Eight levels of headroom are always granted: noise at full brightness.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int RelativeRise(int i, DetectionPlane plane) => RelativeRise(Now[i], plane, Envelope(i, plane), Reciprocal);

        /// <summary>The same of a pixel whose past explains this much.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int RelativeRise(uint pixel, DetectionPlane plane, int envelope, int* reciprocal)
        {
            int rise = Level(pixel, plane) - envelope;
            return rise <= 0 ? 0 : rise * reciprocal[255 - envelope] >> 8;
        }

        /// <summary>At full brightness or nearly so: it may be brighter than it shows.</summary>
        public bool IsClipped(int i, DetectionPlane plane) => Level(Now[i], plane) >= DetectionPlanes.ClippedFrom;

        /// <summary>Risen by such a share of the room, 0…255, and by so many levels: by the second number where it is not at full brightness.</summary>
        public bool HasRisen(int i, DetectionPlane plane, int share, int least, int leastUnclipped) => RelativeRise(i, plane) >= share
            && Rise(i, plane) >= (IsClipped(i, plane) ? least : leastUnclipped);

        /// <summary>Change since the last frame, levels; between pixels only what leaves the range of the nine pixels around.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int Change(int i, DetectionPlane plane)
        {
            int now = Level(Now[i], plane), before = Level(Before[i], plane);
            return IsBetweenPixels ? ChangeBeyondNine(i, plane, now, before) : now - before;
        }

        private int ChangeBeyondNine(int i, DetectionPlane plane, int now, int before)
        {
            int lowest = before, highest = before, y = i / Width, x = i - y * Width;
            for (int ny = y > 0 ? y - 1 : 0; ny <= y + 1 && ny < Height; ny++)
            {
                for (int nx = x > 0 ? x - 1 : 0; nx <= x + 1 && nx < Width; nx++)
                {
                    int level = Level(Before[ny * Width + nx], plane);
                    lowest = level < lowest ? level : lowest;
                    highest = level > highest ? level : highest;
                }
            }

            return now > highest ? now - highest : now < lowest ? now - lowest : 0;
        }
    }
}
