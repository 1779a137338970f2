using LaserTracking.Capture.Live;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    public sealed class KinectExposureTests
    {
        // Rungs of the published ladder.
        [TestCase(1, 60, 500)]
        [TestCase(500, 60, 500)]
        [TestCase(501, 60, 1250)]
        [TestCase(8330, 60, 8330)]
        [TestCase(8331, 60, 16670)]
        [TestCase(8330, 50, 10000)]
        [TestCase(12000, 50, 20000)]
        [TestCase(99999, 60, 33330)]
        [TestCase(99999, 50, 30000)]
        public void RoundUp_Asked_IsTheNextRung(int askedUs, int mainsHz, int rungUs)
        {
            Assert.That(KinectExposure.RoundUp(askedUs, mainsHz), Is.EqualTo(rungUs));
        }

        [TestCase(7813, -7)]
        [TestCase(8000, -7)]
        [TestCase(2500, -9)]
        [TestCase(1e9, 0)]
        [TestCase(1, -13)]
        public void WebcamExposure_OnWindows_IsAPowerOfTwo(double us, double power)
        {
            Assert.That(WebcamExposure.ToPowerOfTwo(us), Is.EqualTo(power));
            Assert.That(WebcamExposure.FromPowerOfTwo(power), Is.EqualTo(System.Math.Pow(2, power) * 1e6));
        }

        [TestCase(7813, 78)]
        [TestCase(20, 1)]
        public void WebcamExposure_OnLinux_IsTenthsOfMilliseconds(double us, double steps)
        {
            Assert.That(WebcamExposure.ToTenthsOfMs(us), Is.EqualTo(steps));
            Assert.That(WebcamExposure.FromTenthsOfMs(steps), Is.EqualTo(steps * 100));
        }
    }
}
