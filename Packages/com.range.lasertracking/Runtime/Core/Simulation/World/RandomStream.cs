namespace LaserTracking.Simulation
{
    /// <summary>What a random number is for. Numbers of different streams are independent; never renumber.</summary>
    internal enum RandomStream
    {
        ColorNoise = 1,
        ColorDrop = 2,
        DepthNoise = 3,
        DepthDrop = 4,
        LostPalm = 5,
        Tremor = 6,
        AimError = 7,
        Boresight = 8,
        Generator = 9,
        Speckle = 10,
        Texture = 11,
        Content = 12,
        InfraredNoise = 21,
        BoardNoise = 31,
    }
}
