using System;
using System.Runtime.InteropServices;
using NUnit.Framework;

namespace LaserTracking.Patterns
{
    public sealed unsafe class SaddleKernelTests
    {
        [Test]
        public void Kernels_AnyWidth_GiveWhatTheirScalarFormsGive()
        {
            var random = new Random(3);
            ushort** rows = stackalloc ushort*[9];
            for (int width = 1; width < 70; width++)
            {
                var bytes = new byte[9][];
                ushort[][] along = new ushort[9][], alongScalar = new ushort[9][];
                var pins = new GCHandle[9];
                for (int i = 0; i < 9; i++)
                {
                    bytes[i] = new byte[width + 2 * SaddleKernel.Reach];
                    random.NextBytes(bytes[i]);
                    if (i % 3 == 0)
                        Array.Fill(bytes[i], (byte)(width % 2 * 255));
                    along[i] = new ushort[width];
                    alongScalar[i] = new ushort[width];
                    fixed (byte* padded = bytes[i])
                    fixed (ushort* fast = along[i], slow = alongScalar[i])
                    {
                        SaddleKernel.SmoothAlong(padded, width, fast);
                        SaddleKernel.SmoothAlongScalar(padded, 0, width, slow);
                    }

                    Assert.That(along[i], Is.EqualTo(alongScalar[i]), "along, " + width);
                    pins[i] = GCHandle.Alloc(along[i], GCHandleType.Pinned);
                    rows[i] = (ushort*)pins[i].AddrOfPinnedObject();
                }

                ushort[] across = new ushort[width], acrossScalar = new ushort[width];
                int[] response = new int[width], responseScalar = new int[width];
                fixed (ushort* fast = across, slow = acrossScalar)
                fixed (int* fastResponse = response, slowResponse = responseScalar)
                {
                    SaddleKernel.SmoothAcross(rows, width, fast);
                    SaddleKernel.SmoothAcrossScalar(rows, 0, width, slow);
                    SaddleKernel.Respond(rows[3], rows[4], rows[5], width, fastResponse);
                    SaddleKernel.RespondScalar(rows[3], rows[4], rows[5], 1, width, slowResponse);
                }

                foreach (GCHandle pin in pins)
                    pin.Free();
                Assert.That(across, Is.EqualTo(acrossScalar), "across, " + width);
                Assert.That(response, Is.EqualTo(responseScalar), "response, " + width);
            }
        }
    }
}
