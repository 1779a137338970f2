// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
using System;
using System.Collections.Generic;
using System.Threading;
using OpenCvSharp;

namespace OpenCvStandIn
{
    /// <summary>A webcam in the hands of tests: what it shows, what it refuses, and how it fails.</summary>
    public sealed class FakeWebcam
    {
        private static readonly List<FakeWebcam> All = new List<FakeWebcam>();

        private readonly Dictionary<VideoCaptureProperties, double> _values = new Dictionary<VideoCaptureProperties, double>();
        private int _pictures;

        public FakeWebcam()
        {
            lock (All)
                All.Add(this);
        }

        /// <summary>Thrown by the first call into the library, as when its native part is missing.</summary>
        public static Exception LibraryProblem { get; set; }

        public static int MatsAlive { get; set; }

        public int IntervalMs { get; set; } = 5;

        public bool IsConnected { get; set; } = true;

        public bool IsOpen { get; private set; }

        public VideoCaptureAPIs Backend { get; private set; }

        /// <summary>Properties that it has not got: setting fails, reading gives -1.</summary>
        public ISet<VideoCaptureProperties> Missing { get; } = new HashSet<VideoCaptureProperties>();

        /// <summary>What the exposure becomes in the driver's unit, whatever it is set to; null: what it is set to.</summary>
        public double? StubbornExposure { get; set; }

        public MatType Type { get; set; } = MatType.CV_8UC3;

        /// <summary>The only size it has; null: any.</summary>
        public (int Width, int Height)? OnlySize { get; set; }

        public bool HasTimes { get; set; } = true;

        /// <summary>In the order in which they were set.</summary>
        public List<VideoCaptureProperties> SetLog { get; } = new List<VideoCaptureProperties>();

        public static void Reset()
        {
            lock (All)
                All.Clear();
            LibraryProblem = null;
        }

        public double Value(VideoCaptureProperties property) => _values.TryGetValue(property, out double value) ? value : -1;

        internal static FakeWebcam Open(int index, VideoCaptureAPIs backend)
        {
            lock (All)
            {
                if (index >= All.Count || !All[index].IsConnected || All[index].IsOpen)
                    return null;
                All[index].IsOpen = true;
                All[index].Backend = backend;
                All[index]._values.Clear();
                return All[index];
            }
        }

        internal void Close() => IsOpen = false;

        internal bool Grab()
        {
            if (!IsConnected)
                return false;
            if (IntervalMs > 0)
                Thread.Sleep(IntervalMs);
            _pictures++;
            return true;
        }

        internal bool Retrieve(Mat image)
        {
            image.Fill((int)Get(VideoCaptureProperties.FrameWidth), (int)Get(VideoCaptureProperties.FrameHeight), Type, (byte)_pictures);
            return true;
        }

        internal bool Set(VideoCaptureProperties property, double value)
        {
            SetLog.Add(property);
            if (Missing.Contains(property))
                return false;
            _values[property] = property == VideoCaptureProperties.Exposure ? StubbornExposure ?? value : value;
            return true;
        }

        internal double Get(VideoCaptureProperties property)
        {
            if (property == VideoCaptureProperties.PosMsec)
                return HasTimes ? _pictures * 33.3333 : 0;
            if (OnlySize.HasValue && property == VideoCaptureProperties.FrameWidth)
                return OnlySize.Value.Width;
            if (OnlySize.HasValue && property == VideoCaptureProperties.FrameHeight)
                return OnlySize.Value.Height;
            return Value(property);
        }
    }
}
