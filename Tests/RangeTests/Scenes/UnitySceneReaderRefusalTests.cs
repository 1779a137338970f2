using System;
using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host.Scenes;
using LaserTracking.Scoring;
using NUnit.Framework;

namespace LaserTracking.Scenes
{
    /// <summary>Every way in which a scene can be unusable gives one line: file, object, field, remedy.</summary>
    public sealed class UnitySceneReaderRefusalTests
    {
        private const string MotionGuid = "ce71f8e935d783cc490767973868b6e6";
        private SceneSandbox _sandbox = null!;

        [SetUp]
        public void SetUp() => _sandbox = new SceneSandbox();

        [TearDown]
        public void TearDown() => _sandbox.Dispose();

        [Test]
        public void UnitySceneReader_UndamagedCopy_IsRead() => Assert.That(_sandbox.Read().Objects.Count, Is.GreaterThan(10));

        [Test]
        public void UnitySceneReader_MissingFileOrFolder_IsRefused()
        {
            Assert.That(() => UnitySceneReader.Read(_sandbox.PathOf("none.unity")), Throws.TypeOf<InputException>().With.Message.Contains("no such file"));
            Assert.That(() => UnitySceneReader.Read(_sandbox.PathOf("Assets")), Throws.TypeOf<InputException>().With.Message.Contains("is a folder"));
            Assert.That(() => UnitySceneReader.Read(_sandbox.PathOf("no/where/none.unity")), Throws.TypeOf<InputException>());
        }

