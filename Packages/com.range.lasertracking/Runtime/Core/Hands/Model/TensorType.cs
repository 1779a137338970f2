namespace LaserTracking.Hands.Model
{
    /// <summary>TensorType of the TensorFlow Lite schema, version 3: those that can be read here.</summary>
    internal enum TensorType
    {
        Float32 = 0,
        Float16 = 1,
        Int32 = 2,
    }
}
