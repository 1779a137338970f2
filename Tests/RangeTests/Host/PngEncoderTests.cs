using System.Diagnostics;
using System.IO;
using LaserTracking.Host.Pictures;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Host
{
    public sealed class PngEncoderTests
    {
        [Test]
        public void PngEncoder_AnyPicture_IsReadBackByAnotherProgramBitForBit()
        {
            string? ffmpeg = Prerequisites.Locate("ffmpeg");
            if (ffmpeg == null)
                Assert.Ignore("ffmpeg is not installed");
            using var picture = new Image();
            picture.Reset(PixelFormat.Bgra32, 37, 19, 0);
            for (int i = 0; i < picture.SizeBytes; i++)
                picture.Bytes[i] = i % 4 == 3 ? (byte)255 : (byte)(i * 7919 >> 3);
            string file = Path.GetTempFileName();
            try
            {
                File.WriteAllBytes(file, PngEncoder.Encode(picture));
                var start = new ProcessStartInfo(ffmpeg!, $"-loglevel error -f png_pipe -i \"{file}\" -f rawvideo -pix_fmt bgra -") { RedirectStandardOutput = true };
                using Process process = Process.Start(start)!;
                var raw = new MemoryStream();
                process.StandardOutput.BaseStream.CopyTo(raw);
                process.WaitForExit();
                Assert.That(raw.ToArray(), Is.EqualTo(picture.Bytes.ToArray()));
            }
            finally
            {
                File.Delete(file);
            }
        }
    }
}
