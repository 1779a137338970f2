using LaserTracking.Geometry;
using LaserTracking.Hands;
using NUnit.Framework;

namespace LaserTracking.Fusion
{
    /// <summary>What remembered shots teach of somebody's line of sight, and how what one of them taught wrongly is put right.</summary>
    public sealed class ShotMemoryTests
    {
        private const double MuzzleSigmaM = 0.003;

        private static readonly Vector3D Eyes = new Vector3D(1.6, 0.9, -2.5);

        /// <summary>The eye that looks over the weapon, beside the middle of the head.</summary>
        private static readonly Vector3D Own = new Vector3D(0.03, 0, 0);

        /// <summary>Where a neighbour's shot makes believe it to be.</summary>
        private static readonly Vector3D Others = new Vector3D(-0.09, 0.04, 0);

        private HandCamera _camera = null!;
        private FusionSettings _settings = null!;
        private SightLines _sights = null!;
        private ShotMemory _memory = null!;

        [SetUp]
        public void SetUp()
        {
            _settings = new FusionSettings();
            _sights = new SightLines(_settings);
            _camera = new HandCamera(new PinholeCamera(504, 504, 320, 288, 640, 576), Pose.Identity);
            _sights.See(new PersonObservation { PersonId = 1, EyeMm = Eyes * 1000, SigmaMm = 60 }, _camera, 0);
            _memory = new ShotMemory(_camera, _settings, _sights);
        }

        [Test]
        public void Refresh_LineLearnedFromAnothersShot_IsLearnedAnewFromThoseThatPassIt()
        {
            Fire(0, Others, 0.97);
            Assert.That(ErrorM(), Is.GreaterThan(0.06), "believed so far");
            for (int i = 1; i < 7; i++)
                Fire(i, Own, 0.5);
            for (int i = 0; i < 30; i++)
                _memory.Refresh(new HandHistory(), 10_000_000 + i * 33_333);
            Assert.That(ErrorM(), Is.LessThan(0.015));
        }

        private void Fire(int number, Vector3D pivot, double probability)
        {
            var dot = new Vector2D(0.4 + 0.3 * (number % 5), 0.3 + 0.25 * (number % 4));
            Vector3D aim = (new Vector3D(dot.X, dot.Y, 0) - Eyes - pivot).Normalized;
            _memory.Begin(number * 500_000, dot);
            _memory.Add(1, new FusedShot { HandTrackId = 1, MuzzleM = Eyes + pivot + aim * 0.75, MuzzleSigmaM = MuzzleSigmaM }, probability, 0.99, false);
            _memory.End();
        }

        /// <summary>From where their line passes the eyes to where it should, metres.</summary>
        private double ErrorM()
        {
            Vector3D aim = (new Vector3D(1, 0.8, 0) - Eyes - Own).Normalized, muzzle = Eyes + Own + aim * 0.75;
            Assert.That(_sights.TrySight(1, muzzle, MuzzleSigmaM, out Vector3D sight, out _), Is.True);
            return Vector3D.Cross(sight.Normalized, aim).Length * 0.75;
        }
    }
}
