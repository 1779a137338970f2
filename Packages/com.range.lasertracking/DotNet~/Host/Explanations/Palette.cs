namespace LaserTracking.Host.Explanations
{
    /// <summary>Colours of explanations, 0xRRGGBB: told apart also by people who see red and green alike (they differ in brightness).</summary>
    internal static class Palette
    {
        public const uint Background = 0x14171C;
        public const uint Panel = 0x1E232B;
        public const uint Text = 0xE8ECF2;
        public const uint Quiet = 0x95A0AF;
        public const uint Passed = 0x7FB8A4;
        public const uint Failed = 0xFF7A59;
        public const uint Shot = 0x5CF28C;
        public const uint Dot = 0x57C7FF;
        public const uint Waiting = 0xFFD84D;
        public const uint Asked = 0xFF6BD6;

        public static uint Of(CandidateState state) => state switch
        {
            CandidateState.Shot => Shot,
            CandidateState.Dot => Dot,
            CandidateState.Waiting => Waiting,
            _ => Failed,
        };

        /// <summary>Black over blue and orange to near white: brighter is more, in grey too.</summary>
        public static uint Heat(int value)
        {
            int red = System.Math.Clamp((value - 40) * 255 / 130, 0, 255), green = System.Math.Clamp((value - 110) * 255 / 145, 0, 255);
            int blue = value < 70 ? value * 2 : value < 150 ? System.Math.Max(30, 140 - (value - 70) * 2) : 30 + (value - 150) * 2;
            return (uint)(red << 16 | green << 8 | System.Math.Clamp(blue, 0, 255));
        }
    }
}
