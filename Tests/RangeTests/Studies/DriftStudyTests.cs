using System.Linq;
using LaserTracking.Host.Studies;
using LaserTracking.Host.Studies.Drift;
using LaserTracking.Host.Terminal;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Studies
{
    public sealed class DriftStudyTests
    {
        [TestCase(DrawnSessions.RoomJumps, false)]
        [TestCase(DrawnSessions.Knock, true)]
        public void DriftStudy_OneSeed_CountsWhatIsSaid(string row, bool moves)
        {
            using var progress = new ProgressLine();
            JToken found = JObject.Parse(new DriftStudy().Run(new StudyOptions(2, 2, progress, row), default).ToJson())["rows"]!.First();
            Assert.That((int)found["sessions"]!, Is.EqualTo(1));
            Assert.That((int)found["called moved without need"]!["count"]!, Is.Zero);
            Assert.That((int)found["moved: noticed in 5 s"]!["count"]!, Is.EqualTo(moves ? 1 : 0));
            Assert.That((int)found["way and length right"]!["of"]!, Is.EqualTo(moves ? 1 : 0));
        }
    }
}
