using System;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>Scenes that the shipped one is not; that one is compared as a whole in ShippedSimulationTests.</summary>
    public sealed class SceneModelBuilderTests : StandInTests
    {
        [Test]
        public void Build_TargetOfParts_TakesThemInItsAxesAndLeavesOutWhatIsOff()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            LaserTarget target = RangeRig.AddPlate("Plate", new Vector3(0, 0, 4), 0.5f);
            target.gameObject.SetActive(true);
            GameObject part = GameObject.CreatePrimitive(PrimitiveType.Sphere);
            part.transform.SetParent(target.transform, false);
            part.transform.localScale = new Vector3(1, 1, 50);
            part.transform.localPosition = new Vector3(2, 0, 0);
            part.AddComponent<BoxCollider>().enabled = false;
            RangeRig.AddPlate("Off", new Vector3(0, 0, 5), 0.5f);
            SceneObject only = SceneModelBuilder.Build(rig.Range).Objects.Single();
            Assert.That(only.Name, Is.EqualTo("Plate"));
            Assert.That(only.Colliders.Select(collider => collider.Shape), Is.EqualTo(new[] { ColliderShape.Box, ColliderShape.Sphere }));
            Assert.That((only.Colliders[1].ChildPose.Position - new Vector3D(1, 0, 0)).Length, Is.LessThan(1e-6), "metres, not the plate's units");
        }

        [Test]
        public void Build_MotionBelowTurnedAndScaledParent_MovesAsUnityDoes()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            var parent = new GameObject("rail");
            parent.transform.localRotation = Quaternion.Euler(0, 90, 0);
            parent.transform.localScale = new Vector3(2, 2, 2);
            LaserTarget target = RangeRig.AddPlate("Runner", new Vector3(1, 0, 4), 0.5f);
            TargetMotion motion = target.gameObject.AddComponent<TargetMotion>();
            SerializedFields.Set(motion, "_kind", MotionKind.Sine);
            SerializedFields.Set(motion, "_travelM", new Vector3(1, 0, 0));
            target.transform.SetParent(parent.transform, true);
            target.gameObject.SetActive(true);
            PlayerLoop.Step(0.7);
            SceneObject runner = SceneModelBuilder.Build(rig.Range).Objects.Single();
            foreach (double timeS in new[] { 0, 0.7, 3.1 })
                Assert.That((runner.PoseAt(timeS).Position - motion.PoseAt(timeS).Position).Length, Is.LessThan(1e-5));
        }

        [TestCase("sphere", "uneven scale")]
        [TestCase("sheared", "sheared")]
        [TestCase("script", "Recorder")]
        [TestCase("rigidbody", "Rigidbody")]
        [TestCase("convex", "no box, sphere, capsule or built-in quad")]
        [TestCase("name", "a second target of that name")]
        [TestCase("definition", "no usable definition")]
        [TestCase("nested", "moves too")]
        [TestCase("part", "moves in it")]
        [TestCase("bare", "no enabled collider")]
        [TestCase("behind", "not in front of the screen")]
        [TestCase("viewpoint", "no viewpoint")]
        public void Build_WhatTheHeadlessReaderRefuses_IsRefused(string what, string expected)
        {
            var rig = new RangeRig(new StubSource(1, 0));
            LaserTarget target = RangeRig.AddPlate("Plate", new Vector3(0, 0, 4), 0.5f);
            target.gameObject.SetActive(true);
            Assert.That(SceneModelBuilder.Build(rig.Range).Objects, Has.Count.EqualTo(1), "nothing wrong so far");
            Spoil(rig, target, what);
            var problem = Assert.Throws<InputException>(() => SceneModelBuilder.Build(rig.Range));
            Assert.That(problem!.Message, Does.Contain(expected));
            Assert.That(problem.Message, Does.StartWith("object \"").And.Not.Contain("\n"));
        }

        [Test]
        public void LaserRange_SimulationOfASceneThatCannotBeTaken_SaysWhyAndPlaysOn()
        {
            var rig = new RangeRig(new StubSource(1, 0), withCalibration: false);
            SimulationSource source = ScriptableObject.CreateInstance<SimulationSource>();
            source.name = "Simulation";
            SerializedFields.Set(rig.Range, "_source", source);
            rig.Play(0.1);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.StartWith("simulation source Simulation: has no scenario"));
            ConsoleLog.Clear();
            SerializedFields.Set(source, "_scenario", new TextAsset("{\"shooters\":[{}],\"shots\":[{\"time_s\":1,\"target\":\"Plate\"}]}"));
            rig.Range.enabled = false;
            rig.Range.enabled = true;
            rig.Play(0.1);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.Contain("\"Plate\", which the scene does not have"));
            Assert.That(rig.Range.IsRunning, Is.False);
        }

        private static void Spoil(RangeRig rig, LaserTarget target, string what)
        {
            switch (what)
            {
                case "sphere":
                    target.gameObject.AddComponent<SphereCollider>();
                    break;
                case "sheared":
                    target.transform.SetParent(Parent(new Vector3(1, 2, 1)), false);
                    target.transform.localRotation = Quaternion.Euler(0, 0, 30);
                    break;
                case "script":
                    target.transform.SetParent(Parent(Vector3.one), false);
                    target.transform.parent!.gameObject.AddComponent<Recorder>();
                    break;
                case "rigidbody":
                    target.gameObject.AddComponent<Rigidbody>();
                    break;
                case "convex":
                    GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
                    quad.GetComponent<MeshCollider>().convex = true;
                    break;
                case "name":
                    RangeRig.AddPlate("Plate", new Vector3(1, 0, 4), 0.5f).gameObject.SetActive(true);
                    break;
                case "definition":
                    GameObject.CreatePrimitive(PrimitiveType.Cube).AddComponent<LaserTarget>();
                    break;
                case "nested":
                    Move(target.gameObject);
                    target.transform.SetParent(Parent(Vector3.one), false);
                    Move(target.transform.parent!.gameObject);
                    break;
                case "part":
                    GameObject part = GameObject.CreatePrimitive(PrimitiveType.Cube);
                    part.transform.SetParent(target.transform, false);
                    Move(part);
                    break;
                case "bare":
                    target.GetComponent<BoxCollider>().enabled = false;
                    break;
                case "behind":
                    rig.Screen.transform.position = new Vector3(0, 0, -9);
                    break;
                case "viewpoint":
                    SerializedFields.Set(rig.Range, "_viewpoint", null!);
                    break;
                default:
                    throw new ArgumentException(what);
            }
        }

        private static Transform Parent(Vector3 scale)
        {
            Transform parent = new GameObject("parent").transform;
            parent.localScale = scale;
            return parent;
        }

        private static void Move(GameObject moved)
        {
            bool wasActive = moved.activeSelf;
            moved.SetActive(false);
            SerializedFields.Set(moved.AddComponent<TargetMotion>(), "_kind", MotionKind.Sine);
            moved.SetActive(wasActive);
        }
    }
}
