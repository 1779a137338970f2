using System;
using System.Text;
using NUnit.Framework;

namespace LaserTracking.Remote
{
    public sealed class Utf8JsonTextTests
    {
        [Test]
        public void Utf8_RandomBytes_AreJudgedAsByTheRuntime()
        {
            var random = new Random(1);
            var strict = new UTF8Encoding(false, true);
            int valid = 0;
            for (int i = 0; i < 20000; i++)
            {
                var bytes = new byte[random.Next(1, 5)];
                random.NextBytes(bytes);
                // Mostly bytes at the borders of what may follow what.
                byte[] borders = { 0x7F, 0x80, 0x8F, 0x90, 0x9F, 0xA0, 0xBF, 0xC1, 0xC2, 0xDF, 0xE0, 0xED, 0xEF, 0xF0, 0xF4, 0xF5 };
                for (int k = 0; k < bytes.Length; k++)
                    bytes[k] = random.Next(4) == 0 ? bytes[k] : borders[random.Next(borders.Length)];
                bool expected = true;
                try
                {
                    strict.GetCharCount(bytes);
                    valid++;
                }
                catch (DecoderFallbackException)
                {
                    expected = false;
                }

                Assert.That(Utf8JsonText.IsUtf8(bytes), Is.EqualTo(expected), BitConverter.ToString(bytes));
            }

            Assert.That(valid, Is.GreaterThan(500));
        }

        [TestCase("{}")]
        [TestCase(" {\"a\" : [ 1 , -0.5e+3, true,false,null , \"\\u00e9\\n\" ] , \"b\":{} }\n")]
        [TestCase("{\"a\":[[[]]]}")]
        [TestCase("{\"ä\":0}")]
        public void Json_WellFormedObject_IsOne(string text) => Assert.That(Utf8JsonText.IsObject(Encoding.UTF8.GetBytes(text), 8), Is.True);

        [TestCase("")]
        [TestCase("[]")]
        [TestCase("1")]
        [TestCase("{")]
        [TestCase("{\"a\"}")]
        [TestCase("{\"a\":}")]
        [TestCase("{\"a\":1,}")]
        [TestCase("{,}")]
        [TestCase("{\"a\":[1,]}")]
        [TestCase("{\"a\":[1}")]
        [TestCase("{\"a\":NaN}")]
        [TestCase("{\"a\":Infinity}")]
        [TestCase("{\"a\":-Infinity}")]
        [TestCase("{\"a\":01}")]
        [TestCase("{\"a\":+1}")]
        [TestCase("{\"a\":1.}")]
        [TestCase("{\"a\":.5}")]
        [TestCase("{\"a\":1e}")]
        [TestCase("{\"a\":-}")]
        [TestCase("{\"a\":0x10}")]
        [TestCase("{'a':1}")]
        [TestCase("{a:1}")]
        [TestCase("{\"a\":1}x")]
        [TestCase("{\"a\":1}{}")]
        [TestCase("{\"a\":1/**/}")]
        [TestCase("{\"a\":\"\\x\"}")]
        [TestCase("{\"a\":\"\\u12g4\"}")]
        [TestCase("{\"a\":\"\\u12")]
        [TestCase("{\"a\":\"\t\"}")]
        [TestCase("{\"a\":\"")]
        [TestCase("{\"a\":\"\\")]
        [TestCase("{\"a\":tru}")]
        [TestCase("{\"a\":[[[[[[[[1]]]]]]]]}")]
        public void Json_AnythingElse_IsNot(string text) => Assert.That(Utf8JsonText.IsObject(Encoding.UTF8.GetBytes(text), 8), Is.False);
    }
}
