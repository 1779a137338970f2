using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using LaserTracking.Geometry;
using LaserTracking.Host.Scenes;
using LaserTracking.Scoring;
using NUnit.Framework;

namespace LaserTracking.Scenes
{
    /// <summary>Scenes other than the shipped one: hierarchy, scale, activity, motion.</summary>
    public sealed class UnitySceneReaderTests
    {
        private readonly string _path = Path.Combine(Path.GetTempPath(), "range-" + Guid.NewGuid().ToString("N") + ".unity");

        [TearDown]
        public void TearDown() => File.Delete(_path);

        [Test]
        public void UnitySceneReader_SceneWithoutTargets_IsRead()
        {
            SceneModel scene = Read(new SceneText());
            Assert.That(scene.Objects, Is.Empty);
            Assert.That(scene.Viewpoint, Is.EqualTo(new Vector3D(0, 0, -5)));
            Assert.That(scene.LayerMask, Is.EqualTo(-1));
        }

        [Test]
        public void UnitySceneReader_NestedTransforms_AgreeWithMatrices()
        {
            var random = new Random(5);
            for (int i = 0; i < 40; i++)
            {
                var text = new SceneText();
                Matrix4x4 world = Matrix4x4.Identity;
                int node = -1;
                for (int level = 0; level < 4; level++)
                {
                    var position = new Vector3(Next(random, -3, 3), Next(random, -3, 3), Next(random, -3, 3));
                    Quaternion rotation = Quaternion.Normalize(new Quaternion(Next(random, -1, 1), Next(random, -1, 1), Next(random, -1, 1), Next(random, -1, 1)));

                    // Uneven scale only at the lowest level: above, a rotated child would be sheared.
                    float even = Next(random, 0.5f, 2);
                    Vector3 scale = level == 3 ? new Vector3(Next(random, 0.5f, 2), Next(random, -2, -0.5f), Next(random, 0.5f, 2)) : new Vector3(even);
                    node = text.Add("Level " + level, node, Mapping(position), Mapping(rotation), Mapping(scale));
                    world = Matrix4x4.CreateScale(scale) * Matrix4x4.CreateFromQuaternion(rotation) * Matrix4x4.CreateTranslation(position) * world;
                }

                text.Box(node);
                SceneObject read = Read(text).Objects.Single();
                for (int corner = 0; corner < 8; corner++)
                {
                    var local = new Vector3(corner % 2 - 0.5f, corner / 2 % 2 - 0.5f, corner / 4 - 0.5f);
                    Vector3 expected = Vector3.Transform(local, world);
                    Vector3D actual = read.PoseAt(0).TransformPoint(Vector3D.Scale(read.Scale, new Vector3D(local.X, local.Y, local.Z)));
                    Assert.That((actual - new Vector3D(expected.X, expected.Y, expected.Z)).Length, Is.LessThan(1e-4), "case " + i);
                }
            }
        }

        [Test]
        public void UnitySceneReader_QuarterTurnUnderUnevenScale_IsNoShear()
        {
            var text = new SceneText();
            int parent = text.Add("Parent", -1, scale: "{x: 2, y: 3, z: 4}");
            text.Box(text.Add("Child", parent, rotation: "{x: 0, y: 0.7071068, z: 0, w: 0.7071068}"));
            SceneObject read = Read(text).Objects.Single();
            Assert.That((read.Scale - new Vector3D(4, 3, 2)).Length, Is.LessThan(1e-5));
        }

        [Test]
        public void UnitySceneReader_TurnedChildUnderUnevenScale_IsRefused()
        {
            var text = new SceneText();
            int parent = text.Add("Parent", -1, scale: "{x: 2, y: 3, z: 4}");
            text.Box(text.Add("Child", parent, rotation: "{x: 0, y: 0.2588190, z: 0, w: 0.9659258}"));
            Assert.That(() => Read(text), Throws.TypeOf<InputException>().With.Message.Contains("object \"Parent/Child\", BoxCollider: is sheared"));
        }

        [Test]
        public void UnitySceneReader_InactiveOrDisabled_IsLeftOut()
        {
            var text = new SceneText();
            int off = text.Add("Off", -1, active: false);
            text.Box(text.Add("Below", off));
            text.Box(text.Add("Disabled"), enabled: false);
            int mixed = text.Add("Mixed");
            text.Box(mixed, enabled: false);
            text.Box(mixed, trigger: true);
            SceneModel scene = Read(text);
            Assert.That(scene.Objects.Select(found => found.Name), Is.EqualTo(new[] { "Mixed" }));
            Assert.That(scene.Objects[0].Colliders.Single().IsTrigger, Is.True);
            Assert.That(scene.Objects[0].Layer, Is.EqualTo(3));
        }

