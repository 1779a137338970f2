using System;
using NUnit.Framework;

namespace LaserTracking.Patterns
{
    public sealed class BoardSizeTests
    {
        [TestCase("9x6", 9, 6)]
        [TestCase("8X6", 8, 6)]
        [TestCase("3×50", 3, 50)]
        public void TryParse_ColumnsAndRows_AreRead(string text, int columns, int rows)
        {
            Assert.That(BoardSize.TryParse(text, out BoardSize size), Is.True);
            Assert.That(size, Is.EqualTo(new BoardSize(columns, rows)));
            Assert.That(size.Count, Is.EqualTo(columns * rows));
            Assert.That(size.ToString(), Is.EqualTo(columns + "×" + rows));
        }

        [TestCase("")]
        [TestCase("9")]
        [TestCase("9x")]
        [TestCase("9x6x2")]
        [TestCase("-9x6")]
        [TestCase("9.5x6")]
        [TestCase(" 9x6")]
        [TestCase("2x6")]
        [TestCase("9x51")]
        [TestCase("99999999999x6")]
        public void TryParse_AnythingElse_IsRefused(string text) => Assert.That(BoardSize.TryParse(text, out _), Is.False);

        [TestCase(2, 6)]
        [TestCase(9, 51)]
        public void Constructor_SizesThatNoBoardHas_Throw(int columns, int rows) =>
            Assert.Throws<ArgumentOutOfRangeException>(() => new BoardSize(columns, rows));

        [TestCase(9, 6, false)]
        [TestCase(8, 6, true)]
        [TestCase(7, 5, true)]
        public void IsSymmetric_IsWhereHalfATurnChangesNothing(int columns, int rows, bool expected) =>
            Assert.That(new BoardSize(columns, rows).IsSymmetric, Is.EqualTo(expected));
    }
}
