using System;
using System.IO;
using System.Threading;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.Recording
{
    /// <summary>
    /// Records frames while they are processed elsewhere: copies each into a bounded queue that a thread of its own writes into an
    /// Azure Kinect recording. A disk that does not keep up costs frames of the recording, which are counted, never the caller's time.
    /// <see cref="Add"/> from one thread at a time; the figures from any. No allocation per frame once warm.
    /// </summary>
    public sealed class FrameRecorder : IDisposable
    {
        private readonly FrameRecorderSettings _settings;
        private readonly FileStream? _file;
        private readonly Stream _stream;
        private readonly string _name;
        private readonly Frame[] _ring;
        private readonly JpegEncoder? _jpeg;
        private readonly object _lock = new object();
        private readonly Thread _thread;
        private KinectRecordingWriter? _writer;
        private int _first;
        private int _count;
        private bool _isStopping;
        private bool _isAdding;
        private string _problem = "";
        private long _recorded;
        private long _dropped;
        private long _bytes;
        private long _leftOut;
        private long _misfits;

        /// <param name="path">File to write; its folder is made. Nothing is ever overwritten.</param>
        /// <param name="settings">Must not be changed afterwards.</param>
        /// <exception cref="InputException">The file exists or cannot be written.</exception>
        public FrameRecorder(string path, FrameRecorderSettings settings)
            : this(RecordingStream.Create(path), path, settings)
        {
        }

        /// <summary>For tests: into any stream, which is disposed.</summary>
        internal FrameRecorder(Stream stream, string name, FrameRecorderSettings settings)
        {
            settings.Validate();
            _settings = settings;
            _stream = stream;
            _file = stream as FileStream;
            _name = name;
            _ring = new Frame[settings.QueueLength];
            for (int i = 0; i < _ring.Length; i++)
                _ring[i] = new Frame();
            _jpeg = settings.JpegQuality > 0 ? new JpegEncoder(settings.JpegQuality) : null;
            _thread = new Thread(WriteAll) { IsBackground = true, Name = "recorder of " + Path.GetFileName(name) };
            _thread.Start();
        }

        /// <summary>Frames in the file.</summary>
        public long RecordedFrames => Interlocked.Read(ref _recorded);

        /// <summary>Frames that found the queue full, or came after the recording had ended.</summary>
        public long DroppedFrames => Interlocked.Read(ref _dropped);

        /// <summary>What a recording cannot hold: frames without a picture, pictures of another size or format than the first frame's.</summary>
        public long LeftOutPictures => Interlocked.Read(ref _leftOut) + Interlocked.Read(ref _misfits);

        /// <summary>Size of the file so far, bytes.</summary>
        public long WrittenBytes => Interlocked.Read(ref _bytes);

        /// <summary>Why the recording ended before it was stopped, one line with what to do; empty: it did not.</summary>
        public string Problem => Volatile.Read(ref _problem);

        /// <summary>Takes a copy of the frame. False when it was dropped, or has no picture that can be recorded.</summary>
        public bool Add(Frame frame)
        {
            Frame slot;
            lock (_lock)
            {
                while (_settings.WaitsWhenFull && _count == _ring.Length && !HasEnded)
                    Monitor.Wait(_lock);
                if (_count == _ring.Length || HasEnded)
                {
                    Interlocked.Increment(ref _dropped);
                    return false;
                }

                slot = _ring[(_first + _count) % _ring.Length];
                _isAdding = true;
            }

            // Outside the lock: the writer never touches slots beyond _count.
            Copy(frame, slot);
            bool hasPicture = slot.Color.IsPresent || slot.Depth.IsPresent || slot.Infrared.IsPresent;
            if (!hasPicture)
                Interlocked.Increment(ref _misfits);
            lock (_lock)
            {
                _isAdding = false;
                _count += hasPicture ? 1 : 0;
                Monitor.PulseAll(_lock);
            }

            return hasPicture;
        }

        /// <summary>Writes what waits, completes the file and closes it; by any thread. A file without a single frame is deleted.</summary>
        public void Dispose()
        {
            lock (_lock)
            {
                if (_isStopping)
                    return;
                _isStopping = true;
                while (_isAdding)
                    Monitor.Wait(_lock);
                Monitor.PulseAll(_lock);
            }

            _thread.Join();
            foreach (Frame frame in _ring)
                frame.Dispose();
            try
            {
                _stream.Dispose();
                if (_file != null && RecordedFrames == 0)
                    File.Delete(_file.Name);
            }
            catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException)
            {
                Fail(problem.Message);
            }
        }

        private bool HasEnded => _isStopping || _problem.Length > 0;

        private void Copy(Frame frame, Frame slot)
        {
            slot.Begin(frame.Index, frame.TimeUs);
            if ((_settings.Streams & KinectStreams.Depth) != 0)
                slot.Depth.CopyTightFrom(frame.Depth);
            if ((_settings.Streams & KinectStreams.Infrared) != 0)
                slot.Infrared.CopyTightFrom(frame.Infrared);
            if ((_settings.Streams & KinectStreams.Color) == 0 || !frame.Color.IsPresent)
                return;
            if (!(_settings.Region is PixelRegion region))
                slot.Color.CopyTightFrom(frame.Color);
            else if (frame.Color.Width == region.FullWidth && frame.Color.Height == region.FullHeight)
                region.Crop(frame.Color, slot.Color);
            else if (slot.Depth.IsPresent || slot.Infrared.IsPresent)
                Interlocked.Increment(ref _misfits);
        }

        private void WriteAll()
        {
            try
            {
                while (TryTake(out Frame frame))
                {
                    Write(frame);
                    lock (_lock)
                    {
                        _first = (_first + 1) % _ring.Length;
                        _count--;
                        Monitor.PulseAll(_lock);
                    }
                }

                _writer?.Finish();
                Interlocked.Exchange(ref _bytes, _writer?.WrittenBytes ?? 0);
                _file?.Flush(true);
            }
            catch (Exception problem)
            {
                Fail(problem.Message);
                TryFinishAfterFailure();
            }
        }

        private bool TryTake(out Frame frame)
        {
            lock (_lock)
            {
                while (_count == 0 && !_isStopping)
                    Monitor.Wait(_lock);
                frame = _ring[_first];
                return _count > 0;
            }
        }

        private void Write(Frame frame)
        {
            _writer ??= Begin(frame);
            bool isJpeg = _jpeg != null && frame.Color.IsPresent;
            _writer.Write(frame, isJpeg ? _jpeg!.Encode(frame.Color) : default);
            Interlocked.Increment(ref _recorded);
            Interlocked.Exchange(ref _bytes, _writer.WrittenBytes);
            Interlocked.Exchange(ref _leftOut, _writer.LeftOut);
        }

        private KinectRecordingWriter Begin(Frame frame)
        {
            KinectRecordingHead head = KinectRecordingHead.Of(frame, _settings.Streams, _settings.FramesPerSecond);
            if (head.ColorFormat == KinectImageFormat.Unknown && head.DepthWidth == 0 && head.InfraredWidth == 0)
                throw new InvalidDataException("the first frame has no picture of a format that can be recorded");
            if (_jpeg != null && head.ColorFormat != KinectImageFormat.Unknown)
                head.ColorFormat = KinectImageFormat.Mjpg;
            head.ColorRegion = _settings.Region;
            head.DeviceCalibration = _settings.DeviceCalibration?.Invoke();
            head.SerialNumber = _settings.SerialNumber;
            return new KinectRecordingWriter(_stream, head);
        }

        private void Fail(string why)
        {
            lock (_lock)
            {
                if (_problem.Length == 0)
                {
                    Volatile.Write(ref _problem, _name + ": the recording ends after " + RecordedFrames + " frames ("
                        + why.Replace('\n', ' ').Replace("\r", "").TrimEnd('.') + "); make room or choose another place, and record again");
                }

                Monitor.PulseAll(_lock);
            }
        }

        private void TryFinishAfterFailure()
        {
            try
            {
                _writer?.FinishAfterFailure();
            }
            catch (Exception problem) when (problem is IOException || problem is NotSupportedException || problem is UnauthorizedAccessException)
            {
                // The file stays open-ended: it reads to the last whole frame all the same.
            }
        }
    }
}
