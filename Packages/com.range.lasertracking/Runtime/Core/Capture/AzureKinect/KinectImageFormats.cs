using LaserTracking.Imaging;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>How each picture format is named in recordings, and which raw layout it is.</summary>
    internal static class KinectImageFormats
    {
        /// <summary>"b16g": 16-bit samples, most significant byte first.</summary>
        public const uint BigEndian16 = 0x62313667;

        private static readonly Row[] Colors =
        {
            new Row(KinectImageFormat.Mjpg, 0x4D4A5047, 24, "MJPG", PixelFormat.None),
            new Row(KinectImageFormat.Nv12, 0x4E563132, 12, "NV12", PixelFormat.Nv12),
            new Row(KinectImageFormat.Yuy2, 0x59555932, 16, "YUY2", PixelFormat.Yuy2),
            new Row(KinectImageFormat.Bgra32, 0x42475241, 32, "BGRA", PixelFormat.Bgra32),
            new Row(KinectImageFormat.Gray8, 0x59383030, 8, "Y800", PixelFormat.Gray8),
        };

        private static readonly Row Depth = new Row(KinectImageFormat.Depth16, BigEndian16, 16, "b16g", PixelFormat.Depth16);
        private static readonly Row Infrared = new Row(KinectImageFormat.Ir16, BigEndian16, 16, "b16g", PixelFormat.Infrared16);

        /// <summary>The colour format of a four-character code (first character in the highest byte), or Unknown.</summary>
        public static KinectImageFormat FromFourCc(uint fourCc)
        {
            foreach (Row row in Colors)
            {
                if (row.FourCc == fourCc)
                    return row.Format;
            }

            return KinectImageFormat.Unknown;
        }

        /// <summary>The format that stores pictures of this layout as they are, or Unknown.</summary>
        public static KinectImageFormat FromPixelFormat(PixelFormat format)
        {
            foreach (Row row in Colors)
            {
                if (row.Pixels == format && format != PixelFormat.None)
                    return row.Format;
            }

            return format == PixelFormat.Depth16 ? KinectImageFormat.Depth16 : format == PixelFormat.Infrared16 ? KinectImageFormat.Ir16 : KinectImageFormat.Unknown;
        }

        public static uint FourCcOf(KinectImageFormat format) => RowOf(format).FourCc;

        public static int BitsOf(KinectImageFormat format) => RowOf(format).Bits;

        /// <summary>None for JPEG and for what is unknown.</summary>
        public static PixelFormat PixelFormatOf(KinectImageFormat format) => RowOf(format).Pixels;

        /// <summary>As the tag K4A_COLOR_MODE says it: "NV12_720P".</summary>
        public static string ModeNameOf(KinectImageFormat format, int height) =>
            (format == KinectImageFormat.Unknown ? "UNKNOWN" : RowOf(format).Name) + "_" + height + "P";

        private static Row RowOf(KinectImageFormat format)
        {
            foreach (Row row in Colors)
            {
                if (row.Format == format)
                    return row;
            }

            return format == KinectImageFormat.Depth16 ? Depth : format == KinectImageFormat.Ir16 ? Infrared : default;
        }

        private readonly struct Row
        {
            public readonly KinectImageFormat Format;
            public readonly uint FourCc;
            public readonly int Bits;
            public readonly string Name;
            public readonly PixelFormat Pixels;

            public Row(KinectImageFormat format, uint fourCc, int bits, string name, PixelFormat pixels)
            {
                Format = format;
                FourCc = fourCc;
                Bits = bits;
                Name = name;
                Pixels = pixels;
            }
        }
    }
}