        [Test]
        public void UnitySceneReader_DisabledTargetAndMotion_AreScenery()
        {
            var text = new SceneText();
            int node = text.Add("Card");
            text.Box(node);
            text.Script(node, SceneText.TargetGuid, "  _definition: {fileID: 0}\n", enabled: false);
            text.Motion(node, "{x: 1, y: 0, z: 0}", enabled: false);
            SceneObject read = Read(text).Objects.Single();
            Assert.That(read.Target, Is.Null);
            Assert.That(read.Motion.Kind, Is.EqualTo(MotionKind.None));
        }

        [Test]
        public void UnitySceneReader_MotionBelowAScaledAndTurnedParent_MovesAlongItsAxes()
        {
            // The parent's x points along the world's −z (a quarter turn about y) and is stretched by 2.
            var text = new SceneText();
            int parent = text.Add("Rail", -1, "{x: 1, y: 2, z: 3}", "{x: 0, y: 0.7071068, z: 0, w: 0.7071068}", "{x: 2, y: 2, z: 2}");
            int carrier = text.Add("Carrier", parent);
            text.Motion(carrier, "{x: 1.5, y: 0, z: 0}");
            text.Box(carrier);
            text.Box(text.Add("Rider", carrier, "{x: 0, y: 1, z: 0}"));
            SceneModel scene = Read(text);
            Vector3D offset = scene.Objects[0].PoseAt(1.5).Position - scene.Objects[0].RestPose.Position;
            Assert.That((offset - new Vector3D(0, 0, -3)).Length, Is.LessThan(1e-5));
            Vector3D rider = scene.Objects[1].PoseAt(1.5).Position;
            Assert.That((rider - new Vector3D(1, 4, 0)).Length, Is.LessThan(1e-5));
        }

        [Test]
        public void UnitySceneReader_ColliderOnAChild_BelongsToTheTargetAbove()
        {
            // The same plate twice: as a turned, scaled child of a turned, scaled parent, and as scenery of its own at that place.
            var text = new SceneText();
            const string Position = "{x: 0.5, y: -0.3, z: 6}", Turn = "{x: 0.2588190, y: 0, z: 0, w: 0.9659258}", Even = "{x: 2, y: 2, z: 2}";
            int disabled = text.Add("Parent", -1, Position, Turn, Even);
            text.Script(disabled, SceneText.TargetGuid, "  _definition: {fileID: 0}\n  _hit:\n    m_PersistentCalls:\n      m_Calls: []\n", enabled: false);
            int child = text.Add("Child", disabled, "{x: 0.1, y: 0.2, z: 0}", "{x: 0, y: 0.3826834, z: 0, w: 0.9238795}", "{x: 0.5, y: 1, z: 0.1}");
            text.Box(child);
            SceneModel scenery = Read(text);
            Assert.That(scenery.Objects.Single().Name, Is.EqualTo("Child"), "of a disabled target: scenery");

            string enabled = text.ToString().Replace("m_Enabled: 0", "m_Enabled: 1", StringComparison.Ordinal);
            File.WriteAllText(_path, enabled);
            Assert.That(() => UnitySceneReader.Read(_path), Throws.TypeOf<InputException>().With.Message.Contains("\"Parent\", LaserTarget: field _definition is empty"));

            SceneObject plain = scenery.Objects[0];
            var parent = new SceneObject("Parent", 8, new Pose(new Vector3D(0.5, -0.3, 6), new Rotation3D(0.2588190, 0, 0, 0.9659258)), new Vector3D(2, 2, 2),
                Rotation3D.Identity, default, new[] { plain.Colliders[0].OnChild(ChildPose(plain), plain.Scale, plain.Layer) }, null);
            var direct = new AnalyticRaycaster(scenery);
            var through = new AnalyticRaycaster(new SceneModel("child", Pose.Identity, scenery.ScreenSizeM, scenery.Viewpoint, 1 << 3, new[] { parent }));
            var random = new Random(2);
            int hits = 0;
            for (int i = 0; i < 500; i++)
            {
                var ray = new Ray3D(scenery.Viewpoint, new Vector3D(Next(random, 0, 1.4f), Next(random, -1.5f, 1.5f), 11));
                bool found = direct.TryRaycast(ray, 100, 0, out RaycastHit expected);
                Assert.That(through.TryRaycast(ray, 100, 0, out RaycastHit actual), Is.EqualTo(found));
                if (!found)
                    continue;
                hits++;
                Assert.That((actual.PointM - expected.PointM).Length, Is.LessThan(1e-9));
                Assert.That((actual.Normal - expected.Normal).Length, Is.LessThan(1e-9));
                Assert.That((parent.RestPose.TransformPoint(actual.LocalPointM) - expected.PointM).Length, Is.LessThan(1e-9), "in the parent's axes");
            }

            Assert.That(hits, Is.InRange(50, 450));

            Pose ChildPose(SceneObject seen)
            {
                var above = new Pose(new Vector3D(0.5, -0.3, 6), new Rotation3D(0.2588190, 0, 0, 0.9659258));
                return new Pose(above.InverseTransformPoint(seen.RestPose.Position), above.Rotation.Inverse * seen.RestPose.Rotation);
            }
        }

