using System;
using LaserTracking.Geometry;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Scoring
{
    public sealed class ShotScorerTests
    {
        private static readonly Covariance2D Certain = default;

        [Test]
        public void ShotScorer_DotOnTarget_ReportsZonePointAndDistance()
        {
            SceneModel scene = TestScenes.Of(TestScenes.Target("left", TestScenes.Rings, -2, 0.5, 10));
            Assert.That(Score(scene, new Vector3D(-2 + 0.3, 0.5 - 0.1, 10), out ScoredHit hit), Is.True);
            Assert.That(hit.Target, Is.EqualTo("left"));
            Assert.That(hit.Zone, Is.EqualTo("5"));
            Assert.That(hit.Points, Is.EqualTo(5));

            // The card's face is 5 mm nearer than its middle, so the foot lies up to 5 mm · tan(angle) beside.
            Assert.That((hit.LocalPointM - new Vector2D(0.3, -0.1)).Length, Is.LessThan(0.001));
            Vector3D eyeToPoint = hit.PointM - scene.Viewpoint;
            Vector3D direction = eyeToPoint.Normalized;
            double toScreen = 5 / direction.Z;
            Assert.That(hit.DistanceM, Is.EqualTo(eyeToPoint.Length - toScreen - 0.01).Within(1e-9));
            Assert.That(hit.ZoneProbability, Is.EqualTo(1));
            Assert.That(hit.Score, Is.EqualTo(new ZoneScoringRule().Score(hit, TestScenes.Rings, 0.9)));
        }

        [Test]
        public void ShotScorer_FirstZoneThatHoldsThePoint_Counts()
        {
            SceneModel scene = TestScenes.Of(TestScenes.Target("t", TestScenes.Rings, 0, 0, 10));
            Assert.That(Score(scene, new Vector3D(0.099, 0, 9.995), out ScoredHit hit), Is.True);
            Assert.That(hit.Zone, Is.EqualTo("10"));
            Assert.That(Score(scene, new Vector3D(0.101, 0, 9.995), out hit), Is.True);
            Assert.That(hit.Zone, Is.EqualTo("5"));
        }

        [Test]
        public void ShotScorer_CornerOfACard_DoesNotShieldWhatIsBehind()
        {
            SceneModel scene = TestScenes.Of(TestScenes.Target("front", TestScenes.Rings, 0, 0, 10), TestScenes.Target("behind", TestScenes.NoShoot, 0.6, 0.6, 12));
            Assert.That(Score(scene, new Vector3D(0.45, 0.45, 9.995), out ScoredHit hit), Is.True);
            Assert.That(hit.Target, Is.EqualTo("behind"));
            Assert.That(hit.Score, Is.EqualTo(-10));
            Assert.That(hit.DistanceM, Is.EqualTo((hit.PointM - scene.Viewpoint).Length * (1 - 5 / 16.995) - 0.01).Within(1e-3));
            Assert.That(Score(scene, new Vector3D(0, 0, 9.995), out hit), Is.True);
            Assert.That(hit.Target, Is.EqualTo("front"));
        }

        [Test]
        public void ShotScorer_MoreCardsThanPasses_GivesUp()
        {
            var objects = new SceneObject[5];
            for (int i = 0; i < 4; i++)
                objects[i] = TestScenes.Target("card " + i, TestScenes.Rings, 0, 0, 10 + i);
            objects[4] = TestScenes.Target("last", TestScenes.NoShoot, 0.6, 0.6, 15);
            SceneModel scene = TestScenes.Of(objects);
            Vector2D dot = TestScenes.DotFor(scene, new Vector3D(0.36, 0.36, 9.995));
            var patient = new ShotScorer(scene, null, new ShotScorerSettings(maxPasses: 5));
            Assert.That(patient.TryScore(dot, Certain, 0.9, null, 0, out ScoredHit hit), Is.True);
            Assert.That(hit.Target, Is.EqualTo("last"));
            var hasty = new ShotScorer(scene, null, new ShotScorerSettings(maxPasses: 4));
            Assert.That(hasty.TryScore(dot, Certain, 0.9, null, 0, out hit), Is.False);
        }

        [Test]
        public void ShotScorer_Scenery_StopsTheShot()
        {
            SceneObject wall = TestScenes.At(0, 0, 5, SceneCollider.Box(default, new Vector3D(1, 1, 0.1)));
            SceneModel scene = TestScenes.Of(wall, TestScenes.Target("t", TestScenes.Rings, 0, 0, 10));
            Assert.That(Score(scene, new Vector3D(0, 0, 10), out ScoredHit _), Is.False);
        }

        [Test]
        public void ShotScorer_BeforeTheStart_IsNotMet()
        {
            // A pane within the first centimetre behind the screen: the ray begins behind it.
            SceneObject pane = TestScenes.At(0, 0, 0.005, SceneCollider.Quad());
            SceneModel scene = TestScenes.Of(pane, TestScenes.Target("t", TestScenes.Rings, 0, 0, 10));
            Assert.That(Score(scene, new Vector3D(0, 0, 10), out ScoredHit _), Is.True);
            var early = new ShotScorer(scene, null, new ShotScorerSettings(startBehindScreenM: 0));
            Assert.That(early.TryScore(TestScenes.DotFor(scene, new Vector3D(0, 0, 10)), Certain, 0.9, null, 0, out ScoredHit _), Is.False);
        }

        [TestCase(100.0, true)]
        [TestCase(100.03, false)]
        public void ShotScorer_Reach_EndsAtAHundredMetresFromTheStart(double z, bool met)
        {
            SceneModel scene = TestScenes.Of(TestScenes.Target("t", TestScenes.Rings, 0, 0, z));
            Assert.That(Score(scene, new Vector3D(0, 0, z), out ScoredHit _), Is.EqualTo(met));
        }

        [Test]
        public void ShotScorer_MovingTarget_IsJudgedAtTheShotsTime()
        {
            var motion = new MotionPath(MotionKind.PingPong, new Vector3D(4, 0, 0), 8, 0);
            SceneModel scene = TestScenes.Of(TestScenes.Target("runner", TestScenes.Rings, new Pose(new Vector3D(-2, 0, 10), Rotation3D.Identity), motion));
            var scorer = new ShotScorer(scene);
            Vector2D dot = TestScenes.DotFor(scene, new Vector3D(0.05, 0, 10));
            Assert.That(scorer.TryScore(dot, Certain, 0.9, null, 2, out ScoredHit hit), Is.True);
            Assert.That(hit.LocalPointM.X, Is.EqualTo(0.05).Within(1e-3));
            Assert.That(scorer.TryScore(dot, Certain, 0.9, null, 2.1, out hit), Is.True);
            Assert.That(hit.LocalPointM.X, Is.EqualTo(-0.05).Within(1e-3));
            Assert.That(scorer.TryScore(dot, Certain, 0.9, null, 3, out hit), Is.False);
        }

        [Test]
        public void ShotScorer_AimRayMuzzle_FollowsTheMuzzleWhenThereIsOne()
        {
            SceneModel scene = TestScenes.Of(TestScenes.Target("seen", TestScenes.Rings, 0, 0, 10), TestScenes.Target("aimed", TestScenes.Rings, -4, -2, 10));
            var dot = new Vector2D(2, 1);

            // Screen space has y down and the muzzle in front of the screen: 2 m right of the middle, 1 m above, 5 m in front.
            Vector3D? muzzle = new Vector3D(4, 0, -5);
            var published = new ShotScorer(scene, null, new ShotScorerSettings(AimRay.Muzzle));
            Assert.That(published.TryScore(dot, Certain, 0.9, muzzle, 0, out ScoredHit hit), Is.True);
            Assert.That(hit.Target, Is.EqualTo("aimed"));
            Assert.That(published.TryScore(dot, Certain, 0.9, null, 0, out hit), Is.True);
            Assert.That(hit.Target, Is.EqualTo("seen"));
            Assert.That(new ShotScorer(scene).TryScore(dot, Certain, 0.9, muzzle, 0, out hit), Is.True);
            Assert.That(hit.Target, Is.EqualTo("seen"));
        }

        [Test]
        public void ShotScorer_SenselessInput_HitsNothing()
        {
            SceneModel scene = TestScenes.Of(TestScenes.Target("t", TestScenes.Rings, 0, 0, 10));
            var scorer = new ShotScorer(scene, null, new ShotScorerSettings(AimRay.Muzzle));
            var middle = new Vector2D(2, 1);
            Assert.That(scorer.TryScore(new Vector2D(double.NaN, 1), Certain, 0.9, null, 0, out ScoredHit _), Is.False);
            Assert.That(scorer.TryScore(middle, Certain, 0.9, null, double.NaN, out ScoredHit _), Is.False);
            Assert.That(scorer.TryScore(middle, Certain, 0.9, new Vector3D(2, 1, 1), 0, out ScoredHit _), Is.False);
            Assert.That(scorer.TryScore(middle, Certain, 0.9, new Vector3D(2, double.NaN, -1), 0, out ScoredHit _), Is.False);
            Assert.That(scorer.TryScore(middle, new Covariance2D(double.NaN, 0, 1), 0.9, null, 0, out ScoredHit hit), Is.True);
            Assert.That(hit.ZoneProbability, Is.EqualTo(0));
        }

        [Test]
        public void ShotScorer_MovedAndTurnedScreen_SeesThroughIt()
        {
            // The whole range turned and moved as one: the answers in the target's plane stay.
            var move = new Pose(new Vector3D(7, -3, 20), Rotation3D.AboutAxis(new Vector3D(1, 2, -1), 0.8));
            var card = new Pose(new Vector3D(0.5, 0.2, 9), Rotation3D.AboutAxis(new Vector3D(0, 1, 0), 0.3));
            SceneModel plain = TestScenes.Of(TestScenes.Target("t", TestScenes.Rings, card));
            var turned = new SceneModel("turned", move, TestScenes.ScreenSizeM, move.TransformPoint(TestScenes.Viewpoint), ~0,
                new[] { TestScenes.Target("t", TestScenes.Rings, move * card) });
            Covariance2D covariance = new Covariance2D(900, 200, 400);
            Vector2D dot = TestScenes.DotFor(plain, new Vector3D(0.45, 0.25, 9));
            Assert.That(new ShotScorer(plain).TryScore(dot, covariance, 0.9, null, 0, out ScoredHit a), Is.True);
            Assert.That(new ShotScorer(turned).TryScore(dot, covariance, 0.9, null, 0, out ScoredHit b), Is.True);
            Assert.That((a.LocalPointM - b.LocalPointM).Length, Is.LessThan(1e-9));
            Assert.That((move.TransformPoint(a.PointM) - b.PointM).Length, Is.LessThan(1e-9));
            Assert.That(b.ZoneProbability, Is.EqualTo(a.ZoneProbability).Within(2e-3));
        }

        [TestCase(0.0, 0.0)]
        [TestCase(0.7, 0.0)]
        [TestCase(0.4, -0.6)]
        public void ShotScorer_ZoneProbability_AgreesWithShootingManyDots(double yaw, double pitch)
        {
            Rotation3D rotation = Rotation3D.AboutAxis(new Vector3D(0, 1, 0), yaw) * Rotation3D.AboutAxis(new Vector3D(1, 0, 0), pitch);
            var pose = new Pose(new Vector3D(1.5, -0.8, 12), rotation);
            SceneModel scene = TestScenes.Of(TestScenes.Target("t", TestScenes.Rings, pose));
            var scorer = new ShotScorer(scene);
            Vector2D dot = TestScenes.DotFor(scene, pose.TransformPoint(new Vector3D(0.07, 0.05, 0)));
            var random = new Random(5);
            const double A = 0.014, B = -0.006, C = 0.009;
            Assert.That(scorer.TryScore(dot, new Covariance2D(A * A * 1e6, A * B * 1e6, (B * B + C * C) * 1e6), 0.9, null, 0, out ScoredHit hit), Is.True);
            int same = 0;
            const int Draws = 20000;
            for (int i = 0; i < Draws; i++)
            {
                double r = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())), angle = 2 * Math.PI * random.NextDouble();
                double u = r * Math.Cos(angle), v = r * Math.Sin(angle);
                var other = new Vector2D(dot.X + A * u, dot.Y + B * u + C * v);
                if (scorer.TryScore(other, Certain, 0.9, null, 0, out ScoredHit one) && one.Zone == hit.Zone)
                    same++;
            }

            Assert.That(hit.ZoneProbability, Is.GreaterThan(0.3).And.LessThan(0.99));
            Assert.That(hit.ZoneProbability, Is.EqualTo(same / (double)Draws).Within(0.02));
        }

        [Test]
        public void ShotScorer_ReplacedRule_Scores()
        {
            SceneModel scene = TestScenes.Of(TestScenes.Target("t", TestScenes.Rings, 0, 0, 10));
            var scorer = new ShotScorer(scene, new CountingRule());
            Assert.That(scorer.TryScore(new Vector2D(2, 1), Certain, 0.25, null, 0, out ScoredHit hit), Is.True);
            Assert.That(hit.Score, Is.EqualTo(10.25));
        }

        [Test]
        public void ShotScorer_Warm_AllocatesNothing()
        {
            SceneModel scene = TestScenes.Of(TestScenes.Target("front", TestScenes.Rings, 0, 0, 10), TestScenes.Target("behind", TestScenes.NoShoot, 0.6, 0.6, 12),
                TestScenes.At(0, 0, 20, SceneCollider.Sphere(default, 3), SceneCollider.Capsule(default, 1, 4, 1), SceneCollider.Quad()));
            var scorer = new ShotScorer(scene);
            Covariance2D covariance = Covariance2D.Isotropic(2);
            int hits = 0;
            long allocated = Allocation.Of(() =>
            {
                for (int i = 0; i < 300; i++)
                {
                    if (scorer.TryScore(new Vector2D(1.8 + 0.004 * (i % 100), 0.9), covariance, 0.8, null, i / 100, out ScoredHit _))
                        hits++;
                }
            });
            Assert.That(allocated, Is.EqualTo(0));
            Assert.That(hits, Is.GreaterThan(100));
        }

        private static bool Score(SceneModel scene, Vector3D scenePoint, out ScoredHit hit) =>
            new ShotScorer(scene).TryScore(TestScenes.DotFor(scene, scenePoint), Certain, 0.9, null, 0, out hit);

        private sealed class CountingRule : IScoringRule
        {
            public double Score(in ScoredHit hit, TargetDefinition target, double confidence) => hit.Points + confidence;
        }
    }
}
