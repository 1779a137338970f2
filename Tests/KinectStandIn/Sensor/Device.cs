// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
using System;
using KinectStandIn;

namespace Microsoft.Azure.Kinect.Sensor
{
    public class Device : IDisposable
    {
        private readonly FakeKinect _kinect;

        internal Device(FakeKinect kinect)
        {
            _kinect = kinect;
        }

        public string SerialNum => _kinect.SerialNumber;

        public static int GetInstalledCount() => FakeKinect.CountConnected();

        public static Device Open(int index = 0) => new Device(FakeKinect.Open(index));

        // The wrapper, too, holds its lock while it waits.
        public Capture GetCapture(TimeSpan timeout)
        {
            lock (this)
                return _kinect.Wait(timeout);
        }

        public int GetColorControl(ColorControlCommand command, out ColorControlMode mode)
        {
            lock (this)
                return _kinect.Get(command, out mode);
        }

        public byte[] GetRawCalibration() => _kinect.RawCalibration;

        public void SetColorControl(ColorControlCommand command, ColorControlMode mode, int value)
        {
            lock (this)
                _kinect.Set(command, mode, value);
        }

        public void StartCameras(DeviceConfiguration configuration)
        {
            lock (this)
                _kinect.Start(configuration);
        }

        public void StopCameras()
        {
            lock (this)
                _kinect.Stop();
        }

        public void Dispose()
        {
            lock (this)
                _kinect.Close();
        }
    }
}