        [TestCase("", "empty")]
        [TestCase("hello\n", "not a scene")]
        [TestCase("\0\0\u0001binary", "not a scene")]
        [TestCase("version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "git lfs pull")]
        [TestCase("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n", "no object")]
        [TestCase("%YAML 1.1\n--- !u!one &1\nGameObject:\n", "line 2: not a document head")]
        [TestCase("%YAML 1.1\n--- !u!1 &1\nGameObject:\n  m_Name: {\n", "broken YAML in line")]
        [TestCase("%YAML 1.1\n--- !u!1 &1\n- a\n", "not one mapping")]
        [TestCase("%YAML 1.1\n--- !u!1 &1\nGameObject: 5\n", "not one mapping")]
        public void UnitySceneReader_NotAScene_IsRefused(string text, string what)
        {
            _sandbox.Text = text;
            _sandbox.ExpectRefusal(what);
        }

        [Test]
        public void UnitySceneReader_UnknownClass_IsRefused()
        {
            _sandbox.ReplaceIn("Popper 1", "--- !u!65 &", "--- !u!54 &");
            _sandbox.ExpectRefusal("unknown class 54 (BoxCollider)", "remove that component");
        }

        [Test]
        public void UnitySceneReader_UnknownScript_IsRefused()
        {
            _sandbox.ReplaceIn("Runner", MotionGuid, "0123456789abcdef0123456789abcdef");
            _sandbox.ExpectRefusal("object \"Targets/Runner\", MonoBehaviour", "unknown component class", "0123456789abcdef0123456789abcdef");
        }

        [TestCase("Runner", "_periodS", "_period", "object \"Targets/Runner\", TargetMotion: unknown field _period")]
        [TestCase("Runner", "  _phaseS: 0\n", "", "object \"Targets/Runner\", TargetMotion: field _phaseS is missing")]
        [TestCase("Runner", "_periodS: 7", "_periodS: 0", "_periodS is not above zero")]
        [TestCase("Runner", "_periodS: 7", "_periodS: soon", "_periodS is \"soon\"")]
        [TestCase("Runner", "_kind: 1", "_kind: 9", "no MotionKind has")]
        [TestCase("Runner", "_travelM: {x: 4.4, y: 0, z: 0}", "_travelM: {x: NaN, y: 0, z: 0}", "_travelM.x is \"NaN\"")]
        [TestCase("Runner", "_travelM: {x: 4.4, y: 0, z: 0}", "_travelM: 3", "_travelM is not {x, y, z}")]
        [TestCase("Laser Range", "_hitLayers:\n    serializedVersion: 2\n    m_Bits: 257", "_hitLayers:\n    serializedVersion: 2\n    m_Bits: -1", "_hitLayers.m_Bits")]
        [TestCase("Laser Range", "_hitLayers", "_hitLayer", "LaserRange: unknown field _hitLayer")]
        [TestCase("Screen", "_sizeM: {x: 3.73, y: 2.26}", "_sizeM: {x: 3.73, y: 0}", "_sizeM is not above zero")]
        [TestCase("Popper 1", "m_Layer: 8", "m_Layer: 32", "m_Layer is 32")]
        [TestCase("Popper 1", "m_IsActive: 1", "m_IsActive: 2", "m_IsActive is 2")]
        [TestCase("Popper 1", "m_LocalPosition: {x: -1.7", "m_LocalPosition: {x: .nan", "object \"Targets/Popper 1\", Transform: field m_LocalPosition.x")]
        [TestCase("Popper 1", "m_LocalPosition: {x: -1.7", "m_LocalPosition: {x: 1e999", "m_LocalPosition.x")]
        [TestCase("Popper 1", "m_LocalRotation: {x: 0, y: 0, z: 0, w: 1}", "m_LocalRotation: {x: 0, y: 0, z: 0, w: 0}", "not a unit quaternion")]
        [TestCase("Popper 1", "m_Size: {x: 0.3048", "m_Size: {x: -0.3048", "BoxCollider: field m_Size is not above zero")]
        [TestCase("Popper 1", "  m_IsTrigger: 0\n", "", "m_IsTrigger is missing")]
        [TestCase("Popper 1", "m_Size", "m_Siez", "m_Size is missing")]
        [TestCase("Swinging Ball", "m_LocalScale: {x: 0.25, y: 0.25, z: 0.25}", "m_LocalScale: {x: 0.25, y: 0.5, z: 0.25}", "SphereCollider: a sphere under an uneven scale")]
        [TestCase("Swinging Ball", "m_LocalScale: {x: 0.25, y: 0.25, z: 0.25}", "m_LocalScale: {x: 0.25, y: 0, z: 0.25}", "a scale of zero")]
        [TestCase("Swinging Ball", "m_Radius: 0.5", "m_Radius: 0", "m_Radius is not above zero")]
        [TestCase("Bottle 1", "m_Direction: 1", "m_Direction: 3", "m_Direction is 3")]
        [TestCase("Backdrop", "m_CookingOptions: 30\n  m_Mesh: {fileID: 10210", "m_CookingOptions: 30\n  m_Mesh: {fileID: 10209", "only the built-in Quad")]
        [TestCase("Targets", "m_LocalScale: {x: 1, y: 1, z: 1}", "m_LocalScale: {x: 2, y: 1, z: 1}", "sheared")]
        [TestCase("Viewpoint", "m_LocalPosition: {x: 0, y: 1.63, z: -5}", "m_LocalPosition: {x: 0, y: 1.63, z: 5}", "not in front of the screen")]
        [TestCase("Viewpoint", "m_IsActive: 1", "m_IsActive: 0", "_viewpoint refers to an inactive object")]
        [TestCase("Laser Range", "m_IsActive: 1", "m_IsActive: 0", "no active LaserRange")]
        [TestCase("Popper 2", "m_Name: Popper 2", "m_Name: Popper 1", "a second target of that name")]
        [TestCase("Popper 1", "  m_Enabled: 1\n  serializedVersion: 3", "  m_Enabled: 0\n  serializedVersion: 3", "no enabled collider")]
        [TestCase("Screen", "_calibration", "_calibratoin", "unknown field _calibratoin")]
        public void UnitySceneReader_DamagedField_IsRefused(string name, string old, string by, string what)
        {
            if (old.StartsWith("m_Name", StringComparison.Ordinal))
                _sandbox.Replace("  " + old + "\n", "  " + by + "\n");
            else
                _sandbox.ReplaceIn(name, old, by);
            _sandbox.ExpectRefusal(what);
        }

        [Test]
        public void UnitySceneReader_EmptyReference_IsRefused()
        {
            string screen = LineOf("_screen"), view = LineOf("_viewpoint");
            _sandbox.Replace(screen, "  _screen: {fileID: 0}");
            _sandbox.ExpectRefusal("LaserRange: field _screen is empty", "assign a ScreenSurface");
            _sandbox.Replace("  _screen: {fileID: 0}", screen);
            _sandbox.Replace(view, "  _viewpoint: {fileID: 12345}");
            _sandbox.ExpectRefusal("LaserRange: field _viewpoint refers to nothing");
        }

        [Test]
        public void UnitySceneReader_MissingAssetOrMeta_IsRefused()
        {
            File.Delete(_sandbox.PathOf("Assets/Targets/Popper.asset"));
            _sandbox.ExpectRefusal("Popper.asset", "no such file");
            File.Delete(_sandbox.PathOf("Assets/Targets/Popper.asset.meta"));
            _sandbox.ExpectRefusal("LaserTarget: field _definition: no asset of the project has the guid");
            string definition = LineOf("_definition");
            _sandbox.Replace(definition, "  _definition: {fileID: 0}");
            _sandbox.ExpectRefusal("field _definition is empty");
        }

        [TestCase("_kind: 2", "_kind: 7", "no TargetKind has")]
        [TestCase("_sizeM: {x: 0.4572", "_sizeM: {x: 0", "width and height")]
        [TestCase("points: 5", "points: five", "_zones entry 0: field points is \"five\"")]
        [TestCase("shape: 1", "shape: 3", "no ZoneShape has")]
        [TestCase("    centerM: {x: 0", "    center: {x: 0", "_zones entry 0: unknown field center")]
        [TestCase("sizeM: {x: 0.15, y: 0.28}", "sizeM: {x: 0.15, y: -1}", "zone A: width and height")]
        [TestCase("c05170ce6f0de0e4fcd39d93f0e24e3e", "c3e9f9eb2bfb6c8c8c75d334ce0696af", "is not TargetDefinitionAsset")]
        [TestCase("&11400000", "&11400001", "holds no target definition")]
        [TestCase("_zones:", "_zone:", "unknown field _zone")]
        public void UnitySceneReader_DamagedDefinition_IsRefused(string old, string by, string what)
        {
            _sandbox.ReplaceInAsset("Assets/Targets/Silhouette.asset", old, by);
            _sandbox.ExpectRefusal("Silhouette.asset", what);
        }

        [Test]
        public void UnitySceneReader_PrefabInstance_IsRefused()
        {
            string plain = _sandbox.Text;
            _sandbox.Text = plain + "--- !u!1001 &77\nPrefabInstance:\n  m_ObjectHideFlags: 0\n";
            _sandbox.ExpectRefusal("a prefab instance", "Unpack");
            _sandbox.Text = plain + "--- !u!4 &78 stripped\nTransform:\n  m_PrefabInstance: {fileID: 77}\n";
            _sandbox.ExpectRefusal("a prefab instance");
        }

        [Test]
        public void UnitySceneReader_LinksThatDisagree_AreRefused()
        {
            string plain = _sandbox.Text;
            string head = plain.Split('\n').First(line => line.StartsWith("--- !u!65 &", StringComparison.Ordinal));
            string id = head.Split('&')[1];
            _sandbox.Text = plain.Replace(head, "--- !u!65 &424242", StringComparison.Ordinal);
            _sandbox.ExpectRefusal("component " + id + " is not in the file");
            _sandbox.Text = plain + head + "\nBoxCollider:\n  m_Enabled: 1\n";
            _sandbox.ExpectRefusal("the id " + id + " is used twice");
            _sandbox.Text = plain.Replace("  - component: {fileID: " + id + "}\n", "", StringComparison.Ordinal);
            _sandbox.ExpectRefusal("nothing in the hierarchy refers to it");
            _sandbox.Text = plain;
            _sandbox.ReplaceIn("Popper 1", "m_Father: {fileID: ", "m_Father: {fileID: 9");
            _sandbox.ExpectRefusal("m_Father and the parent's list of children disagree");
            _sandbox.Text = plain;
            _sandbox.Replace("SceneRoots:\n  m_ObjectHideFlags: 0\n  m_Roots:\n", "SceneRoots:\n  m_ObjectHideFlags: 0\n  m_Roots:\n  - {fileID: 31}\n");
            _sandbox.ExpectRefusal("SceneRoots", "31");
        }

        [Test]
        public void UnitySceneReader_OwnScriptOnATarget_IsRefusedAndElsewhereLeftAlone()
        {
            const string Guid = "0123456789abcdef0123456789abcdef";
            File.WriteAllText(_sandbox.PathOf("Assets/Mover.cs"), "");
            File.WriteAllText(_sandbox.PathOf("Assets/Mover.cs.meta"), "fileFormatVersion: 2\nguid: " + Guid + "\n");
            string plain = _sandbox.Text;
            AddScript("Main Camera", Guid);
            Assert.That(_sandbox.Read().Objects.Count, Is.GreaterThan(10));
            _sandbox.Text = plain;
            AddScript("Popper 1", Guid);
            _sandbox.ExpectRefusal("Targets/Popper 1", "Assets/Mover.cs may move");
        }

        [Test]
        public void UnitySceneReader_MotionInsideMotion_IsRefused()
        {
            AddScript("Targets", MotionGuid, "  _kind: 2\n  _travelM: {x: 1, y: 0, z: 0}\n  _periodS: 3\n  _phaseS: 0\n");
            _sandbox.ExpectRefusal("moves inside \"Targets\", which moves too");
        }

        [Test]
        public void UnitySceneReader_TwoRanges_AreRefused()
        {
            AddScript("Targets", "b33198d265cad9bf2143c3cead4383f8", "  _screen: {fileID: 0}\n  _viewpoint: {fileID: 0}\n  _hitLayers:\n    m_Bits: 1\n  _source: {fileID: 0}\n");
            _sandbox.ExpectRefusal("second active LaserRange");
        }

        [Test]
        public void UnitySceneReader_ColliderThatMovesInItsTarget_IsRefused()
        {
            int at = _sandbox.Text.IndexOf("  m_Name: Circle\n", StringComparison.Ordinal);
            int id = _sandbox.Text.LastIndexOf("--- !u!1 &", at, StringComparison.Ordinal) + 10;
            string owner = _sandbox.Text[id.._sandbox.Text.IndexOf('\n', id)];
            AddComponent("Circle", "--- !u!65 &4711\nBoxCollider:\n  m_GameObject: {fileID: " + owner
                + "}\n  m_IsTrigger: 0\n  m_Enabled: 1\n  m_Size: {x: 1, y: 1, z: 1}\n  m_Center: {x: 0, y: 0, z: 0}\n", 4711);
            SceneObject popper = _sandbox.Read().Objects.Single(found => found.Name == "Popper 1");
            Assert.That(popper.Colliders.Count, Is.EqualTo(2));
            Assert.That(popper.Colliders[1].IsOnChild, Is.True);
            Assert.That(popper.Colliders[1].ChildLayer, Is.EqualTo(8));
            Assert.That((popper.Colliders[1].ChildPose.Position - new Vector3D(0, 0.381, 0)).Length, Is.LessThan(1e-9));
            Assert.That((popper.Colliders[1].ChildPose.TransformDirection(new Vector3D(0, 1, 0)) - new Vector3D(0, 0, 1)).Length, Is.LessThan(1e-6));
            Assert.That((popper.Colliders[1].ChildScale - new Vector3D(0.3048, 0.001, 0.3048)).Length, Is.LessThan(1e-9));
            AddScript("Circle", MotionGuid, "  _kind: 2\n  _travelM: {x: 1, y: 0, z: 0}\n  _periodS: 3\n  _phaseS: 0\n");
            _sandbox.ExpectRefusal("has a collider of the target \"Targets/Popper 1\" and moves in it");
        }

        [Test]
        public void UnitySceneReader_CutAnywhere_IsReadOrRefusedButNeverCrashes()
        {
            string plain = _sandbox.Text;
            for (int i = 1; i <= 40; i++)
            {
                _sandbox.Text = plain[..(plain.Length * i / 41)];
                Assert.That(() => _sandbox.Read(), Throws.TypeOf<InputException>(), "cut at " + _sandbox.Text.Length);
            }
        }

        private string LineOf(string field) => _sandbox.Text.Split('\n').First(line => line.StartsWith("  " + field + ":", StringComparison.Ordinal));

        private void AddScript(string objectName, string guid, string fields = "")
        {
            int at = _sandbox.Text.IndexOf("  m_Name: " + objectName + "\n", StringComparison.Ordinal);
            int id = _sandbox.Text.LastIndexOf("--- !u!1 &", at, StringComparison.Ordinal) + 10;
            string owner = _sandbox.Text[id.._sandbox.Text.IndexOf('\n', id)];
            AddComponent(objectName, "--- !u!114 &4712\nMonoBehaviour:\n  m_GameObject: {fileID: " + owner
                + "}\n  m_Enabled: 1\n  m_Script: {fileID: 11500000, guid: " + guid + ", type: 3}\n" + fields, 4712);
        }

        private void AddComponent(string objectName, string document, long id)
        {
            int at = _sandbox.Text.IndexOf("  m_Name: " + objectName + "\n", StringComparison.Ordinal);
            int list = _sandbox.Text.LastIndexOf("  m_Component:\n", at, StringComparison.Ordinal);
            int end = _sandbox.Text.IndexOf("  m_Layer:", list, StringComparison.Ordinal);
            _sandbox.Text = _sandbox.Text[..end] + "  - component: {fileID: " + id + "}\n" + _sandbox.Text[end..] + document;
        }
    }
}
