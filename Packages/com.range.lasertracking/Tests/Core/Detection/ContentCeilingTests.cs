using System;
using LaserTracking.Kernels;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class ContentCeilingTests
    {
        private const int Side = 64;

        [Test]
        public void Scale_LongExposureTakenBack_LeavesTheCeilingWhereItWas()
        {
            ContentCeiling ceiling = Learned(180);
            ceiling.Scale(1.8);
            Assert.That(ceiling.Level, Is.EqualTo(255), "no picture shows more");
            ceiling.Scale(1 / 1.8);
            Assert.That(ceiling.Level, Is.EqualTo(180));
        }

        [Test]
        public void Update_DarkerScene_ForgetsSlowly()
        {
            ContentCeiling ceiling = Learned(180);
            Look(ceiling, 100, 160);
            Assert.That(ceiling.Level, Is.EqualTo(170).Within(1));
        }

        private static ContentCeiling Learned(byte level)
        {
            var ceiling = new ContentCeiling(KernelRunner.Plain);
            Look(ceiling, level, 1);
            Assert.That(ceiling.Level, Is.EqualTo(level));
            return ceiling;
        }

        private static unsafe void Look(ContentCeiling ceiling, byte level, int frames)
        {
            var envelope = new byte[Side * Side];
            Array.Fill(envelope, level);
            fixed (byte* largest = envelope)
            {
                var view = new FrameView { Width = Side, Height = Side, OldLargest = largest };
                for (int i = 0; i < frames; i++)
                    ceiling.Update(view);
            }
        }
    }
}
