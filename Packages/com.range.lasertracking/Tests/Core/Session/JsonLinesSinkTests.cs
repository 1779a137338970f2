using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class JsonLinesSinkTests
    {
        [TestCase(true, 1)]
        [TestCase(false, 4)]
        public void JsonLinesSink_OrdinaryRejected_AreSkippedOnRequest(bool skips, int lines)
        {
            using (var stream = new MemoryStream())
            {
                var sink = new JsonLinesSink(stream) { SkipsOrdinaryRejected = skips };
                sink.Begin(new SessionHeader("1.0.0", new SessionInput[0], null, "shots", null));
                foreach (RejectionReason reason in new[] { RejectionReason.TooFaint, RejectionReason.TooSmall, RejectionReason.NotCompact, RejectionReason.NotIsolated })
                    sink.OnRejected(new RejectedEvent { Candidate = new RejectedCandidate { Reason = reason } });
                sink.End(default);
                Assert.That(Encoding.UTF8.GetString(stream.ToArray()).Split(new[] { "\"rejected\"" }, System.StringSplitOptions.None).Length - 1, Is.EqualTo(lines));
            }
        }

        private const string FullShot =
            "{\"type\":\"shot\",\"id\":7,\"frame\":412,\"first_frame\":411,\"last_frame\":413,\"time_us\":13733333,\"time_sigma_us\":16667," +
            "\"x_px\":301.42,\"y_px\":288.1,\"sigma_px\":0.11,\"cov_px\":[0.0121,0.0004,0.0121],\"peak\":255,\"area_px\":31," +
            "\"color\":\"green\",\"confidence\":0.91,\"factors\":{\"peak\":0.38,\"contrast\":0.27,\"center\":0.17,\"stability\":0.09}," +
            "\"streak_px\":[3.5,-1.25]," +
            "\"screen_m\":[1.204,0.871],\"screen_cov_mm2\":[1.9,0.1,2.3]," +
            "\"shooter\":2,\"shooter_p\":0.97,\"hand\":\"right\",\"muzzle_m\":[1.1,1.3,-2.75],\"direction\":[0.0367,-0.1515,0.98777],\"pair_dt_us\":-8300," +
            "\"hit\":{\"target\":\"Popper 3\",\"zone\":\"A\",\"points\":5,\"point_m\":[0.5,1.25,7.2],\"distance_m\":7.2,\"p_zone\":0.93,\"score\":4.41,\"local_m\":[0.031,-0.02]}}";

        private const string PlainShotTail =
            "\"screen_m\":null,\"screen_cov_mm2\":null,\"shooter\":null,\"shooter_p\":null,\"hand\":null,\"muzzle_m\":null,\"direction\":null,\"pair_dt_us\":null,\"hit\":null}";

        [Test]
        public void Sink_EveryType_WritesTheLinesOfTheContract()
        {
            string[] lines = Lines(EventTypes.All, sink =>
            {
                sink.OnShot(EventExamples.FullShot());
                sink.OnDot(EventExamples.Dot(412, 13800000));
                sink.OnHand(EventExamples.Hand(412, 13800001));
                sink.OnRejected(EventExamples.Rejected(413, 13800002));
                sink.OnHealth(EventExamples.Health(414, 13800003));
            });
            Assert.That(lines, Is.EqualTo(new[]
            {
                "{\"type\":\"header\",\"v\":1,\"tool\":\"range\",\"version\":\"0.1.0\",\"inputs\":[{\"path\":\"range.mkv\",\"sha256\":\"ab12\"},{\"path\":\"hand.mkv\",\"sha256\":null}],\"calibration\":\"screen.json\",\"detector\":\"shots\",\"seed\":null}",
                FullShot,
                "{\"type\":\"dot\",\"frame\":412,\"time_us\":13800000,\"track\":3,\"x_px\":301.42,\"y_px\":288.1,\"sigma_px\":0.11,\"color\":\"green\",\"shooter\":1}",
                "{\"type\":\"hand\",\"frame\":412,\"time_us\":13800001,\"hand\":\"left\",\"palm_m\":[1,1.25,-2.5],\"palm_sigma_m\":0.0123,\"muzzle_m\":[1.1,1.2,-2.3],\"depth_source\":\"bridged\",\"track\":2}",
                "{\"type\":\"rejected\",\"frame\":413,\"time_us\":13800002,\"x_px\":12.5,\"y_px\":40,\"reason\":\"not_isolated\",\"value\":0.31,\"limit\":0.2}",
                "{\"type\":\"health\",\"frame\":414,\"time_us\":13800003,\"kind\":\"frame_gap\",\"value\":2,\"text\":\"two frames are missing: check the USB cable\"}",
                "{\"type\":\"end\",\"frames\":450,\"dropped\":2,\"seconds_media\":15.0005,\"seconds_wall\":1.25,\"start_us\":33333}",
            }));
        }

        [Test]
        public void Sink_ShotWithoutCalibrationHandOrHit_WritesNulls()
        {
            string line = Lines(EventTypes.Default, sink => sink.OnShot(EventExamples.PlainShot(1, 5)))[1];
            Assert.That(line, Does.EndWith(PlainShotTail));
        }

        [Test]
        public void Sink_NumbersThatJsonLacks_WritesNull()
        {
            ShotEvent shot = EventExamples.FullShot();
            shot.ScreenM = new Vector2D(double.NaN, 1);
            shot.Hit.Score = double.PositiveInfinity;
            shot.Shot.Dot.CovariancePx = new Covariance2D(double.NaN, 0, 0);
            string line = Lines(EventTypes.Default, sink => sink.OnShot(shot))[1];
            Assert.That(line, Does.Contain("\"screen_m\":null").And.Contain("\"score\":null").And.Contain("\"cov_px\":null,"));
            Assert.That(line, Does.Not.Contain("NaN").And.Not.Contain("nfinity").And.Not.Contain("∞"));
        }

        [Test]
        public void Sink_HeaderWithSeed_WritesIt()
        {
            var stream = new MemoryStream();
            new JsonLinesSink(stream).Begin(EventExamples.Header(-3));
            Assert.That(Encoding.UTF8.GetString(stream.ToArray()), Does.EndWith(",\"seed\":-3}\n"));
        }

        [Test]
        public void Sink_EventsOutOfOrder_AreWrittenByTimeThenTypeThenArrival()
        {
            string[] lines = Lines(EventTypes.All, sink =>
            {
                sink.OnHealth(EventExamples.Health(1, 200));
                sink.OnRejected(EventExamples.Rejected(1, 200));
                sink.OnRejected(EventExamples.Rejected(2, 200));
                sink.OnDot(EventExamples.Dot(1, 300));
                sink.OnTimePassed(200);
                sink.OnHand(EventExamples.Hand(1, 250));
                sink.OnShot(EventExamples.PlainShot(2, 300));
                sink.OnShot(EventExamples.PlainShot(1, 200));
                sink.OnTimePassed(201);
                sink.OnShot(EventExamples.PlainShot(3, 201));
            });
            Assert.That(lines.Skip(1).Take(8).Select(line => string.Concat(line.Skip(9).TakeWhile(c => c != '"')) + " " + Field(line, "time_us")),
                Is.EqualTo(new[] { "shot 200", "rejected 200", "rejected 200", "health 200", "shot 201", "hand 250", "shot 300", "dot 300" }));
            Assert.That(lines.Where(line => line.Contains("rejected")).Select(line => Field(line, "frame")), Is.EqualTo(new[] { "1", "2" }));
        }

        [Test]
        public void Sink_TimePassed_WritesWhatIsEarlierAndHoldsTheRest()
        {
            var stream = new MemoryStream();
            var sink = new JsonLinesSink(stream);
            sink.Begin(EventExamples.Header());
            long header = stream.Length;
            sink.OnShot(EventExamples.PlainShot(1, 100));
            sink.OnTimePassed(100);
            Assert.That(stream.Length, Is.EqualTo(header), "an event of the same time may still follow");
            sink.OnTimePassed(101);
            Assert.That(stream.Length, Is.GreaterThan(header));
        }

        [Test]
        public void Sink_UnwantedTypes_AreLeftOut()
        {
            string[] lines = Lines(EventTypes.Default, sink => sink.OnDot(EventExamples.Dot(1, 1)));
            Assert.That(lines.Length, Is.EqualTo(2));
            lines = Lines(EventTypes.Dots, sink =>
            {
                sink.OnDot(EventExamples.Dot(1, 1));
                sink.OnShot(EventExamples.FullShot());
            });
            Assert.That(lines[1], Does.StartWith("{\"type\":\"dot\""));
            Assert.That(lines.Length, Is.EqualTo(3));
        }

        [Test]
        public void Sink_GermanCulture_WritesTheSameBytes()
        {
            CultureInfo before = CultureInfo.CurrentCulture;
            byte[] expected = Run(EventTypes.All, WriteMany);
            try
            {
                // Built by hand: hosts in invariant-globalization mode have no real de-DE.
                var german = (CultureInfo)CultureInfo.InvariantCulture.Clone();
                german.NumberFormat.NumberDecimalSeparator = ",";
                german.NumberFormat.NumberGroupSeparator = ".";
                german.NumberFormat.NegativeSign = "\u2212";
                CultureInfo.CurrentCulture = german;
                Assert.That(Run(EventTypes.All, WriteMany), Is.EqualTo(expected));
            }
            finally
            {
                CultureInfo.CurrentCulture = before;
            }
        }

        [Test]
        public void Sink_TwoRuns_DifferInSecondsWallOnly()
        {
            byte[] first = Run(EventTypes.All, WriteMany, 1), second = Run(EventTypes.All, WriteMany, 22.5);
            Assert.That(first, Is.Not.EqualTo(second));
            string text = Encoding.UTF8.GetString(second).Replace("\"seconds_wall\":22.5", "\"seconds_wall\":1");
            Assert.That(text, Is.EqualTo(Encoding.UTF8.GetString(first)));
            Assert.That(first[0], Is.EqualTo((byte)'{'), "no byte order mark");
            Assert.That(first, Has.No.Member((byte)'\r'));
        }

        [Test]
        public void Sink_MoreThanItsRoom_LeavesOutCandidatesAndSaysSo()
        {
            var stream = new MemoryStream();
            var sink = new JsonLinesSink(stream, EventTypes.Default, 2000);
            sink.Begin(EventExamples.Header());
            for (int i = 0; i < 100; i++)
            {
                sink.OnRejected(EventExamples.Rejected(i, 1000 + i));
                sink.OnShot(EventExamples.PlainShot(i, 1000 + i));
            }

            sink.End(EventExamples.End());
            string[] lines = Encoding.UTF8.GetString(stream.ToArray()).Split('\n');
            int rejected = lines.Count(line => line.Contains("\"rejected\""));
            Assert.That(lines.Count(line => line.Contains("\"shot\"")), Is.EqualTo(100));
            Assert.That(rejected, Is.LessThan(100));
            string overflow = lines.Single(line => line.Contains("\"overflow\""));
            Assert.That(Field(overflow, "value"), Is.EqualTo((100 - rejected).ToString(CultureInfo.InvariantCulture)));
            Assert.That(lines.Skip(1).Take(lines.Length - 3).Select(line => long.Parse(Field(line, "time_us"))), Is.Ordered);
        }

        [Test]
        public void Sink_OnceWarm_AllocatesNothing()
        {
            var stream = new MemoryStream(48 << 20);
            var sink = new JsonLinesSink(stream, EventTypes.All);
            sink.Begin(EventExamples.Header());
            ShotEvent shot = EventExamples.FullShot();
            HealthEvent health = EventExamples.Health(1, 0);
            WriteFrames(sink, 0, 200, ref shot, ref health);
            int round = 0;
            long allocated = Allocation.Of(() =>
            {
                round++;
                WriteFrames(sink, 200 * round, 200 * round + 200, ref shot, ref health);
            });
            Assert.That(allocated, Is.EqualTo(0));
        }

        private static void WriteFrames(JsonLinesSink sink, int from, int to, ref ShotEvent shot, ref HealthEvent health)
        {
            for (int frame = from; frame < to; frame++)
            {
                long timeUs = frame * 33333L;
                shot.Shot.TimeUs = timeUs - 66666;
                health.TimeUs = timeUs;
                sink.OnShot(shot);
                sink.OnHealth(health);
                sink.OnHand(EventExamples.Hand(frame, timeUs - 8000));
                for (int i = 0; i < 20; i++)
                {
                    sink.OnDot(EventExamples.Dot(frame, timeUs));
                    sink.OnRejected(EventExamples.Rejected(frame, timeUs));
                }

                sink.OnTimePassed(timeUs - 100000);
            }
        }

        private static void WriteMany(IEventSink sink)
        {
            ShotEvent shot = EventExamples.FullShot();
            HealthEvent health = EventExamples.Health(1, 0);
            WriteFrames((JsonLinesSink)sink, 0, 20, ref shot, ref health);
        }

        private static string[] Lines(EventTypes types, Action<IEventSink> write)
        {
            string text = Encoding.UTF8.GetString(Run(types, write));
            Assert.That(text, Does.EndWith("\n"));
            return text.Substring(0, text.Length - 1).Split('\n');
        }

        private static byte[] Run(EventTypes types, Action<IEventSink> write, double secondsWall = 1.25)
        {
            var stream = new MemoryStream();
            var sink = new JsonLinesSink(stream, types);
            sink.Begin(EventExamples.Header());
            write(sink);
            sink.End(EventExamples.End(secondsWall));
            return stream.ToArray();
        }

        private static string Field(string line, string name)
        {
            int at = line.IndexOf("\"" + name + "\":", StringComparison.Ordinal) + name.Length + 3;
            return line.Substring(at, line.IndexOfAny(new[] { ',', '}' }, at) - at);
        }
    }
}
