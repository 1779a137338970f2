namespace LaserTracking.Hands.Model
{
    /// <summary>BuiltinOperator of the TensorFlow Lite schema, version 3: the eight that the hand models use.</summary>
    internal enum OperatorCode
    {
        Add = 0,
        Conv2D = 3,
        DepthwiseConv2D = 4,
        Dequantize = 6,
        FullyConnected = 9,
        Logistic = 14,
        MaxPool2D = 17,
        Mean = 40,
    }
}
