using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Globalization;
using LaserTracking.Capture.Matroska;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>What a recording will hold, told before its first picture: shape of each track, calibration, device.</summary>
    public sealed class KinectRecordingHead
    {
        private const string Calibration = "calibration.json";

        /// <summary>Unknown: no colour.</summary>
        public KinectImageFormat ColorFormat { get; set; }

        /// <summary>Of the stored pictures, px.</summary>
        public int ColorWidth { get; set; }

        public int ColorHeight { get; set; }

        /// <summary>Where the stored colour pictures lie in the camera's; null: they are whole.</summary>
        public PixelRegion? ColorRegion { get; set; }

        /// <summary>0: no depth.</summary>
        public int DepthWidth { get; set; }

        public int DepthHeight { get; set; }

        /// <summary>0: no infrared.</summary>
        public int InfraredWidth { get; set; }

        public int InfraredHeight { get; set; }

        /// <summary>Nominal; half of its period is the window in which pictures belong together.</summary>
        public double FramesPerSecond { get; set; } = 30;

        /// <summary>The device's own calibration.json, as it gives it; null: none.</summary>
        public byte[]? DeviceCalibration { get; set; }

        /// <summary>Null: unknown.</summary>
        public string? SerialNumber { get; set; }

        /// <summary>The shapes of a frame's pictures, those that are wanted.</summary>
        /// <param name="frame">As the camera gives it.</param>
        /// <param name="streams">The wanted ones.</param>
        /// <param name="framesPerSecond">Nominal; 0 when unknown: 30 are assumed.</param>
        public static KinectRecordingHead Of(Frame frame, KinectStreams streams, double framesPerSecond)
        {
            var head = new KinectRecordingHead { FramesPerSecond = framesPerSecond > 0 ? framesPerSecond : 30 };
            if ((streams & KinectStreams.Color) != 0)
            {
                head.ColorFormat = KinectImageFormats.FromPixelFormat(frame.Color.Format);
                head.ColorWidth = frame.Color.Width;
                head.ColorHeight = frame.Color.Height;
            }

            if ((streams & KinectStreams.Depth) != 0)
                (head.DepthWidth, head.DepthHeight) = (frame.Depth.Width, frame.Depth.Height);
            if ((streams & KinectStreams.Infrared) != 0)
                (head.InfraredWidth, head.InfraredHeight) = (frame.Infrared.Width, frame.Infrared.Height);
            return head;
        }

        /// <summary>Tracks numbered in the recorder's order: colour, depth, infrared.</summary>
        internal MatroskaHead Build()
        {
            var head = new MatroskaHead();
            MatroskaTrack? color = ColorFormat == KinectImageFormat.Unknown ? null : Add(head, "COLOR", ColorFormat, ColorWidth, ColorHeight);
            MatroskaTrack? depth = DepthWidth == 0 ? null : Add(head, "DEPTH", KinectImageFormat.Depth16, DepthWidth, DepthHeight);
            MatroskaTrack? infrared = InfraredWidth == 0 ? null : Add(head, "IR", KinectImageFormat.Ir16, InfraredWidth, InfraredHeight);
            if (color != null)
            {
                Tag(head, "K4A_COLOR_MODE", KinectImageFormats.ModeNameOf(ColorFormat, ColorHeight), color.Uid);
                if (ColorRegion is PixelRegion region)
                    Tag(head, KinectConfigurationReader.RegionTag, region.ToString(), color.Uid);
            }

            KinectDepthMode mode = depth != null ? KinectDepthModes.FromSize(DepthWidth, DepthHeight, true) : KinectDepthModes.FromSize(InfraredWidth, InfraredHeight, false);
            if (mode != KinectDepthMode.Off)
                Tag(head, "K4A_DEPTH_MODE", KinectDepthModes.NameOf(mode), depth?.Uid ?? 0);
            if (infrared != null)
                Tag(head, "K4A_IR_MODE", depth != null ? "ACTIVE" : "PASSIVE", infrared.Uid);
            Tag(head, "K4A_WIRED_SYNC_MODE", "STANDALONE", 0);
            if (SerialNumber != null)
                Tag(head, "K4A_DEVICE_SERIAL_NUMBER", SerialNumber, 0);
            if (DeviceCalibration != null)
            {
                // The number only has to differ from 0; a fixed one keeps equal recordings equal.
                var file = new MatroskaAttachment(Calibration, "application/octet-stream", 101, 0, 0);
                head.Attachments.Add((file, DeviceCalibration));
                head.Tags.Add(new MatroskaTag("K4A_CALIBRATION_FILE", Calibration, 0, file.Uid));
            }

            return head;
        }

        private MatroskaTrack Add(MatroskaHead head, string name, KinectImageFormat format, int width, int height)
        {
            var track = new MatroskaTrack
            {
                Number = head.Tracks.Count + 1,
                Uid = (ulong)head.Tracks.Count + 1,
                Type = 1,
                Name = name,
                CodecId = "V_MS/VFW/FOURCC",
                CodecPrivate = BitmapHeader(format, width, height),
                DefaultDurationNs = (long)(1e9 / FramesPerSecond),
                PixelWidth = width,
                PixelHeight = height,
            };
            head.Tracks.Add(track);
            Tag(head, "K4A_" + name + "_TRACK", track.Uid.ToString(CultureInfo.InvariantCulture), track.Uid);
            return track;
        }

        private static void Tag(MatroskaHead head, string name, string value, ulong trackUid) => head.Tags.Add(new MatroskaTag(name, value, trackUid, 0));

        /// <summary>A BITMAPINFOHEADER, little-endian.</summary>
        private static byte[] BitmapHeader(KinectImageFormat format, int width, int height)
        {
            var header = new byte[40];
            Span<byte> to = header;
            BinaryPrimitives.WriteInt32LittleEndian(to, header.Length);
            BinaryPrimitives.WriteInt32LittleEndian(to.Slice(4), width);
            BinaryPrimitives.WriteInt32LittleEndian(to.Slice(8), height);
            BinaryPrimitives.WriteInt16LittleEndian(to.Slice(12), 1);
            BinaryPrimitives.WriteInt16LittleEndian(to.Slice(14), (short)KinectImageFormats.BitsOf(format));
            BinaryPrimitives.WriteUInt32BigEndian(to.Slice(16), KinectImageFormats.FourCcOf(format));
            BinaryPrimitives.WriteInt32LittleEndian(to.Slice(20), (int)Image.TightSize(KinectImageFormats.PixelFormatOf(format), width, height));
            return header;
        }
    }
}
