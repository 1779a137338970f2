using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed unsafe class DotMemoryTests
    {
        private const int Side = 24;

        [Test]
        public void CompareWithPlace_DotFoundAgainInTheOtherPlane_StillMeansThePlaneItWasFirstSeenIn()
        {
            // A reddish wall: its largest and its smallest channel are 120 levels apart.
            var wall = new uint[Side * Side];
            System.Array.Fill(wall, 0xFFC86450u);
            var lit = (uint[])wall.Clone();
            lit[12 * Side + 12] = 0xFFFFFFFFu;
            fixed (uint* before = wall, now = lit)
            {
                var view = new FrameView { Width = Side, Height = Side, Now = now, Before = before };
                var candidate = new Candidate { Plane = DetectionPlane.Largest, Left = 11, Top = 11, Right = 13, Bottom = 13, PeakRise = 40 };
                var first = new RememberedDot { Plane = DetectionPlane.Largest };
                first.RememberPlace(view, candidate);
                var second = new RememberedDot { Plane = DetectionPlane.Smallest };
                second.TakePlaceOf(first);
                view.Now = before;
                second.CompareWithPlace(view, 0, out double brighter, out double darker);
                Assert.That(brighter, Is.Zero, "the wall is as it was");
                Assert.That(darker, Is.Zero, "the wall is as it was");
            }
        }
    }
}
