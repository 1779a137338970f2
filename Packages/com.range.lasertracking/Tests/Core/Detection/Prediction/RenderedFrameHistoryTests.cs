using System;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed unsafe class RenderedFrameHistoryTests
    {
        [TestCase(1, 1, 1, 1)]
        [TestCase(640, 360, 640, 360)]
        [TestCase(641, 361, 320, 180)]
        [TestCase(1920, 1080, 640, 360)]
        [TestCase(5, 2000, 5, 2000)]
        public void Add_LargePictures_AreReducedByAWholeNumber(int width, int height, int keptWidth, int keptHeight)
        {
            var history = new RenderedFrameHistory();
            Add(history, width, height, 100, 0);
            Assert.That(history.Width, Is.EqualTo(keptWidth));
            Assert.That(history.Height, Is.EqualTo(keptHeight));
            Assert.That(history.At(0).Pixels[keptWidth * keptHeight - 1] & 0xFFFFFF, Is.EqualTo(0x646464));
        }

        [Test]
        public void Add_MoreThanItKeeps_ForgetsTheOldest()
        {
            var history = new RenderedFrameHistory();
            for (int i = 0; i < 60; i++)
                Add(history, 32, 18, (byte)i, 1000 * i);
            Assert.That(history.Count, Is.EqualTo(RenderedFrameHistory.Capacity));
            Assert.That(history.At(0).TimeUs, Is.EqualTo(59_000));
            Assert.That(history.At(history.Count - 1).TimeUs, Is.EqualTo(1000 * (60 - RenderedFrameHistory.Capacity)));
            Assert.That(history.EndUs(0), Is.EqualTo(60_000));
        }

        [Test]
        public void Add_TimeThatStandsStillOrRunsBack_ReplacesOrBeginsAnew()
        {
            var history = new RenderedFrameHistory();
            Add(history, 32, 18, 10, 1000);
            Add(history, 32, 18, 20, 1000);
            Assert.That(history.Count, Is.EqualTo(1));
            Assert.That(history.At(0).Pixels[0] & 255, Is.EqualTo(20));
            Add(history, 32, 18, 30, 500);
            Assert.That(history.Count, Is.EqualTo(1));
            Add(history, 64, 18, 30, 600);
            Assert.That(history.Count, Is.EqualTo(1));
        }

        [Test]
        public void Add_DepthPicture_IsRefused()
        {
            using var picture = new Image();
            picture.Reset(PixelFormat.Depth16, 4, 4, 0);
            Assert.Throws<ArgumentException>(() => new RenderedFrameHistory().Add(picture, 0));
        }

        private static void Add(RenderedFrameHistory history, int width, int height, byte level, long timeUs)
        {
            using var picture = new Image();
            picture.Reset(PixelFormat.Bgra32, width, height, timeUs);
            picture.Bytes.Fill(level);
            history.Add(picture, timeUs);
        }
    }
}
