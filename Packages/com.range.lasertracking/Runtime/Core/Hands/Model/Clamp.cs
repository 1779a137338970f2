namespace LaserTracking.Hands.Model
{
    /// <summary>A fused activation: none, ReLU or ReLU6 are limits to both sides.</summary>
    internal readonly struct Clamp
    {
        public Clamp(float low, float high)
        {
            Low = low;
            High = high;
        }

        public float Low { get; }

        public float High { get; }

        /// <param name="activation">ActivationFunctionType of the schema.</param>
        /// <param name="clamp">Its limits; infinite for none.</param>
        /// <returns>False for those that are no limits.</returns>
        public static bool TryCreate(int activation, out Clamp clamp)
        {
            clamp = new Clamp(activation == 0 ? float.NegativeInfinity : 0, activation == 3 ? 6 : float.PositiveInfinity);
            return activation == 0 || activation == 1 || activation == 3;
        }
    }
}
