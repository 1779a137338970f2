using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class DetectionsTests
    {
        [Test]
        public void Reject_SameSpotForTheSameReason_IsNotedOnce()
        {
            var detections = new Detections();
            detections.Begin(0, 0);
            var candidate = new RejectedCandidate { PositionPx = new Vector2D(3, 4), Reason = RejectionReason.TooFaint };
            detections.Reject(candidate);
            detections.Reject(candidate);
            candidate.Reason = RejectionReason.TooSmall;
            detections.Reject(candidate);
            candidate.PositionPx = new Vector2D(3, 5);
            detections.Reject(candidate);
            Assert.That(detections.Rejected.Length, Is.EqualTo(3));
            Assert.That(detections.OverflowCount, Is.Zero);
        }

        [Test]
        public void Reject_MoreThanThereIsRoomFor_IsCounted()
        {
            var detections = new Detections(1, 2);
            detections.Begin(0, 0);
            for (int i = 0; i < 5; i++)
                detections.Reject(new RejectedCandidate { PositionPx = new Vector2D(i, 0), Reason = RejectionReason.TooFaint });
            Assert.That(detections.Rejected.Length, Is.EqualTo(2));
            Assert.That(detections.OverflowCount, Is.EqualTo(3));
        }
    }
}
