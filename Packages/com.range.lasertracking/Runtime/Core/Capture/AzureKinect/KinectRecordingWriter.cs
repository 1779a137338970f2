using System;
using System.Globalization;
using System.IO;
using LaserTracking.Capture.Matroska;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// Writes frames into a recording as the Azure Kinect recorder does. After every frame everything is in the stream's hands, so that
    /// a program that dies loses none of the frames before. Not thread-safe; allocates nothing per frame once warm.
    /// </summary>
    public sealed class KinectRecordingWriter
    {
        private const long MaxTimeUs = long.MaxValue / 1000;

        private readonly KinectRecordingHead _head;
        private readonly MatroskaHead _file;
        private readonly MatroskaWriter _writer;
        private readonly Block[] _blocks = new Block[3];
        private int _count;
        private long _startUs = -1;

        /// <param name="stream">Writable and seekable, empty; stays the caller's.</param>
        /// <param name="head">Must not be changed afterwards.</param>
        public KinectRecordingWriter(Stream stream, KinectRecordingHead head)
        {
            _head = head;
            _file = head.Build();
            if (_file.Tracks.Count == 0)
                throw new ArgumentException("a recording needs at least one kind of picture", nameof(head));
            _writer = new MatroskaWriter(stream, _file);
        }

        /// <summary>Pictures left out because there is no track for their kind, they have another shape than its first, or an impossible time.</summary>
        public int LeftOut { get; private set; }

        /// <summary>Bytes of the file that are whole.</summary>
        public long WrittenBytes => _writer.WrittenBytes;

        /// <summary>
        /// Writes one frame's pictures, as far as the recording has tracks for them. True when all of those that were there could be written.
        /// </summary>
        /// <param name="frame">Raw pictures.</param>
        /// <param name="jpeg">The frame's colour picture as a JPEG, where the track is of JPEGs.</param>
        /// <exception cref="IOException">The stream refuses: <see cref="FinishAfterFailure"/> saves what is there.</exception>
        public bool Write(Frame frame, ReadOnlySpan<byte> jpeg = default)
        {
            int leftOut = LeftOut;
            _count = 0;
            if (_head.ColorFormat == KinectImageFormat.Mjpg)
                Note(0, jpeg.Length > 0, frame.Color.TimeUs, frame.Color.Width == _head.ColorWidth && frame.Color.Height == _head.ColorHeight, null);
            else
                Note(0, frame.Color, KinectImageFormats.PixelFormatOf(_head.ColorFormat), _head.ColorWidth, _head.ColorHeight);
            Note(1, frame.Depth, PixelFormat.Depth16, _head.DepthWidth, _head.DepthHeight);
            Note(2, frame.Infrared, PixelFormat.Infrared16, _head.InfraredWidth, _head.InfraredHeight);
            for (int i = 0; i < _count; i++)
                Add(_blocks[i], jpeg);
            _writer.Flush();
            return LeftOut == leftOut;
        }

        /// <summary>Completes the file; nothing can be written afterwards.</summary>
        public void Finish() => _writer.Finish();

        /// <summary>Completes the file with what is whole of it, after the stream refused to take more.</summary>
        public void FinishAfterFailure() => _writer.FinishAfterFailure();

        private void Note(int slot, Image image, PixelFormat format, int width, int height) =>
            Note(slot, image.IsPresent, image.TimeUs, image.Format == format && image.Width == width && image.Height == height
                && image.Stride == Image.TightStride(format, width), image);

        /// <summary>Keeps the pictures in order of time.</summary>
        private void Note(int slot, bool isPresent, long timeUs, bool fits, Image? image)
        {
            int track = NumberOf(slot);
            if (!isPresent)
                return;
            if (track == 0 || !fits || timeUs < 0 || timeUs > MaxTimeUs || timeUs < _startUs)
            {
                LeftOut++;
                return;
            }

            int at = _count++;
            for (; at > 0 && _blocks[at - 1].TimeUs > timeUs; at--)
                _blocks[at] = _blocks[at - 1];
            _blocks[at] = new Block { Track = track, TimeUs = timeUs, Image = image };
        }

        private int NumberOf(int slot)
        {
            bool hasColor = _head.ColorFormat != KinectImageFormat.Unknown;
            switch (slot)
            {
                case 0: return hasColor ? 1 : 0;
                case 1: return _head.DepthWidth == 0 ? 0 : hasColor ? 2 : 1;
                default: return _head.InfraredWidth == 0 ? 0 : 1 + (hasColor ? 1 : 0) + (_head.DepthWidth == 0 ? 0 : 1);
            }
        }

        private void Add(in Block block, ReadOnlySpan<byte> jpeg)
        {
            if (_startUs < 0)
            {
                _startUs = block.TimeUs;
                _file.Tags.Add(new MatroskaTag("K4A_START_OFFSET_NS", (_startUs * 1000).ToString(CultureInfo.InvariantCulture), 0, 0));
            }

            ReadOnlySpan<byte> content = block.Image == null ? jpeg : block.Image.Bytes;
            Span<byte> payload = _writer.AddBlock(block.Track, block.TimeUs - _startUs, content.Length);
            content.CopyTo(payload);
            if (block.Image != null && block.Image.Format >= PixelFormat.Depth16)
                ByteOrder.Swap16(payload);
        }

        private struct Block
        {
            public int Track;
            public long TimeUs;
            public Image? Image;
        }
    }
}
