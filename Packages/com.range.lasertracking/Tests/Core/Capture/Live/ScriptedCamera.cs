using System;
using System.Collections.Generic;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.Live
{
    /// <summary>A camera without a vendor: does what the test says, on a clock of the test's own.</summary>
    internal sealed class ScriptedCamera : ILiveCamera
    {
        public const int IntervalUs = 33_333;

        public long NowUs { get; set; } = 1_000_000;

        /// <summary>From a picture's time to its arrival.</summary>
        public long LatencyUs { get; set; }

        /// <summary>Added to the host's clock gives the device's.</summary>
        public long DeviceOffsetUs { get; set; } = -1_000_000;

        public bool IsConnected { get; set; } = true;

        public bool IsSilent { get; set; }

        public Exception? Failure { get; set; }

        public Dictionary<int, double> Values { get; } = new Dictionary<int, double>();

        /// <summary>By setting: what the camera makes of any value.</summary>
        public Dictionary<int, double> Stubborn { get; } = new Dictionary<int, double>();

        /// <summary>By setting: what pictures say they were taken with.</summary>
        public Dictionary<int, double> Used { get; } = new Dictionary<int, double>();

        public int Opens { get; private set; }

        public int Sets { get; private set; }

        public bool IsOpen { get; private set; }

        public FrameSourceInfo Info { get; } = new FrameSourceInfo("camera A", 4, 2, 30, null);

        public List<CameraSetting> SettingList { get; } = new List<CameraSetting>();

        public IReadOnlyList<CameraSetting> Settings => SettingList;

        public bool TryOpen(out string problem)
        {
            Opens++;
            problem = IsConnected ? "" : "not there; plug it in";
            Values.Clear();
            return IsOpen = IsConnected;
        }

        public LiveReading Read(Frame frame, int timeoutMs, out string problem)
        {
            problem = "";
            if (Failure != null)
                throw Failure;
            NowUs += IsSilent ? timeoutMs * 1000 : IntervalUs;
            if (!IsConnected)
            {
                problem = "lost; check its cable";
                return LiveReading.Lost;
            }

            if (IsSilent)
                return LiveReading.Nothing;
            long timeUs = NowUs - LatencyUs + DeviceOffsetUs;
            frame.Begin(0, timeUs);
            frame.Color.Reset(PixelFormat.Gray8, 4, 2, timeUs);
            return LiveReading.Picture;
        }

        public bool TrySet(CameraSetting setting)
        {
            Sets++;
            Values[setting.Id] = Stubborn.TryGetValue(setting.Id, out double value) ? value : setting.Asked;
            return true;
        }

        public bool TryGet(CameraSetting setting, out double value) => Values.TryGetValue(setting.Id, out value);

        public bool TryGetUsed(CameraSetting setting, out double value) => Used.TryGetValue(setting.Id, out value);

        public void Close() => IsOpen = false;
    }
}
