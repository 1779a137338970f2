namespace LaserTracking.Detection
{
    /// <summary>
    /// The curves of <see cref="DotEvidence"/>, in the order of <see cref="DotFeature"/>. Written by the training that
    /// Documentation~/detector.md describes; not to be edited by hand.
    /// </summary>
    internal static class DotEvidenceCurves
    {
        /// <summary>Log-odds before anything is measured: candidates are many, dots are few.</summary>
        public const double Base = -4.9276;

        public static readonly EvidenceCurve[] All =
        {
            new EvidenceCurve("rise, share of room", RejectionReason.TooFaint,
                new[] { 0.1412f, 0.1569f, 0.1686f, 0.1765f, 0.1922f, 0.7373f, 0.8275f },
                new[] { -0.438f, -0.399f, -0.156f, -0.114f, -0.04f, 0.044f, 0.615f, 1.028f }),
            new EvidenceCurve("area, px² at 640, logarithm", RejectionReason.TooLarge,
                new[] { 2.079f, 2.303f, 2.708f, 2.89f, 3.85f },
                new[] { 0.554f, 0.472f, 0.349f, -0.122f, -0.337f, -0.492f }),
            new EvidenceCurve("compactness", RejectionReason.NotCompact, new float[0], new[] { 0f }),
            new EvidenceCurve("length / width, logarithm", RejectionReason.TooElongated,
                new[] { 0.2012f, 0.2929f, 0.3444f, 0.4293f, 0.4402f, 0.5664f, 0.6393f, 1.135f, 1.347f, 1.668f },
                new[] { 1.545f, 1.339f, 0.97f, 0.673f, 0.424f, 0.232f, 0.019f, -0.193f, -0.656f, -2.168f, -3.544f }),
            new EvidenceCurve("ring: share risen", RejectionReason.NotIsolated,
                new[] { 0.002778f, 0.00463f, 0.01042f },
                new[] { 0.616f, -0.614f, -0.751f, -0.84f }),
            new EvidenceCurve("brightened around", RejectionReason.MovingSurroundings,
                new[] { 0.0005787f, 0.01035f, 0.02213f, 0.02836f, 0.0461f, 0.2262f },
                new[] { 0.885f, 0.277f, 0.201f, 0.052f, -0.196f, -0.526f, -1.124f }),
            new EvidenceCurve("darkened around", RejectionReason.MovingSurroundings,
                new[] { 0.0005787f, 0.002315f, 0.04422f, 0.2014f },
                new[] { 0.367f, 0.026f, -0.189f, -0.224f, -0.281f }),
            new EvidenceCurve("darkened in the ring", RejectionReason.MovingSurroundings,
                new[] { 0.007576f, 0.01042f, 0.1053f },
                new[] { 0.193f, 0.025f, -0.096f, -0.336f }),
            new EvidenceCurve("recent activity", RejectionReason.MovingSurroundings,
                new[] { 0.05215f, 0.1185f, 0.2479f, 0.2819f, 0.3571f },
                new[] { 0.276f, 0.129f, -0.031f, -0.431f, -0.516f, -0.762f }),
            new EvidenceCurve("recent activity around", RejectionReason.MovingSurroundings,
                new[] { 0.01303f, 0.0767f, 0.1285f, 0.1806f, 0.2276f, 0.2712f, 0.3178f },
                new[] { 1.857f, 1.123f, 0.336f, 0.052f, -0.204f, -0.446f, -0.881f, -1.067f }),
            new EvidenceCurve("new light, share", RejectionReason.NotNew,
                new[] { 1.066f },
                new[] { 0.193f, -0.926f }),
            new EvidenceCurve("vividness", RejectionReason.WrongColor,
                new[] { 0.5573f, 0.7233f, 0.8834f, 1.004f, 1.535f, 1.791f, 2.015f },
                new[] { -1.881f, -1.826f, -1.295f, -0.187f, 0.16f, 0.323f, 0.576f, 0.654f }),
            new EvidenceCurve("red-green coherence", RejectionReason.WrongColor,
                new[] { 0.7674f, 0.8224f, 0.8632f },
                new[] { -0.15f, -0.064f, 0.041f, 0.148f }),
            new EvidenceCurve("above the picture, levels / 64", RejectionReason.TooFaint,
                new[] { 0f, 0.0625f, 0.2031f },
                new[] { -0.41f, 0.733f, 1.687f, 3f }),
            new EvidenceCurve("contrast to the ring", RejectionReason.NotIsolated,
                new[] { 0.5008f, 0.6409f },
                new[] { -0.595f, -0.492f, 0.247f }),
            new EvidenceCurve("contrast before", RejectionReason.NotNew,
                new[] { -0.9045f, 0.2126f, 0.4172f },
                new[] { 0.261f, 0.077f, -0.087f, -0.183f }),
            new EvidenceCurve("risen around", RejectionReason.NotIsolated,
                new[] { 0.0005556f, 0.01655f, 0.04898f },
                new[] { 1.629f, -0.175f, -0.55f, -0.646f }),
            new EvidenceCurve("rise of the other plane", RejectionReason.TooFaint,
                new[] { 0.0902f, 0.1176f, 0.1529f, 0.2745f },
                new[] { -0.352f, -0.156f, 0.064f, 0.169f, 0.319f }),
            new EvidenceCurve("strength, levels·px, logarithm", RejectionReason.TooFaint,
                new[] { 3.636f, 3.748f, 3.912f, 4.094f, 4.356f, 4.637f, 4.91f, 5.84f, 6.11f, 6.365f, 6.569f, 6.838f },
                new[] { -2.875f, -2.004f, -0.967f, -0.426f, 0.469f, 0.986f, 1.334f, 1.438f, 0.677f, 0.426f, 0.098f, -0.385f, -0.783f }),
            new EvidenceCurve("differs from itself turned", RejectionReason.NotCompact,
                new[] { 0.4324f, 0.603f, 0.7035f, 1.007f, 1.054f },
                new[] { 1.081f, 0.138f, -0.189f, -0.417f, -0.297f, -0.213f }),
        };
    }
}
