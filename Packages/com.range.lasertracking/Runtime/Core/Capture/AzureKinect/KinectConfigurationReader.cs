using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Globalization;
using LaserTracking.Capture.Matroska;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// Makes sense of a recording's tracks and tags. What the pictures really are (their track's format and size) outweighs what a
    /// tag says about them; a contradiction is reported.
    /// </summary>
    internal sealed class KinectConfigurationReader
    {
        /// <summary>Our own: "x y width height fullWidth fullHeight" of colour pictures of which only a part was recorded.</summary>
        internal const string RegionTag = "RANGE_COLOR_REGION";

        private const long MaxDelayNs = 10000000000;

        private readonly MatroskaFile _file;
        private readonly ProblemLog _problems;

        public KinectConfigurationReader(MatroskaFile file, ProblemLog problems)
        {
            _file = file;
            _problems = problems;
        }

        public KinectTrack? Color { get; private set; }

        public KinectTrack? Depth { get; private set; }

        public KinectTrack? Infrared { get; private set; }

        public KinectTrack? Imu { get; private set; }

        public List<KinectTrack> Tracks { get; } = new List<KinectTrack>();

        public KinectRecordConfiguration Configuration { get; } = new KinectRecordConfiguration();

        /// <summary>Delay of depth against colour in nanoseconds.</summary>
        public long DepthDelayNs { get; private set; }

        public void Read()
        {
            Color = FindTrack("COLOR", "K4A_COLOR_TRACK");
            Depth = FindTrack("DEPTH", "K4A_DEPTH_TRACK");
            Infrared = FindTrack("IR", "K4A_IR_TRACK") ?? FindTrack("IR", "", "DEPTH_IR");
            Imu = FindTrack("IMU", "K4A_IMU_TRACK");
            foreach (MatroskaTrack track in _file.Tracks)
            {
                if (!Tracks.Exists(known => known.Source == track))
                    Tracks.Add(new KinectTrack(track, track.Name));
            }

            ReadImageFormat(Color);
            ReadImageFormat(Depth);
            ReadImageFormat(Infrared);
            ReadModes();
            ReadFrameRate();
            ReadDelaysAndSync();
        }

        public string? Tag(string name)
        {
            foreach (MatroskaTag tag in _file.Tags)
            {
                if (tag.Name == name)
                    return tag.Value;
            }

            return null;
        }

        private KinectTrack? FindTrack(string name, string tag, string? storedName = null)
        {
            MatroskaTrack? found = null;
            if (ulong.TryParse(Tag(tag), NumberStyles.None, CultureInfo.InvariantCulture, out ulong uid) && uid != 0)
                found = FindSource(track => track.Uid == uid);
            found ??= FindSource(track => track.Name == (storedName ?? name));
            if (found == null)
                return null;
            var result = new KinectTrack(found, name) { IsBuiltin = true };
            Tracks.Add(result);
            return result;
        }

        private MatroskaTrack? FindSource(Predicate<MatroskaTrack> condition)
        {
            foreach (MatroskaTrack track in _file.Tracks)
            {
                if (track.Number > 0 && condition(track) && !Tracks.Exists(known => known.Source == track))
                    return track;
            }

            return null;
        }

        /// <summary>Reads the BITMAPINFOHEADER of a picture track; a damaged one leaves the format unknown.</summary>
        private void ReadImageFormat(KinectTrack? track)
        {
            if (track == null)
                return;
            MatroskaTrack source = track.Source;
            track.Width = source.PixelWidth;
            track.Height = source.PixelHeight;
            byte[] header = source.CodecPrivate;
            if (!track.IsVideo || header.Length < 20)
            {
                _problems.Add(-1, "track " + track.Name + " has no description of its pictures; they cannot be used");
                return;
            }

            int width = BinaryPrimitives.ReadInt32LittleEndian(header.AsSpan(4));
            int height = BinaryPrimitives.ReadInt32LittleEndian(header.AsSpan(8));
            if (track.Width == 0 || track.Height == 0)
            {
                track.Width = Math.Max(0, width);
                track.Height = Math.Max(0, height);
            }
            else if (track.Width != width || track.Height != height)
            {
                _problems.Add(-1, Invariant($"track {track.Name} says {track.Width}×{track.Height}, its bitmap header {width}×{height}; the first is used"));
            }

            bool is16Bit = track != Color;
            KinectImageFormat format16 = track == Infrared ? KinectImageFormat.Ir16 : KinectImageFormat.Depth16;
            uint fourCc = BinaryPrimitives.ReadUInt32BigEndian(header.AsSpan(16));
            if (!is16Bit)
                track.Format = KinectImageFormats.FromFourCc(fourCc);
            // Early recorders wrote little-endian samples under the name of YUY2.
            else if (fourCc == KinectImageFormats.BigEndian16 || fourCc == KinectImageFormats.FourCcOf(KinectImageFormat.Yuy2))
                track.Format = format16;
            track.IsBigEndian = fourCc == KinectImageFormats.BigEndian16;
            if (track.Format == KinectImageFormat.Unknown)
                _problems.Add(-1, "track " + track.Name + " has an unknown picture format; its pictures cannot be used");

            if (track.Width <= 0 || track.Height <= 0 || track.Width > 1 << 14 || track.Height > 1 << 14)
            {
                track.Format = KinectImageFormat.Unknown;
                _problems.Add(-1, Invariant($"track {track.Name} has an impossible size of {track.Width}×{track.Height}; its pictures cannot be used"));
            }
        }

        private void ReadModes()
        {
            KinectRecordConfiguration configuration = Configuration;
            configuration.HasColor = Color != null;
            configuration.HasDepth = Depth != null;
            configuration.HasInfrared = Infrared != null;
            configuration.HasImu = Imu != null;
            if (Color != null)
            {
                configuration.ColorFormat = Color.Format;
                configuration.ColorWidth = Color.Width;
                configuration.ColorHeight = Color.Height;
                string actual = KinectImageFormats.ModeNameOf(Color.Format, Color.Height);
                string? declared = Tag("K4A_COLOR_MODE");
                ReadRegion(Color);
                if (declared != null && declared != actual)
                    _problems.Add(-1, "tag K4A_COLOR_MODE says " + Printable(declared) + ", the track is " + actual + "; the track counts");
            }

            KinectTrack? depth = Depth ?? Infrared;
            if (depth == null)
                return;
            string? tag = Tag("K4A_DEPTH_MODE");
            configuration.DepthMode = KinectDepthModes.Parse(tag);
            (int width, int height) = KinectDepthModes.SizeOf(configuration.DepthMode);
            if (configuration.DepthMode != KinectDepthMode.Off && width == depth.Width && height == depth.Height)
                return;
            KinectDepthMode bySize = KinectDepthModes.FromSize(depth.Width, depth.Height, Depth != null);
            _problems.Add(-1, Invariant($"tag K4A_DEPTH_MODE says {Printable(tag ?? "nothing")}, the pictures are {depth.Width}×{depth.Height}; taken as {KinectDepthModes.NameOf(bySize)}"));
            configuration.DepthMode = bySize;
        }

        private void ReadRegion(KinectTrack color)
        {
            string? text = Tag(RegionTag);
            if (text == null)
                return;
            if (PixelRegion.TryParse(text, out PixelRegion region) && region.Width == color.Width && region.Height == color.Height)
                Configuration.ColorRegion = region;
            else
                _problems.Add(-1, "tag " + RegionTag + " says " + Printable(text) + ", which is no region of the colour pictures; they are taken as whole");
        }

        private void ReadFrameRate()
        {
            long period = 0;
            foreach (KinectTrack? track in new[] { Color, Depth, Infrared })
            {
                long own = track?.Source.DefaultDurationNs ?? 0;
                if (own < 1000000)
                    continue;
                if (period == 0)
                    period = own;
                else if (own != period)
                    _problems.Add(-1, Invariant($"track {track!.Name} has a frame period of {own} ns, others {period} ns; the latter is used"));
            }

            if (period == 0)
            {
                period = 33333333;
                if (Color != null || Depth != null || Infrared != null)
                    _problems.Add(-1, "no track tells its frame rate; 30 frames a second are assumed");
            }

            Configuration.FramePeriodNs = period;
            Configuration.FramesPerSecond = (int)(1000000000 / period);
        }

        private void ReadDelaysAndSync()
        {
            KinectRecordConfiguration configuration = Configuration;
            DepthDelayNs = ReadNanoseconds("K4A_DEPTH_DELAY_NS", -MaxDelayNs, MaxDelayNs);
            configuration.DepthDelayOffColorUs = DepthDelayNs / 1000;
            configuration.SubordinateDelayOffMasterUs = ReadNanoseconds("K4A_SUBORDINATE_DELAY_NS", 0, MaxDelayNs) / 1000;
            configuration.StartOffsetUs = ReadNanoseconds("K4A_START_OFFSET_NS", 0, long.MaxValue) / 1000;
            string? mode = Tag("K4A_WIRED_SYNC_MODE");
            switch (mode)
            {
                case null:
                case "STANDALONE":
                    break;
                case "MASTER":
                    configuration.WiredSyncMode = KinectWiredSyncMode.Master;
                    break;
                case "SUBORDINATE":
                    configuration.WiredSyncMode = KinectWiredSyncMode.Subordinate;
                    break;
                default:
                    _problems.Add(-1, "tag K4A_WIRED_SYNC_MODE says " + Printable(mode) + "; taken as STANDALONE");
                    break;
            }
        }

        private long ReadNanoseconds(string name, long min, long max)
        {
            string? text = Tag(name);
            if (text == null)
                return 0;
            if (long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long value) && value >= min && value <= max)
                return value;
            _problems.Add(-1, "tag " + name + " says " + Printable(text) + ", which is no usable time; 0 is used");
            return 0;
        }

        private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

        /// <summary>Text from a file, fit for a message of one line.</summary>
        private static string Printable(string text)
        {
            char[] characters = text.Substring(0, Math.Min(text.Length, 40)).ToCharArray();
            for (int i = 0; i < characters.Length; i++)
            {
                if (char.IsControl(characters[i]))
                    characters[i] = '?';
            }

            return "\"" + new string(characters) + "\"";
        }
    }
}
