using System;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Remote
{
    public sealed class PublishedAimTests
    {
        private static readonly Vector2D SizeM = new Vector2D(3.73, 2.26);

        private static RemotePose Message(long timeUs, Vector3D muzzleMm, Vector3D direction) =>
            new RemotePose { Space = RemoteSpace.CameraMm, TimeUs = timeUs, Muzzle = muzzleMm, Direction = direction.Normalized, Target = new Vector3D(double.NaN, 0, 0) };

        [Test]
        public void PublishedAim_RayOfCameraZero_MeetsTheScreenAfterTheFlip()
        {
            var aim = new PublishedAim(PublishedAim.PublishedFlip, 1);
            RemotePose pose = Message(1, new Vector3D(100, 500, 0), new Vector3D(0.1, -0.2, 1));
            aim.Add(pose);
            var camera = new Pose(new Vector3D(0, 0, -2), Rotation3D.Identity);
            Assert.That(aim.TryPlace(pose, camera, Pose.Identity, SizeM, out Vector3D muzzleM, out Vector2D screenM), Is.True);
            // In the scene: muzzle (0.1, -0.5, -2), direction (0.1, 0.2, 1); two metres on it is at (0.3, -0.1).
            Assert.That((muzzleM - new Vector3D(SizeM.X / 2 + 0.1, SizeM.Y / 2 + 0.5, -2)).Length, Is.LessThan(1e-12));
            Assert.That((screenM - new Vector2D(SizeM.X / 2 + 0.3, SizeM.Y / 2 + 0.1)).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void PublishedAim_Smoothed_FollowsTheRecursiveMean()
        {
            var aim = new PublishedAim(PublishedAim.PublishedFlip, PublishedAim.PublishedAlpha);
            var camera = new Pose(new Vector3D(0, 0, -2), Rotation3D.Identity);
            Vector3D before = new Vector3D(0, 0, 1), after = new Vector3D(0.3, 0, 1).Normalized, mean = before;
            RemotePose pose = Message(0, default, before);
            aim.Add(pose);
            for (int i = 1; i <= 5; i++)
            {
                pose = Message(i, default, after);
                aim.Add(pose);
                aim.Add(pose);
                mean = after * 0.2 + mean * 0.8;
            }

            aim.TryPlace(pose, camera, Pose.Identity, SizeM, out _, out Vector2D screenM);
            Assert.That(screenM.X - SizeM.X / 2, Is.EqualTo(2 * mean.X / mean.Z).Within(1e-12));
            Assert.That(1 - mean.X / after.X, Is.EqualTo(Math.Pow(0.8, 5)).Within(1e-9), "what it lags by");
        }

        [Test]
        public void PublishedAim_RayAwayFromTheScreen_MeetsNothing()
        {
            var aim = new PublishedAim(PublishedAim.PublishedFlip, 1);
            RemotePose away = Message(1, default, new Vector3D(0, 0, -1));
            aim.Add(away);
            Assert.That(aim.TryPlace(away, new Pose(new Vector3D(0, 0, -2), Rotation3D.Identity), Pose.Identity, SizeM, out _, out _), Is.False);
        }

        [Test]
        public void PublishedAim_DotWithoutVector_IsPlacedWhereItIs()
        {
            var aim = new PublishedAim(PublishedAim.PublishedFlip, 1);
            var nowhere = new Vector3D(double.NaN, double.NaN, double.NaN);
            var pose = new RemotePose { Space = RemoteSpace.CameraMm, Muzzle = nowhere, Direction = nowhere, Target = new Vector3D(250, -100, 2000) };
            Assert.That(aim.TryPlace(pose, new Pose(new Vector3D(0, 0, -2), Rotation3D.Identity), Pose.Identity, SizeM, out Vector3D muzzleM, out Vector2D screenM), Is.True);
            Assert.That(muzzleM.IsFinite, Is.False);
            Assert.That((screenM - new Vector2D(SizeM.X / 2 + 0.25, SizeM.Y / 2 - 0.1)).Length, Is.LessThan(1e-12));
        }

        [TestCase(0, 1, 1, 0.2)]
        [TestCase(1, -1, 1, 0)]
        [TestCase(1, -1, 1, 1.1)]
        public void PublishedAim_SettingsBeyondTheirRange_AreRefused(double x, double y, double z, double alpha)
        {
            Assert.That(() => new PublishedAim(new Vector3D(x, y, z), alpha), Throws.ArgumentException);
        }

        [Test]
        public void RemoteClock_LateMessage_IsAsOldAsItWasLate()
        {
            var clock = new RemoteClock();
            const long OffsetUs = 77_000_000_000;
            for (int i = 0; i < 100; i++)
                clock.Add(i * 33_000L, i * 33_000L + OffsetUs + 2_000 + i % 7 * 1_000);
            long timeUs = 100 * 33_000L;
            clock.Add(timeUs, timeUs + OffsetUs + 42_000);
            Assert.That(clock.AgeS(timeUs, timeUs + OffsetUs + 42_000), Is.EqualTo(0.040).Within(1e-9));
            Assert.That(clock.AgeS(timeUs, timeUs + OffsetUs), Is.Zero, "never from the future");
        }

        [Test]
        public void RemoteClock_SenderThatBeginsAnew_IsFreshAgainAtOnce()
        {
            var clock = new RemoteClock();
            Assert.That(clock.AgeS(5, 900), Is.Zero, "nothing known");
            clock.Add(1_000_000, 50_000_000);
            clock.Add(0, 60_000_000);
            Assert.That(clock.AgeS(0, 60_000_000), Is.Zero);
        }

        [Test]
        public void RemoteClock_QuartzThatDrifts_IsFollowed()
        {
            var clock = new RemoteClock();
            long nowUs = 0, senderUs = 0;
            for (int i = 0; i < 20_000; i++)
            {
                nowUs += 33_000;
                // 100 ppm slow: without forgetting, its messages would seem to grow older by 6 ms a minute.
                senderUs = nowUs - nowUs / 10_000;
                clock.Add(senderUs, nowUs);
            }

            Assert.That(clock.AgeS(senderUs, nowUs), Is.LessThan(0.0035));
        }
    }
}
