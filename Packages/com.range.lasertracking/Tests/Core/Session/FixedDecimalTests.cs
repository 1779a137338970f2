using System;
using System.Globalization;
using System.Text;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class FixedDecimalTests
    {
        [TestCase(0, 3, "0")]
        [TestCase(-0.0, 3, "0")]
        [TestCase(301.42, 4, "301.42")]
        [TestCase(288.10, 2, "288.1")]
        [TestCase(-0.00004, 4, "0")]
        [TestCase(-0.00006, 4, "-0.0001")]
        [TestCase(0.05, 3, "0.05")]
        [TestCase(1.9999, 3, "2")]
        [TestCase(0.125, 2, "0.12")]
        [TestCase(0.375, 2, "0.38")]
        [TestCase(100, 0, "100")]
        [TestCase(1e15, 4, "1000000000000000")]
        [TestCase(1234567890123.5, 9, "1234567890123.5")]
        [TestCase(-9e18, 9, "-9000000000000000000")]
        public void Write_Number_GivesItsShortestFixedText(double value, int decimals, string expected)
        {
            Assert.That(Text(value, decimals), Is.EqualTo(expected));
        }

        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        [TestCase(double.NegativeInfinity)]
        [TestCase(1e19)]
        [TestCase(double.MaxValue)]
        public void Write_WithoutPlainText_WritesNothing(double value)
        {
            Assert.That(Text(value, 3), Is.Empty);
        }

        [TestCase(0L, "0")]
        [TestCase(-1L, "-1")]
        [TestCase(long.MaxValue, "9223372036854775807")]
        [TestCase(long.MinValue, "-9223372036854775808")]
        public void Write_WholeNumber_GivesAllDigits(long value, string expected)
        {
            var bytes = new byte[FixedDecimal.MaximumLength];
            Assert.That(Encoding.ASCII.GetString(bytes, 0, FixedDecimal.Write(value, bytes)), Is.EqualTo(expected));
        }

        [Test]
        public void Write_RandomNumbers_ReadBackWithinHalfAStep()
        {
            var random = new Random(4);
            for (int i = 0; i < 20000; i++)
            {
                int decimals = random.Next(10);
                double value = (random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-6, 7));
                double back = double.Parse(Text(value, decimals), CultureInfo.InvariantCulture);
                Assert.That(Math.Abs(back - value), Is.LessThanOrEqualTo(0.5000001 * Math.Pow(10, -decimals) + 1e-15 * Math.Abs(value)));
            }
        }

        private static string Text(double value, int decimals)
        {
            var bytes = new byte[FixedDecimal.MaximumLength];
            return Encoding.ASCII.GetString(bytes, 0, FixedDecimal.Write(value, decimals, bytes));
        }
    }
}
