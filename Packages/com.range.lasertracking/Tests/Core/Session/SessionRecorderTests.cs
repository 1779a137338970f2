using LaserTracking.Detection;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class SessionRecorderTests
    {
        [Test]
        public void Recorder_MoreThanItsRoom_CountsAllAndKeepsTheFirst()
        {
            var recorder = new SessionRecorder(3, 2);
            recorder.Begin(EventExamples.Header());
            for (int i = 0; i < 5; i++)
            {
                recorder.OnShot(EventExamples.PlainShot(i, 500 - i));
                recorder.OnHealth(EventExamples.Health(i, i));
                recorder.OnRejected(EventExamples.Rejected(i, 1000));
            }

            Assert.That(recorder.ShotCount, Is.EqualTo(5));
            Assert.That(recorder.Shots.Count, Is.EqualTo(3));
            Assert.That(recorder.ShotsByTime()[0].Shot.Id, Is.EqualTo(2));
            Assert.That(recorder.HealthCount, Is.EqualTo(5));
            Assert.That(recorder.Health.Count, Is.EqualTo(2));
            Assert.That(recorder.CountOf(HealthKind.FrameGap), Is.EqualTo(5));
            Assert.That(recorder.CountOf(RejectionReason.NotIsolated), Is.EqualTo(5));
            Assert.That(recorder.StartTimeUs, Is.EqualTo(496), "the first event, while the first frame is not known");
            recorder.End(EventExamples.End());
            Assert.That(recorder.StartTimeUs, Is.EqualTo(33333));
        }

        [Test]
        public void FrameStatistics_KnownTimes_GivesPercentilesToAFewPercent()
        {
            var frames = new FrameStatistics();
            for (int i = 1; i <= 1000; i++)
                frames.Add(i <= 100 ? 0.5 : 0, i * 0.01);
            frames.Add(0, double.NaN);
            Assert.That(frames.MedianMs, Is.EqualTo(5).Within(4).Percent);
            Assert.That(frames.P95Ms, Is.EqualTo(9.5).Within(4).Percent);
            Assert.That(frames.LargestMs, Is.EqualTo(10));
            Assert.That(frames.BlindFrames, Is.EqualTo(100));
            Assert.That(frames.MeanBlindShare, Is.EqualTo(50.0 / 1001).Within(1e-12));
        }

        [Test]
        public void SinkGroup_Events_ReachEverySink()
        {
            SessionRecorder first = new SessionRecorder(), second = new SessionRecorder();
            var group = new EventSinkGroup(new IEventSink[] { first, second });
            group.Begin(EventExamples.Header());
            group.OnShot(EventExamples.FullShot());
            group.OnDot(EventExamples.Dot(1, 1));
            group.OnHand(EventExamples.Hand(1, 1));
            group.OnRejected(EventExamples.Rejected(1, 1));
            group.OnHealth(EventExamples.Health(1, 1));
            group.OnTimePassed(5);
            group.End(EventExamples.End());
            foreach (SessionRecorder recorder in new[] { first, second })
            {
                Assert.That(recorder.Header, Is.Not.Null);
                Assert.That(recorder.ShotCount + recorder.DotCount + recorder.HandCount + recorder.RejectedCount + recorder.HealthCount, Is.EqualTo(5));
                Assert.That(recorder.IsEnded, Is.True);
            }
        }

        [Test]
        public void EventWords_EveryMember_HasItsWordAndBack()
        {
            Assert.That(EventWords.Of(RejectionReason.NotIsolated), Is.EqualTo("not_isolated"));
            Assert.That(EventWords.Of(HealthKind.FrameGap), Is.EqualTo("frame_gap"));
            Assert.That(EventWords.Of(LaserColor.Infrared), Is.EqualTo("infrared"));
            foreach (RejectionReason reason in System.Enum.GetValues(typeof(RejectionReason)))
            {
                Assert.That(EventWords.TryParse(EventWords.Of(reason), out RejectionReason back), Is.True);
                Assert.That(back, Is.EqualTo(reason));
            }

            Assert.That(EventWords.TryParse("Green", out LaserColor _), Is.False);
        }
    }
}
