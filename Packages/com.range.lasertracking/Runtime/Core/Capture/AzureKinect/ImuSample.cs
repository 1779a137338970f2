namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>One reading of accelerometer and gyroscope, in the sensors' own axes.</summary>
    public struct ImuSample
    {
        /// <summary>Device time in nanoseconds.</summary>
        public ulong AccelerometerTimeNs;

        /// <summary>m/s².</summary>
        public float AccelerationX, AccelerationY, AccelerationZ;

        /// <summary>Device time in nanoseconds.</summary>
        public ulong GyroscopeTimeNs;

        /// <summary>rad/s.</summary>
        public float AngularVelocityX, AngularVelocityY, AngularVelocityZ;
    }
}
