using System.Collections.Generic;
using System.Linq;
using LaserTracking.Host.Pictures;
using NUnit.Framework;

namespace LaserTracking.Host
{
    public sealed class BitmapFontTests
    {
        [Test]
        public void BitmapFont_EveryLetter_LooksDifferent()
        {
            var seen = new Dictionary<string, char>();
            foreach (char letter in Enumerable.Range(32, 95).Select(i => (char)i).Concat("≤≥×·²√…–±°½"))
            {
                string small = Pixels(letter, false), large = Pixels(letter, true);
                Assert.That(small.Length, Is.EqualTo(BitmapFont.Columns * BitmapFont.Rows));
                Assert.That(large.Length, Is.EqualTo(4 * small.Length));
                Assert.That(small.Contains('#'), Is.EqualTo(letter != ' '), letter.ToString());
                Assert.That(seen.TryAdd(small, letter), Is.True, $"{letter} looks like {seen[small]}");
            }
        }

        [Test]
        public void BitmapFont_UnknownLetter_IsAQuestionMark() => Assert.That(Pixels('☃', true), Is.EqualTo(Pixels('?', true)));

        [Test]
        public void Canvas_DrawingOutside_IsLeftOut()
        {
            using var canvas = new Canvas(20, 10, 0x101010);
            canvas.Text(-300, -5, "far outside to the left", 0xFFFFFF);
            canvas.Outline(-5, -5, 100, 100, 0xFFFFFF);
            canvas.Fill(30, 30, 5, 5, 0xFFFFFF);
            canvas.Fill(5, 5, -3, 4, 0xFFFFFF);
            Assert.That(canvas.Image.Bytes.ToArray().Where((_, i) => i % 4 != 3), Is.All.EqualTo(0x10));
            canvas.Fill(18, 8, 9, 9, 0x203040);
            Assert.That(canvas.Image.Bytes.Slice((9 * 20 + 19) * 4, 4).ToArray(), Is.EqualTo(new byte[] { 0x40, 0x30, 0x20, 0xFF }));
        }

        private static string Pixels(char letter, bool doubled) => string.Concat(BitmapFont.Glyph(letter, doubled).Cast<bool>().Select(on => on ? '#' : '.'));
    }
}
