using System.IO;
using NUnit.Framework;

namespace LaserTracking.Capture.Matroska
{
    public sealed class BlockLacingTests
    {
        [TestCase(BlockLacingKind.None, new byte[] { 9, 9, 9 }, new[] { 3 })]
        [TestCase(BlockLacingKind.FixedSize, new byte[] { 2, 1, 1, 2, 2, 3, 3 }, new[] { 2, 2, 2 })]
        [TestCase(BlockLacingKind.Xiph, new byte[] { 2, 1, 2, 1, 2, 2, 3, 3, 3 }, new[] { 1, 2, 3 })]
        [TestCase(BlockLacingKind.Ebml, new byte[] { 2, 0x83, 0xBD, 1, 1, 1, 2, 3, 3 }, new[] { 3, 1, 2 })]
        [TestCase(BlockLacingKind.Ebml, new byte[] { 0, 7, 7 }, new[] { 2 })]
        [TestCase(BlockLacingKind.Xiph, new byte[] { 1, 0, 5 }, new[] { 0, 1 })]
        public void BlockLacing_EachKind_GivesTheFrames(BlockLacingKind kind, byte[] payload, int[] sizes)
        {
            var lacing = new BlockLacing();
            Assert.That(lacing.TrySplit(Reader(payload), Block(kind, payload)), Is.True);
            Assert.That(lacing.Count, Is.EqualTo(sizes.Length));
            long end = payload.Length;
            for (int i = sizes.Length - 1; i >= 0; i--)
            {
                Assert.That(lacing.SizeOf(i), Is.EqualTo(sizes[i]));
                end -= sizes[i];
                Assert.That(lacing.OffsetOf(i), Is.EqualTo(end), "the frames fill the block up to its end");
            }
        }

        [TestCase(BlockLacingKind.FixedSize, new byte[] { })]
        [TestCase(BlockLacingKind.FixedSize, new byte[] { 2, 1, 1, 2, 2 })]
        [TestCase(BlockLacingKind.Xiph, new byte[] { 2, 200, 200, 1 })]
        [TestCase(BlockLacingKind.Xiph, new byte[] { 2, 255, 255, 255 })]
        [TestCase(BlockLacingKind.Xiph, new byte[] { 255, 0 })]
        [TestCase(BlockLacingKind.Ebml, new byte[] { 1, 0x01, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFE, 1 })]
        [TestCase(BlockLacingKind.Ebml, new byte[] { 2, 0x81, 0x80, 1, 1 })]
        [TestCase(BlockLacingKind.Ebml, new byte[] { 1, 0x00, 1 })]
        [TestCase(BlockLacingKind.Ebml, new byte[] { 1, 0xFF, 1 })]
        public void BlockLacing_CountsAndSizesThatLie_AreRefused(BlockLacingKind kind, byte[] payload)
        {
            Assert.That(new BlockLacing().TrySplit(Reader(payload), Block(kind, payload)), Is.False);
        }

        private static EbmlReader Reader(byte[] bytes) => new EbmlReader(new MemoryStream(bytes));

        private static MatroskaBlock Block(BlockLacingKind kind, byte[] payload) =>
            new MatroskaBlock { Lacing = kind, PayloadOffset = 0, PayloadSize = payload.Length };
    }
}
