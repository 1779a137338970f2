namespace LaserTracking.Detection
{
    /// <summary>
    /// The curves of <see cref="DotEvidence"/>, in the order of <see cref="DotFeature"/>. Written by the training that
    /// Documentation~/detector.md describes; not to be edited by hand.
    /// </summary>
    internal static class DotEvidenceCurves
    {
        /// <summary>Log-odds before anything is measured: candidates are many, dots are few.</summary>
        public const double Base = -4.8977;

        public static readonly EvidenceCurve[] All =
        {
            new EvidenceCurve("rise, share of room", RejectionReason.TooFaint,
                new[] { 0.1569f, 0.1765f, 0.1922f, 0.7333f, 0.8275f },
                new[] { -0.532f, -0.191f, -0.01f, 0.022f, 1.023f, 1.199f }),
            new EvidenceCurve("area, px² at 640, logarithm", RejectionReason.TooLarge,
                new[] { 2.079f, 2.197f, 2.565f, 2.708f, 2.833f, 3.555f, 3.829f },
                new[] { 0.578f, 0.436f, 0.338f, 0.261f, 0.051f, -0.27f, -0.46f, -0.54f }),
            new EvidenceCurve("compactness", RejectionReason.NotCompact, new float[0], new[] { 0f }),
            new EvidenceCurve("length / width, logarithm", RejectionReason.TooElongated,
                new[] { 0.2052f, 0.2929f, 0.3541f, 0.4402f, 0.4994f, 0.5735f, 0.6461f, 1.141f, 1.347f, 1.662f },
                new[] { 1.495f, 1.228f, 0.941f, 0.658f, 0.359f, 0.289f, 0.093f, -0.209f, -0.645f, -2.142f, -3.481f }),
            new EvidenceCurve("ring: share risen", RejectionReason.NotIsolated,
                new[] { 0.002778f, 0.00463f, 0.0101f },
                new[] { 0.595f, -0.453f, -0.622f, -0.833f }),
            new EvidenceCurve("brightened around", RejectionReason.MovingSurroundings,
                new[] { 0.0005787f, 0.001773f, 0.02324f, 0.02941f, 0.03704f, 0.2256f },
                new[] { 0.883f, 0.256f, 0.176f, 0.105f, -0.273f, -0.443f, -1.023f }),
            new EvidenceCurve("darkened around", RejectionReason.MovingSurroundings,
                new[] { 0.0005787f, 0.003472f, 0.01253f, 0.01655f },
                new[] { 0.493f, 0.112f, -0.125f, -0.282f, -0.376f }),
            new EvidenceCurve("darkened in the ring", RejectionReason.MovingSurroundings,
                new[] { 0.007576f, 0.1053f },
                new[] { 0.159f, -0.029f, -0.323f }),
            new EvidenceCurve("recent activity", RejectionReason.MovingSurroundings,
                new[] { 0.05417f, 0.1186f, 0.2494f, 0.3587f },
                new[] { 0.226f, 0.193f, -0.072f, -0.277f, -0.721f }),
            new EvidenceCurve("recent activity around", RejectionReason.MovingSurroundings,
                new[] { 0.01388f, 0.07952f, 0.1307f, 0.2279f, 0.2713f, 0.4013f },
                new[] { 1.788f, 1.212f, 0.402f, 0.107f, -0.406f, -1.037f, -1.203f }),
            new EvidenceCurve("new light, share", RejectionReason.NotNew,
                new[] { 1.067f, 1.25f },
                new[] { 0.19f, -0.765f, -0.975f }),
            new EvidenceCurve("vividness", RejectionReason.WrongColor,
                new[] { 0.5326f, 0.7109f, 0.8591f, 0.9851f, 1.527f, 1.774f, 1.998f, 2.411f },
                new[] { -1.87f, -1.705f, -1.025f, -0.515f, 0.124f, 0.157f, 0.36f, 0.658f, 0.73f }),
            new EvidenceCurve("red-green coherence", RejectionReason.WrongColor,
                new[] { 0.8141f, 0.8564f },
                new[] { -0.129f, 0.035f, 0.128f }),
            new EvidenceCurve("above the picture, levels / 64", RejectionReason.TooFaint,
                new[] { -0.9688f, 0f, 0.1875f },
                new[] { -0.302f, -0.413f, 0.847f, 3f }),
            new EvidenceCurve("contrast to the ring", RejectionReason.NotIsolated,
                new[] { 0.5222f, 0.6506f, 0.7187f },
                new[] { -0.475f, -0.279f, 0.165f, 0.199f }),
            new EvidenceCurve("contrast before", RejectionReason.NotNew,
                new[] { -0.8605f, -0.1624f, -0.06026f, 0.2083f, 0.3992f, 0.6758f },
                new[] { 0.124f, 0.013f, 0.062f, 0.168f, 0.103f, -0.127f, -0.215f }),
            new EvidenceCurve("risen around", RejectionReason.NotIsolated,
                new[] { 0.0005342f, 0.01641f, 0.02344f, 0.03345f, 0.05013f },
                new[] { 1.659f, -0.174f, -0.35f, -0.474f, -0.631f, -0.776f }),
            new EvidenceCurve("rise of the other plane", RejectionReason.TooFaint,
                new[] { 0.01961f, 0.09412f, 0.1216f, 0.2706f },
                new[] { -0.517f, -0.382f, -0.132f, 0.183f, 0.388f }),
            new EvidenceCurve("strength, levels·px, logarithm", RejectionReason.TooFaint,
                new[] { 3.535f, 3.638f, 3.764f, 3.922f, 4.096f, 4.334f, 4.617f, 5.801f, 6.093f, 6.344f, 6.829f },
                new[] { -2.681f, -2.323f, -1.527f, -1.04f, -0.28f, 0.379f, 0.909f, 1.386f, 0.855f, 0.44f, -0.323f, -1.001f }),
            new EvidenceCurve("differs from itself turned", RejectionReason.NotCompact,
                new[] { 0.4373f, 0.6059f, 0.7071f, 1.043f, 1.091f, 1.215f },
                new[] { 1.048f, 0.113f, -0.213f, -0.452f, -0.285f, -0.248f, -0.096f }),
        };
    }
}
