using System;
using System.Text;
using NUnit.Framework;

namespace LaserTracking.Capture.Matroska
{
    public sealed class Crc32Tests
    {
        [Test]
        public void Crc32_CheckString_HasThePublishedValue()
        {
            Assert.That(Crc32.Append(0, Encoding.ASCII.GetBytes("123456789")), Is.EqualTo(0xCBF43926u));
        }

        [Test]
        public void Crc32_InPieces_EqualsTheWhole()
        {
            var bytes = new byte[1003];
            new Random(3).NextBytes(bytes);
            uint whole = Crc32.Append(0, bytes);
            for (int cut = 0; cut < 40; cut++)
                Assert.That(Crc32.Append(Crc32.Append(0, bytes.AsSpan(0, cut)), bytes.AsSpan(cut)), Is.EqualTo(whole));
        }
    }
}
