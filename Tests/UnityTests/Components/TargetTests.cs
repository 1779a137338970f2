using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    public sealed class TargetTests : StandInTests
    {
        [Test]
        public void TargetDefinitionAsset_ToDefinition_CarriesEverything()
        {
            TargetDefinitionAsset asset = ScriptableObject.CreateInstance<TargetDefinitionAsset>();
            asset.name = "Silhouette";
            SerializedFields.Set(asset, "_kind", TargetKind.Silhouette);
            SerializedFields.Set(asset, "_sizeM", new Vector2(0.5f, 1));
            SerializedFields.Set(asset, "_zones", new[]
            {
                new TargetZoneData { name = "head", points = 10, shape = ZoneShape.Ellipse, centerM = new Vector2(0, 0.25f), sizeM = new Vector2(0.25f, 0.5f) },
                new TargetZoneData { name = "body", points = 5, shape = ZoneShape.Polygon, cornersM = new[] { new Vector2(0, 0), new Vector2(1, 0), new Vector2(0, 1) } },
            });
            TargetDefinition definition = asset.ToDefinition();
            Assert.That(definition.Name, Is.EqualTo("Silhouette"));
            Assert.That(definition.Kind, Is.EqualTo(TargetKind.Silhouette));
            Assert.That(definition.SizeM, Is.EqualTo(new Vector2D(0.5, 1)));
            Assert.That(definition.Zones.Select(zone => zone.Name + zone.Points + zone.Shape), Is.EqualTo(new[] { "head10Ellipse", "body5Polygon" }));
            Assert.That(definition.Zones[0].CenterM, Is.EqualTo(new Vector2D(0, 0.25)));
            Assert.That(definition.Zones[1].CornersM, Has.Count.EqualTo(3));
        }

        [Test]
        public void LaserTarget_DefinitionWithoutZones_IsSaidOnceAndNull()
        {
            TargetDefinitionAsset empty = ScriptableObject.CreateInstance<TargetDefinitionAsset>();
            empty.name = "Empty";
            LaserTarget target = new GameObject("t").AddComponent<LaserTarget>();
            SerializedFields.Set(target, "_definition", empty);
            Assert.That(target.Definition, Is.Null);
            Assert.That(target.Definition, Is.Null);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.StartWith("target definition Empty: ").And.Contain("zone"));
        }

        [Test]
        public void PhysicsRaycaster_ColliderBelowTarget_CountsForTheTargetAndInItsAxes()
        {
            var owner = new GameObject("owner");
            owner.transform.position = new Vector3(1, 0, 5);
            LaserTarget target = owner.AddComponent<LaserTarget>();
            SerializedFields.Set(target, "_definition", RangeRig.Definition("plate", 1));
            GameObject part = GameObject.CreatePrimitive(PrimitiveType.Cube);
            part.transform.SetParent(owner.transform, false);
            part.transform.localPosition = new Vector3(-1, 0, 0);
            Physics.SyncTransforms();
            var raycaster = new PhysicsRaycaster(~0);
            var ray = new Ray3D(default, new Vector3D(0, 0, 1));
            Assert.That(raycaster.TryRaycast(ray, 100, 0, out LaserTracking.Scoring.RaycastHit hit), Is.True);
            Assert.That((hit.LocalPointM - new Vector3D(-1, 0, -0.5)).Length, Is.LessThan(1e-5));
            Assert.That(raycaster.TryGetTarget(hit.ObjectIndex, out string name, out TargetDefinition? definition), Is.True);
            Assert.That(name, Is.EqualTo("owner"));
            Assert.That(definition!.Name, Is.EqualTo("plate"));

            target.enabled = false;
            raycaster.TryRaycast(ray, 100, 0, out hit);
            raycaster.TryGetTarget(hit.ObjectIndex, out name, out definition);
            Assert.That(definition, Is.Null, "a disabled target is scenery");
            Object.DestroyImmediate(owner);
            Assert.That(raycaster.TryRaycast(ray, 100, 0, out _), Is.False);
            Assert.That(raycaster.TryGetTarget(0, out _, out _), Is.False);
        }

        [Test]
        public void ScreenSurface_ScreenToWorld_PutsTopLeftUpLeftAndDepthIntoThePicture()
        {
            ScreenSurface screen = new GameObject("screen").AddComponent<ScreenSurface>();
            screen.transform.position = new Vector3(0, 1, 0);
            screen.transform.localScale = new Vector3(9, 9, 9);
            Vector3D corner = screen.ScreenToWorld(new Vector3D(0, 0, 0.5));
            Assert.That((corner - new Vector3D(-1.865, 2.13, 0.5)).Length, Is.LessThan(1e-6), "scale plays no part");
            Assert.That((screen.WorldToScreen(corner) - new Vector3D(0, 0, 0.5)).Length, Is.LessThan(1e-6));
            screen.transform.localRotation = Quaternion.Euler(0, 90, 0);
            corner = screen.ScreenToWorld(new Vector3D(0, 0, 0.5));
            Assert.That((corner - new Vector3D(0.5, 2.13, 1.865)).Length, Is.LessThan(1e-6));
        }
    }
}
