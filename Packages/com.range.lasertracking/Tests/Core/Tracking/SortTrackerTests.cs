using System;
using System.Collections.Generic;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    public sealed class SortTrackerTests
    {
        [Test]
        public void Process_UndisturbedBox_KeepsOneNumber()
        {
            var tracker = new SortTracker();
            for (int frame = 0; frame < 20; frame++)
            {
                tracker.Process(new[] { new BoundingBox(100 + 4 * frame, 50, 40, 80) });
                Assert.That(tracker.Boxes.Length, Is.EqualTo(1), "frame " + frame);
                Assert.That(tracker.Boxes[0].TrackId, Is.EqualTo(1));
                Assert.That(tracker.Boxes[0].Box.X, Is.EqualTo(100 + 4 * frame).Within(3));
            }
        }

        [Test]
        public void Process_BoxThatComesLater_IsReportedAfterMinHits()
        {
            var tracker = new SortTracker();
            for (int frame = 1; frame <= 5; frame++)
                tracker.Process(ReadOnlySpan<BoundingBox>.Empty);
            var reported = new List<int>();
            for (int frame = 6; frame <= 10; frame++)
            {
                tracker.Process(new[] { new BoundingBox(100, 50, 40, 80) });
                reported.Add(tracker.Boxes.Length);
            }

            Assert.That(reported, Is.EqualTo(new[] { 0, 0, 0, 1, 1 }), "the first sight is no hit");
        }

        [TestCase(1, 1, true)]
        [TestCase(1, 2, false)]
        [TestCase(3, 3, true)]
        [TestCase(3, 4, false)]
        public void Process_BoxThatIsMissed_LivesOnForMaxAge(int maxAge, int missed, bool isKept)
        {
            var tracker = new SortTracker(new SortTrackerSettings { MaxAge = maxAge, MinHits = 0 });
            var box = new[] { new BoundingBox(100, 50, 40, 80) };
            tracker.Process(box);
            tracker.Process(box);
            for (int i = 0; i < missed; i++)
            {
                tracker.Process(ReadOnlySpan<BoundingBox>.Empty);
                Assert.That(tracker.Boxes.Length, Is.Zero);
            }

            tracker.Process(box);
            Assert.That(tracker.Boxes[0].TrackId, Is.EqualTo(isKept ? 1 : 2));
        }

        [Test]
        public void Process_OverlapsThatDoNotPairOff_AreAssignedOverAllPairsBeforeTheThreshold()
        {
            // Two tracks A and B; the first detection overlaps both well, the second overlaps only A, below the threshold. The best sum
            // gives the first to B and the second to A, whose overlap then is too poor: A stays without, although the first would fit it better.
            var tracker = new SortTracker(new SortTrackerSettings { MinHits = 0 });
            tracker.Process(new[] { new BoundingBox(0, 0, 100, 100), new BoundingBox(45, 0, 100, 100) });
            BoundingBox first = new BoundingBox(22, 0, 100, 100), second = new BoundingBox(-60, 0, 100, 100);
            Assert.That(BoundingBox.IntersectionOverUnion(new BoundingBox(0, 0, 100, 100), first), Is.GreaterThan(BoundingBox.IntersectionOverUnion(new BoundingBox(45, 0, 100, 100), first)));
            Assert.That(BoundingBox.IntersectionOverUnion(new BoundingBox(0, 0, 100, 100), second), Is.EqualTo(0.25).Within(1e-12));
            tracker.Process(new[] { first, second });
            int numberOfFirst = 0, numberOfSecond = 0;
            foreach (TrackedBox box in tracker.Boxes)
            {
                if (box.Box.X > 0)
                    numberOfFirst = box.TrackId;
                else
                    numberOfSecond = box.TrackId;
            }

            Assert.That(numberOfFirst, Is.EqualTo(2));
            Assert.That(numberOfSecond, Is.EqualTo(3), "a new one");
        }

        [Test]
        public void Process_AreaThatShrinksToNothing_NeverGivesBoxesThatAreNoNumbers()
        {
            var tracker = new SortTracker(new SortTrackerSettings { MaxAge = 50, MinHits = 0 });
            for (int frame = 0; frame < 60; frame++)
            {
                double size = Math.Max(0.01, 100 - 12 * frame);
                tracker.Process(frame < 20 ? new[] { new BoundingBox(200 - size / 2, 200 - size / 2, size, size) } : Array.Empty<BoundingBox>());
                foreach (SortTrack track in tracker.Tracks)
                    Assert.That(track.Box.IsUsable, Is.True, "frame " + frame);
            }
        }

        [Test]
        public void Process_BoxesThatCannotBe_AreIgnoredAndCounted()
        {
            var tracker = new SortTracker(new SortTrackerSettings { MinHits = 0 });
            tracker.Process(new[]
            {
                new BoundingBox(double.NaN, 0, 10, 10), new BoundingBox(0, double.PositiveInfinity, 10, 10), new BoundingBox(0, 0, 0, 10),
                new BoundingBox(0, 0, 10, -1), new BoundingBox(0, 0, double.NaN, 10), new BoundingBox(5, 5, 10, 10),
            });
            Assert.That(tracker.IgnoredDetections, Is.EqualTo(5));
            Assert.That(tracker.Boxes.Length, Is.EqualTo(1));
        }

        [Test]
        public void Process_MoreThanTheRoom_IsBoundedAndSaysSo()
        {
            var random = new Random(3);
            var boxes = new BoundingBox[10_000];
            for (int i = 0; i < boxes.Length; i++)
                boxes[i] = new BoundingBox(random.NextDouble() * 1900, random.NextDouble() * 1000, 20 + random.NextDouble() * 100, 20 + random.NextDouble() * 100);
            var tracker = new SortTracker(new SortTrackerSettings { MaxAge = 20, MinHits = 0 });
            for (int frame = 0; frame < 5; frame++)
            {
                tracker.Process(boxes.AsSpan(1000 * frame));
                Assert.That(tracker.IgnoredDetections, Is.GreaterThanOrEqualTo(10_000 - 1000 * frame - SortTracker.MaxDetections));
                Assert.That(tracker.Tracks.Length, Is.LessThanOrEqualTo(SortTracker.MaxTracks));
            }
        }

        [Test]
        public void Process_OnceWarm_AllocatesNothing()
        {
            var tracker = new SortTracker();
            var boxes = new BoundingBox[10];
            int frame = 0;
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 50; i++, frame++)
                {
                    for (int b = 0; b < boxes.Length; b++)
                        boxes[b] = new BoundingBox(20 * b + frame % 100, 10 * b, 40 + frame % 3, 60);
                    tracker.Process(boxes.AsSpan(0, 10 - frame % 4));
                }
            }), Is.Zero);
        }

        [Test]
        public void Reset_StartsToCountAnew()
        {
            var tracker = new SortTracker();
            tracker.Process(new[] { new BoundingBox(0, 0, 10, 10) });
            tracker.Reset();
            tracker.Process(new[] { new BoundingBox(500, 0, 10, 10) });
            Assert.That(tracker.Boxes[0].TrackId, Is.EqualTo(1));
            Assert.That(tracker.Tracks.Length, Is.EqualTo(1));
        }

        [TestCase(-1, 3, 0.3)]
        [TestCase(1, -1, 0.3)]
        [TestCase(1, 3, 1.1)]
        [TestCase(1, 3, double.NaN)]
        public void Settings_OutsideTheirRange_AreRefused(int maxAge, int minHits, double iou) =>
            Assert.That(() => new SortTracker(new SortTrackerSettings { MaxAge = maxAge, MinHits = minHits, IouThreshold = iou }), Throws.ArgumentException);
    }
}
