using System.IO;
using System.Text;
using LaserTracking.Host.Events;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class EventReaderTests
    {
        private const string Header = "{\"type\":\"header\",\"v\":1,\"tool\":\"range\",\"version\":\"0.1.0\",\"inputs\":[{\"path\":\"a.mkv\",\"sha256\":null}],\"calibration\":null,\"detector\":\"shots\",\"seed\":7}\n";

        private const string Shot =
            "{\"type\":\"shot\",\"id\":7,\"frame\":412,\"first_frame\":411,\"last_frame\":413,\"time_us\":13733333,\"time_sigma_us\":16667," +
            "\"x_px\":301.42,\"y_px\":288.1,\"sigma_px\":0.11,\"cov_px\":[0.0121,0.0004,0.0121],\"peak\":255,\"area_px\":31," +
            "\"color\":\"green\",\"confidence\":0.91,\"factors\":{\"peak\":0.38,\"contrast\":0.27,\"center\":0.17,\"stability\":0.09},\"streak_px\":[3.5,-1.25]," +
            "\"screen_m\":[1.204,0.871],\"screen_cov_mm2\":[1.9,0.1,2.3],\"shooter\":2,\"shooter_p\":0.97,\"hand\":\"right\",\"muzzle_m\":[1.1,1.3,-2.75],\"direction\":[0.0367,-0.1515,0.98777],\"pair_dt_us\":-8300," +
            "\"hit\":{\"target\":\"Popper \\\"3\\\" ü\",\"zone\":\"A\",\"points\":5,\"point_m\":[0.5,1.25,7.2],\"distance_m\":7.2,\"p_zone\":0.93,\"score\":4.41,\"local_m\":[0.031,-0.02]}}\n";

        private const string PlainShot =
            "{\"type\":\"shot\",\"id\":8,\"frame\":1,\"first_frame\":1,\"last_frame\":1,\"time_us\":13733334,\"time_sigma_us\":0," +
            "\"x_px\":1,\"y_px\":2,\"sigma_px\":0,\"cov_px\":[0,0,0],\"peak\":0,\"area_px\":0,\"color\":\"unknown\",\"confidence\":0,\"factors\":{\"peak\":0,\"contrast\":0,\"center\":0,\"stability\":0},\"streak_px\":[0,0]," +
            "\"screen_m\":null,\"screen_cov_mm2\":null,\"shooter\":null,\"shooter_p\":null,\"hand\":null,\"muzzle_m\":null,\"direction\":null,\"pair_dt_us\":null,\"hit\":null}\n";

        private const string Rest =
            "{\"type\":\"dot\",\"frame\":412,\"time_us\":13800000,\"track\":3,\"x_px\":301.42,\"y_px\":288.1,\"sigma_px\":0.11,\"color\":\"red\",\"shooter\":1}\n" +
            "{\"type\":\"hand\",\"frame\":412,\"time_us\":13800001,\"hand\":\"left\",\"palm_m\":[1,1.25,-2.5],\"palm_sigma_m\":null,\"muzzle_m\":null,\"depth_source\":\"bridged\",\"track\":2}\n" +
            "{\"type\":\"rejected\",\"frame\":413,\"time_us\":13800002,\"x_px\":12.5,\"y_px\":40,\"reason\":\"not_isolated\",\"value\":0.31,\"limit\":null}\n" +
            "{\"type\":\"health\",\"frame\":414,\"time_us\":13800003,\"kind\":\"frame_gap\",\"value\":2,\"text\":\"gap\"}\n";

        private const string End = "{\"type\":\"end\",\"frames\":450,\"dropped\":2,\"seconds_media\":15.0005,\"seconds_wall\":1.25,\"start_us\":33333}\n";

        [Test]
        public void Reader_FileOfEveryType_WritesTheSameBytesAgain()
        {
            using var files = new EventFiles();
            string text = Header + Shot + PlainShot + Rest + End;
            var stream = new MemoryStream();
            EventReader.Read(files.Write("e.jsonl", text), new JsonLinesSink(stream, EventTypes.All));
            Assert.That(Encoding.UTF8.GetString(stream.ToArray()), Is.EqualTo(text));
        }

        [Test]
        public void Reader_UnknownTypesAndFields_ArePassedOver()
        {
            using var files = new EventFiles();
            var recorder = new SessionRecorder();
            EventReader.Read(files.Write("e.jsonl", Header + "{\"type\":\"aim\",\"x\":{}}\n\n" + Shot.Replace("\"peak\":255", "\"new\":[1],\"peak\":255") + End), recorder);
            Assert.That(recorder.Shots.Count, Is.EqualTo(1));
            Assert.That(recorder.Shots[0].Hit.Target, Is.EqualTo("Popper \"3\" ü"));
            Assert.That(recorder.StartTimeUs, Is.EqualTo(33333));
        }

        [Test]
        public void Reader_InterruptedSession_GivesWhatIsThere()
        {
            using var files = new EventFiles();
            var recorder = new SessionRecorder();
            EventReader.Read(files.Write("e.jsonl", Header + Shot), recorder);
            Assert.That(recorder.IsEnded, Is.False);
            Assert.That(recorder.StartTimeUs, Is.EqualTo(13733333));
        }

        [TestCase("", "holds no events")]
        [TestCase(Shot, "line 1: field \"type\"")]
        [TestCase(Header + "{\"type\":\"shot\"", "line 2 is no JSON, at character")]
        [TestCase(Header + "[1]\n", "line 2 is no JSON object")]
        [TestCase(Header + "{\"frame\":1}\n", "line 2: field \"type\"")]
        [TestCase(Header + "{\"type\":\"rejected\",\"frame\":413,\"time_us\":1,\"x_px\":1,\"y_px\":1,\"reason\":\"mood\",\"value\":1,\"limit\":1}\n", "line 2: field \"reason\"")]
        [TestCase(Header + "{\"type\":\"health\",\"frame\":1.5,\"time_us\":1,\"kind\":\"blind\",\"value\":1,\"text\":\"\"}\n", "line 2: field \"frame\"")]
        [TestCase(Header + Header, "line 2: field \"type\"")]
        [TestCase(Header + End + Shot, "line 3: field \"type\"")]
        [TestCase("{\"type\":\"header\",\"v\":2}\n", "line 1: field \"v\"")]
        [TestCase("{\"type\":\"header\",\"v\":1,\"version\":\"1\",\"inputs\":[3],\"detector\":\"shots\"}\n", "line 1: field \"inputs\"")]
        public void Reader_WrongFile_SaysLineAndFieldInOneLine(string text, string expected)
        {
            using var files = new EventFiles();
            string path = files.Write("e.jsonl", text);
            InputException e = Assert.Throws<InputException>(() => EventReader.Read(path, new SessionRecorder()))!;
            Assert.That(e.Message, Does.StartWith(path + ": ").And.Contain(expected).And.Not.Contain("\n"));
        }

        [Test]
        public void Reader_NoFileOrFolder_SaysSo()
        {
            Assert.That(() => EventReader.Read("absent.jsonl", new SessionRecorder()), Throws.TypeOf<InputException>().With.Message.Contain("is not there"));
            Assert.That(() => EventReader.Read(Path.GetTempPath(), new SessionRecorder()), Throws.TypeOf<InputException>().With.Message.Contain("is a folder"));
        }
    }
}
