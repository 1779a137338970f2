using System.IO;
using LaserTracking.Host.Studies;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Studies
{
    public sealed class StudyTableTests
    {
        [Test]
        public void StudyTable_NothingToMeasure_IsADashAndNull()
        {
            var table = new StudyTable("title", "name", "error");
            table.Add("few", double.NaN);
            using var text = new StringWriter();
            table.Print(text);
            Assert.That(text.ToString(), Does.Not.Contain("NaN").And.Contain("-"));
            Assert.That(JObject.Parse(table.ToJson())["rows"]![0]!["error"]!.Type, Is.EqualTo(JTokenType.Null));
        }
    }
}
