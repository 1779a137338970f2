namespace LaserTracking.Hands
{
    /// <summary>Which arm it is, as far as the place where it begins tells. Which hand fires it does not: of two on one weapon either is seen.</summary>
    internal static class ArmSide
    {
        /// <summary>The camera faces the trainee: their right shoulder is on the picture's left. Near the body's middle: unknown.</summary>
        public static HandSide Of(in ArmPart part, DepthHandSettings settings)
        {
            if (!part.HasTorso || !part.HasOneRoot)
                return HandSide.Unknown;
            double offset = part.RootXMm - part.TorsoMm.X, limit = 0.4 * settings.TorsoHalfWidthMm;
            return offset < -limit ? HandSide.Right : offset > limit ? HandSide.Left : HandSide.Unknown;
        }
    }
}
