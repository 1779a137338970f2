using NUnit.Framework;

namespace LaserTracking.Capture.Matroska
{
    public sealed class EbmlVarintTests
    {
        [TestCase(new byte[] { 0x81 }, 1, 1)]
        [TestCase(new byte[] { 0x80 }, 0, 1)]
        [TestCase(new byte[] { 0xFE }, 126, 1)]
        [TestCase(new byte[] { 0x40, 0x7F }, 127, 2)]
        [TestCase(new byte[] { 0x10, 0x00, 0x00, 0x02, 0xAA }, 2, 4)]
        [TestCase(new byte[] { 0x01, 0, 0, 0, 0, 0, 0x10, 0x00 }, 4096, 8)]
        [TestCase(new byte[] { 0x01, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFE }, (1L << 56) - 2, 8)]
        [TestCase(new byte[] { 0xFF }, EbmlVarint.UnknownSize, 1)]
        [TestCase(new byte[] { 0x7F, 0xFF }, EbmlVarint.UnknownSize, 2)]
        public void EbmlVarint_Size_IsDecoded(byte[] bytes, long expected, int expectedLength)
        {
            Assert.That(EbmlVarint.TryReadSize(bytes, out long value, out int length), Is.True);
            Assert.That(value, Is.EqualTo(expected));
            Assert.That(length, Is.EqualTo(expectedLength));
        }

        [TestCase(new byte[] { })]
        [TestCase(new byte[] { 0x00, 0x81 })]
        [TestCase(new byte[] { 0x40 })]
        [TestCase(new byte[] { 0x01, 0, 0 })]
        public void EbmlVarint_SizeThatIsNoneOrCut_IsRefused(byte[] bytes)
        {
            Assert.That(EbmlVarint.TryReadSize(bytes, out _, out _), Is.False);
        }

        [Test]
        public void EbmlVarint_Id_KeepsItsMarker()
        {
            Assert.That(EbmlVarint.TryReadId(new byte[] { 0x1A, 0x45, 0xDF, 0xA3, 0x80 }, out uint id, out int length), Is.True);
            Assert.That(id, Is.EqualTo(0x1A45DFA3));
            Assert.That(length, Is.EqualTo(4));
            Assert.That(EbmlVarint.TryReadId(new byte[] { 0x08, 1, 2, 3, 4 }, out _, out _), Is.False, "ids have at most 4 bytes");
        }

        // RFC 9559, table of EBML lacing sizes: one byte reaches from -63 to 63, two from -8191 to 8191.
        [TestCase(new byte[] { 0x80 }, -63)]
        [TestCase(new byte[] { 0xBF }, 0)]
        [TestCase(new byte[] { 0xFE }, 63)]
        [TestCase(new byte[] { 0x40, 0x00 }, -8191)]
        [TestCase(new byte[] { 0x5F, 0xFF }, 0)]
        [TestCase(new byte[] { 0x7F, 0xFE }, 8191)]
        public void EbmlVarint_SignedDifference_IsDecoded(byte[] bytes, long expected)
        {
            Assert.That(EbmlVarint.TryReadSigned(bytes, out long value, out _), Is.True);
            Assert.That(value, Is.EqualTo(expected));
        }
    }
}
