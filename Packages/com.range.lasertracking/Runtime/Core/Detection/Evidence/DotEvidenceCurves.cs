namespace LaserTracking.Detection
{
    /// <summary>
    /// The curves of <see cref="DotEvidence"/>, in the order of <see cref="DotFeature"/>. Written by the training that
    /// Documentation~/detector.md describes; not to be edited by hand.
    /// </summary>
    internal static class DotEvidenceCurves
    {
        /// <summary>Log-odds before anything is measured: candidates are many, dots are few.</summary>
        public const double Base = -4.7618;

        public static readonly EvidenceCurve[] All =
        {
            new EvidenceCurve("rise through noise, logarithm", RejectionReason.TooFaint,
                new[] { 2.973f, 3.075f, 3.638f },
                new[] { -0.234f, -0.126f, -0.008f, 0.27f }),
            new EvidenceCurve("rise, share of room", RejectionReason.TooFaint,
                new[] { 0.1608f, 0.1843f, 0.4725f },
                new[] { -0.281f, -0.16f, 0.133f, 0.196f }),
            new EvidenceCurve("area, px² at 640, logarithm", RejectionReason.TooLarge,
                new[] { 2.944f, 3.219f, 3.761f, 4.094f },
                new[] { 0.335f, -0.059f, -0.283f, -0.409f, -0.529f }),
            new EvidenceCurve("compactness", RejectionReason.NotCompact,
                new[] { 0.3654f, 0.9593f },
                new[] { -0.559f, -0.056f, 1.559f }),
            new EvidenceCurve("length / width, logarithm", RejectionReason.TooElongated,
                new[] { 0.2562f, 0.3052f, 0.4402f, 0.5195f, 0.5974f, 1.093f, 1.266f, 1.505f, 1.946f },
                new[] { 1.543f, 1.468f, 0.904f, 0.582f, 0.101f, -0.235f, -0.474f, -1.177f, -2.832f, -3.198f }),
            new EvidenceCurve("ring: share risen", RejectionReason.NotIsolated,
                new[] { 0.0001794f, 0.002778f, 0.0101f, 0.01471f },
                new[] { 1.052f, -0.217f, -0.689f, -0.848f, -1.075f }),
            new EvidenceCurve("brightened around", RejectionReason.MovingSurroundings,
                new[] { 0.000591f, 0.001736f, 0.00463f, 0.02009f, 0.03118f, 0.0396f, 0.05221f },
                new[] { 0.49f, 0.435f, 0.245f, 0.111f, 0.007f, -0.081f, -0.418f, -0.666f }),
            new EvidenceCurve("darkened around", RejectionReason.MovingSurroundings,
                new[] { 0.000591f, 0.002315f, 0.04386f, 0.1456f },
                new[] { 0.635f, 0.159f, -0.103f, -0.518f, -0.743f }),
            new EvidenceCurve("darkened in the ring", RejectionReason.MovingSurroundings,
                new[] { 0.009259f, 0.0463f, 0.2549f },
                new[] { 0.118f, -0.078f, -0.144f, -0.229f }),
            new EvidenceCurve("recent activity", RejectionReason.MovingSurroundings,
                new[] { 0.277f },
                new[] { 0.015f, -0.039f }),
            new EvidenceCurve("recent activity around", RejectionReason.MovingSurroundings,
                new[] { 0.01826f, 0.08351f, 0.1286f, 0.2155f, 0.2594f, 0.3899f },
                new[] { 1.704f, 0.916f, 0.056f, -0.243f, -0.482f, -0.855f, -0.921f }),
            new EvidenceCurve("new light, share", RejectionReason.NotNew,
                new[] { 1.071f },
                new[] { 0.125f, -0.748f }),
            new EvidenceCurve("vividness", RejectionReason.WrongColor,
                new[] { 0.6371f, 0.8271f, 0.9647f, 1.069f, 1.281f, 1.679f, 1.886f, 2.212f },
                new[] { -1.645f, -1.271f, -0.84f, -0.444f, -0.058f, 0.053f, 0.361f, 0.653f, 0.958f }),
            new EvidenceCurve("red-green coherence", RejectionReason.WrongColor,
                new[] { 0.586f, 0.865f, 0.9953f },
                new[] { -0.156f, -0.102f, 0.144f, 0.216f }),
            new EvidenceCurve("above the picture, levels / 64", RejectionReason.TooFaint,
                new[] { 0f, 0.01562f, 0.2344f },
                new[] { -0.241f, 0.639f, 1.307f, 5.731f }),
            new EvidenceCurve("contrast to the ring", RejectionReason.NotIsolated,
                new[] { 0.6995f },
                new[] { -0.083f, 0.036f }),
            new EvidenceCurve("contrast before", RejectionReason.NotNew,
                new[] { -0.09986f },
                new[] { -0.039f, 0.018f }),
            new EvidenceCurve("risen around", RejectionReason.NotIsolated,
                new[] { 0.0004914f, 0.001157f, 0.011f, 0.0161f, 0.03363f },
                new[] { 1.416f, -0.063f, -0.355f, -0.508f, -0.645f, -0.888f }),
            new EvidenceCurve("rise of the other plane", RejectionReason.TooFaint,
                new[] { 0.07451f, 0.09412f },
                new[] { -0.37f, -0.122f, 0.196f }),
            new EvidenceCurve("strength, levels·px, logarithm", RejectionReason.TooFaint,
                new[] { 3.349f, 3.466f, 3.604f, 3.727f, 3.871f, 4.06f, 4.287f, 5.567f, 6.089f, 6.32f, 6.522f },
                new[] { -2.064f, -1.501f, -1.274f, -1.029f, -0.305f, -0.234f, 0.739f, 0.79f, 0.666f, 0.044f, -0.079f, -0.582f }),
        };
    }
}
