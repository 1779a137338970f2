namespace LaserTracking.Hands.Model
{
    /// <summary>One tensor as the file describes it.</summary>
    internal sealed class TfLiteTensor
    {
        public TfLiteTensor(TensorType type, int[] shape, int elements, int dataPosition)
        {
            Type = type;
            Shape = shape;
            Elements = elements;
            DataPosition = dataPosition;
        }

        public TensorType Type { get; }

        /// <summary>Each at least 1; activations are batch, height, width, channels with a batch of 1.</summary>
        public int[] Shape { get; }

        /// <summary>Product of <see cref="Shape"/>.</summary>
        public int Elements { get; }

        /// <summary>Where a constant's values lie in the file, all of them within it; 0: computed while the network runs.</summary>
        public int DataPosition { get; }

        public bool IsConstant => DataPosition != 0;
    }
}
