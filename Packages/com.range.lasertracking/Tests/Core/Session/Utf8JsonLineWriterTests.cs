using System.Text;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class Utf8JsonLineWriterTests
    {
        [TestCase("plain", "\"plain\"")]
        [TestCase("", "\"\"")]
        [TestCase(null, "null")]
        [TestCase("say \"hi\" C:\\x", "\"say \\\"hi\\\" C:\\\\x\"")]
        [TestCase("a\nb\rc\td\be\ff", "\"a\\nb\\rc\\td\\be\\ff\"")]
        [TestCase("\u0000\u0001\u001f\u007f", "\"\\u0000\\u0001\\u001f\u007f\"")]
        [TestCase("Scheibe Ä €", "\"Scheibe Ä €\"")]
        [TestCase("\uD83C\uDFAF", "\"\uD83C\uDFAF\"")]
        [TestCase("</script>", "\"</script>\"")]
        public void Text_AnyString_IsEscapedAsJsonWants(string value, string expected)
        {
            var json = new Utf8JsonLineWriter(1);
            json.Text(value);
            Assert.That(Encoding.UTF8.GetString(json.Written.ToArray()), Is.EqualTo(expected));
        }

        [Test]
        public void Text_LoneSurrogates_BecomeReplacementCharacters()
        {
            var json = new Utf8JsonLineWriter(1);
            json.Text("x\uD83Cy\uDFAF");
            Assert.That(Encoding.UTF8.GetString(json.Written.ToArray()), Is.EqualTo("\"x\uFFFDy\uFFFD\""));
        }

        [Test]
        public void Writer_NestedValues_SeparatesThemWithCommas()
        {
            var json = new Utf8JsonLineWriter(1);
            json.BeginObject();
            json.Name("a");
            json.BeginArray();
            json.BeginObject();
            json.EndObject();
            json.Number(1);
            json.Number(double.NaN, 2);
            json.Null();
            json.EndArray();
            json.Name("b");
            json.Vector(new Vector2D(1.5, double.PositiveInfinity), 1);
            json.Name("c");
            json.Vector(new Vector3D(1.25, -2, 0), 1);
            json.Name("d");
            json.Text("x");
            json.EndObject();
            json.EndLine();
            json.BeginObject();
            json.EndObject();
            json.EndLine();
            Assert.That(Encoding.UTF8.GetString(json.Written.ToArray()),
                Is.EqualTo("{\"a\":[{},1,null,null],\"b\":null,\"c\":[1.2,-2,0],\"d\":\"x\"}\n{}\n"));
        }
    }
}