        [Test]
        public void UnitySceneReader_ScaledScreen_KeepsItsSizeInMetres()
        {
            string text = new SceneText().ToString();
            int rig = text.IndexOf("m_Name: Rig", StringComparison.Ordinal);
            File.WriteAllText(_path, text[..rig] + text[rig..].Replace("m_LocalScale: {x: 1, y: 1, z: 1}", "m_LocalScale: {x: 2, y: 2, z: 2}", StringComparison.Ordinal));
            SceneModel scene = UnitySceneReader.Read(_path);
            Assert.That(scene.ScreenSizeM, Is.EqualTo(new Vector2D(3.73, 2.26)));
            Assert.That((scene.Surface.TransformPoint(new Vector3D(1, 0, 0)) - scene.Surface.Position).Length, Is.EqualTo(1).Within(1e-12));
        }

        [TestCase(true, "First,Second,Third")]
        [TestCase(false, "Third,First,Second")]
        public void UnitySceneReader_Roots_ComeInTheirOrder(bool sceneRoots, string expected)
        {
            var text = new SceneText { WithSceneRoots = sceneRoots };
            int first = text.Add("First");
            text.Box(first);
            text.Box(text.Add("Second", first));
            text.Box(text.Add("Third"));
            Assert.That(string.Join(',', Read(text).Objects.Select(found => found.Name)), Is.EqualTo(expected));
        }

        [Test]
        public void UnitySceneReader_WindowsLineEndings_AreRead()
        {
            var text = new SceneText();
            text.Box(text.Add("Wall"));
            File.WriteAllText(_path, text.ToString().Replace("\n", "\r\n", StringComparison.Ordinal));
            Assert.That(UnitySceneReader.Read(_path).Objects.Count, Is.EqualTo(1));
        }

        [Test]
        public void UnitySceneReader_VeryDeepHierarchyOrYaml_IsRefused()
        {
            var text = new SceneText();
            int node = -1;
            for (int i = 0; i < 400; i++)
                node = text.Add("Deep", node);
            Assert.That(() => Read(text), Throws.TypeOf<InputException>().With.Message.Contains("levels deep"));

            string nested = new string('[', 200000);
            File.WriteAllText(_path, new SceneText().ToString().Replace("m_Name: Rig", "m_Name: " + nested, StringComparison.Ordinal));
            Assert.That(() => UnitySceneReader.Read(_path), Throws.TypeOf<InputException>());
        }

        [Test]
        public void UnitySceneReader_RandomlyDamagedScenes_AreReadOrRefusedButNeverCrash()
        {
            var text = new SceneText();
            int parent = text.Add("Parent", -1, "{x: 1, y: 2, z: 3}");
            text.Motion(parent, "{x: 1, y: 0, z: 0}");
            text.Box(text.Add("Child", parent));
            string plain = text.ToString();
            var random = new Random(17);
            const string Alphabet = "{}[]:,-&*!|>'\"%@` \n0123456789abcxyzNm_#?\t\0";
            int refused = 0;
            for (int i = 0; i < 1000; i++)
            {
                char[] damaged = plain.ToCharArray();
                for (int k = random.Next(1, 4); k > 0; k--)
                    damaged[random.Next(damaged.Length)] = Alphabet[random.Next(Alphabet.Length)];
                string result = new string(damaged);
                if (random.Next(4) == 0)
                    result = result.Remove(random.Next(result.Length / 2), random.Next(result.Length / 2));
                File.WriteAllText(_path, result);
                try
                {
                    UnitySceneReader.Read(_path);
                }
                catch (InputException e)
                {
                    refused++;
                    Assert.That(e.Message, Does.Not.Contain("\n").And.Not.Contain("\r"), "case " + i);
                }
            }

            Assert.That(refused, Is.InRange(200, 999));
        }

        private SceneModel Read(SceneText text)
        {
            File.WriteAllText(_path, text.ToString());
            return UnitySceneReader.Read(_path);
        }

        private static float Next(Random random, float low, float high) => low + (high - low) * (float)random.NextDouble();

        private static string Mapping(Vector3 v) => string.Create(CultureInfo.InvariantCulture, $"{{x: {v.X}, y: {v.Y}, z: {v.Z}}}");

        private static string Mapping(Quaternion q) => string.Create(CultureInfo.InvariantCulture, $"{{x: {q.X}, y: {q.Y}, z: {q.Z}, w: {q.W}}}");
    }
}
