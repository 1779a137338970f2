namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>A sensor of the device, with a frame of reference of its own.</summary>
    public enum KinectSensor
    {
        /// <summary>Infrared pictures come from it, too.</summary>
        Depth,
        Color,
        Gyro,
        Accelerometer,
    }
}
