using System;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Decodes one JPEG into a raw picture. False, with the reason in one line, when it cannot; the target is then undefined.</summary>
    public delegate bool JpegImageDecoder(ReadOnlySpan<byte> jpeg, Image target, long timeUs, out string problem);
}
