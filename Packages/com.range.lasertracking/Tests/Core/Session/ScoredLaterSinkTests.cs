using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class ScoredLaterSinkTests
    {
        private MemoryStream _stream = new MemoryStream();

        private string[] Lines => Encoding.UTF8.GetString(_stream.ToArray()).TrimEnd('\n').Split('\n');

        private string[] Types => Lines.Select(line => line.Split('"')[3]).ToArray();

        private ScoredLaterSink Begin()
        {
            _stream = new MemoryStream();
            return new ScoredLaterSink(new JsonLinesSink(_stream), EventExamples.Header());
        }

        private static ShotEvent Scored(ShotEvent shot)
        {
            shot.HasHit = true;
            shot.Hit = EventExamples.FullShot().Hit;
            return shot;
        }

        [Test]
        public void Sink_HitsThatComeLate_GivesTheFileOfHitsThatComeAtOnce()
        {
            ShotEvent first = EventExamples.PlainShot(1, 1000), second = EventExamples.PlainShot(2, 2000);
            ScoredLaterSink late = Begin();
            late.OnShot(first);
            late.OnHand(EventExamples.Hand(1, 500));
            late.OnTimePassed(1500);
            Assert.That(Types, Is.EqualTo(new[] { "header", "hand" }), "the shot's line waits for its hit");
            late.OnRejected(EventExamples.Rejected(3, 1600));
            late.OnShot(second);
            late.OnHealth(EventExamples.Health(4, 2500));
            late.OnTimePassed(3000);
            late.Score(Scored(first));
            late.OnTimePassed(3000);
            Assert.That(Types, Is.EqualTo(new[] { "header", "hand", "shot", "rejected" }));
            late.End(EventExamples.End());
            late.Score(second);
            late.Finish(EventExamples.End());
            byte[] written = _stream.ToArray();

            var expected = new MemoryStream();
            var atOnce = new JsonLinesSink(expected);
            atOnce.Begin(EventExamples.Header());
            atOnce.OnHand(EventExamples.Hand(1, 500));
            atOnce.OnShot(Scored(first));
            atOnce.OnRejected(EventExamples.Rejected(3, 1600));
            atOnce.OnShot(second);
            atOnce.OnHealth(EventExamples.Health(4, 2500));
            atOnce.End(EventExamples.End());
            Assert.That(written, Is.EqualTo(expected.ToArray()));
        }

        [Test]
        public void Sink_ShotThatNobodyScores_IsWrittenWithoutHit()
        {
            ScoredLaterSink sink = Begin();
            for (int id = 1; id <= 3; id++)
                sink.OnShot(EventExamples.PlainShot(id, 1000 * id));
            sink.Score(Scored(EventExamples.PlainShot(2, 2000)));
            sink.Finish(EventExamples.End());
            Assert.That(Types, Is.EqualTo(new[] { "header", "shot", "shot", "shot", "end" }));
            Assert.That(Lines.Select(line => line.Contains("\"hit\":{")), Is.EqualTo(new[] { false, false, true, false, false }));
        }

        [Test]
        public void Sink_AfterItsEnd_TakesNothingMore()
        {
            ScoredLaterSink sink = Begin();
            sink.Finish(EventExamples.End());
            int lines = Lines.Length;
            sink.OnShot(EventExamples.PlainShot(1, 1000));
            sink.Score(EventExamples.PlainShot(1, 1000));
            sink.OnHand(EventExamples.Hand(1, 500));
            sink.OnDot(EventExamples.Dot(1, 500));
            sink.OnRejected(EventExamples.Rejected(1, 500));
            sink.OnHealth(EventExamples.Health(1, 500));
            sink.OnTimePassed(5000);
            sink.End(EventExamples.End());
            sink.Finish(EventExamples.End());
            Assert.That(Lines, Has.Length.EqualTo(lines).And.Length.EqualTo(2));
        }

        [Test]
        public void Sink_Warm_AllocatesNothing()
        {
            ScoredLaterSink sink = new ScoredLaterSink(new JsonLinesSink(Stream.Null), EventExamples.Header());
            int id = 0;
            ShotEvent shot = EventExamples.PlainShot(1, 0);
            void Play()
            {
                shot.Shot.Id = ++id;
                shot.Shot.TimeUs = 1000 * id;
                sink.OnShot(shot);
                sink.OnTimePassed(1000 * id);
                sink.Score(shot);
                sink.OnTimePassed(1000 * id + 1);
            }

            Play();
            Assert.That(Allocation.Of(Play), Is.Zero);
        }
    }
}
