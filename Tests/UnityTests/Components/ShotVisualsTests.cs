using System;
using System.Linq;
using LaserTracking.Scoring;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;
using Object = UnityEngine.Object;

namespace LaserTracking.Unity
{
    /// <summary>Frames in, the state of everything drawn out.</summary>
    public sealed class ShotVisualsTests : StandInTests
    {
        [Test]
        public void ShotVisuals_TargetWithAPropertyBlockOfItsOwn_HasItBackAfterTheFlash()
        {
            var rig = new RangeRig(new StubSource(60, 0, (30, 320, 240), (34, 320, 240)));
            LaserTarget target = RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f);
            target.gameObject.SetActive(true);
            var own = new MaterialPropertyBlock();
            own.SetColor(Shader.PropertyToID("_Color"), Color.cyan);
            target.GetComponent<Renderer>().SetPropertyBlock(own);
            ShotVisuals visuals = Add(rig);
            PlayTo(rig, () => rig.Shots.Count == 1);
            Assert.That(ColorOf(target.GetComponent<Renderer>(), "_Color"), Is.Not.EqualTo(Color.cyan));
            rig.Play(1);
            Assert.That(visuals.IsLit(target), Is.False);
            Assert.That(ColorOf(target.GetComponent<Renderer>(), "_Color"), Is.EqualTo(Color.cyan));
        }

        [Test]
        public void ShotVisuals_Hit_LeavesAHoleARayAndALitTargetInTheShootersColor()
        {
            var rig = new RangeRig(new StubSource(60, 0, (30, 320, 240)));
            LaserTarget target = RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f);
            target.gameObject.SetActive(true);
            ShotVisuals visuals = Add(rig);
            rig.Play(0.9);
            Assert.That((visuals.HolesShown, visuals.RaysShown), Is.EqualTo((0, 0)));
            PlayTo(rig, () => rig.Shots.Count == 1);
            Assert.That((visuals.HolesShown, visuals.RaysShown, visuals.IsLit(target)), Is.EqualTo((1, 1, true)));

            Transform hole = Holes(visuals).Single(mark => mark.gameObject.activeSelf);
            Assert.That(hole.position.z, Is.EqualTo(3.995f - 0.002f).Within(1e-3), "before the plate");
            Assert.That(hole.forward.z, Is.EqualTo(1).Within(1e-4), "seen from the eye");
            Color unknown = new ShooterColors().unknown;
            Assert.That(ColorOf(hole.GetComponent<Renderer>()), Is.EqualTo(unknown));
            Assert.That(ColorOf(target.GetComponent<Renderer>(), "_EmissionColor"), Is.EqualTo(unknown));
            LineRenderer ray = PlayerLoop.All<LineRenderer>().Single(line => line.enabled);
            Assert.That(ray.GetPosition(1).z, Is.EqualTo(0).Within(1e-3), "through the screen");
            Assert.That((ray.GetPosition(2) - hole.position).magnitude, Is.LessThan(0.01f));
            Assert.That((ray.startColor, ray.endColor), Is.EqualTo((unknown, unknown)));

            rig.Play(0.5);
            Assert.That((visuals.HolesShown, visuals.RaysShown, visuals.IsLit(target)), Is.EqualTo((1, 0, false)), "the hole stays");
            Assert.That(target.GetComponent<Renderer>().HasPropertyBlock(), Is.False);
            visuals.Clear();
            Assert.That(visuals.HolesShown, Is.Zero);
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void ShotVisuals_HoleOnAMovingTarget_MovesWithItAndGoesWithIt()
        {
            var rig = new RangeRig(new StubSource(400, 0, (30, 320, 240)));
            LaserTarget target = RangeRig.AddPlate("Runner", new Vector3(0, 0, 4), 0.6f);
            TargetMotion motion = target.gameObject.AddComponent<TargetMotion>();
            SerializedFields.Set(motion, "_kind", MotionKind.Sine);
            SerializedFields.Set(motion, "_travelM", new Vector3(0.2f, 0, 0));
            target.gameObject.SetActive(true);
            ShotVisuals visuals = Add(rig);
            PlayTo(rig, () => rig.Shots.Count == 1);
            Transform hole = Holes(visuals).Single(mark => mark.gameObject.activeSelf);
            Vector3 on = hole.position - target.transform.position;
            Assert.That(on.x, Is.EqualTo((float)rig.Shots[0].Hit.LocalPointM.X).Within(1e-4), "where it was hit, not where it is now");
            rig.Play(0.7);
            Assert.That((hole.position - target.transform.position - on).magnitude, Is.LessThan(1e-4f));
            target.gameObject.SetActive(false);
            PlayerLoop.Step(0.02);
            Assert.That(visuals.HolesShown, Is.Zero);
            Object.DestroyImmediate(target.gameObject);
            PlayerLoop.Step(0.02);
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void ShotVisuals_MoreShotsThanPool_ReplaceTheOldest()
        {
            (int, int, int)[] flashes = Enumerable.Range(0, 6).Select(i => (30 + 15 * i, 290 + 10 * i, 240)).ToArray();
            var rig = new RangeRig(new StubSource(160, 0, flashes));
            RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 2f).gameObject.SetActive(true);
            ShotVisuals visuals = Add(rig, holes: 4, rays: 2);
            int objects = PlayerLoop.All<Transform>().Count;
            rig.Play(5);
            Assert.That(rig.Shots, Has.Count.EqualTo(6));
            Assert.That(visuals.HolesShown, Is.EqualTo(4));
            Assert.That(PlayerLoop.All<Transform>(), Has.Count.EqualTo(objects), "nothing is made while playing");
            float[] shown = Holes(visuals).Select(hole => hole.position.x).OrderBy(x => x).ToArray();
            Assert.That(shown[0], Is.GreaterThan((float)rig.Shots[1].Hit.PointM.X + 0.01f), "the first two are gone");
        }

        [Test]
        public void ShotVisuals_Marks_StopNoShot()
        {
            var rig = new RangeRig(new StubSource(120, 0, (30, 320, 240), (60, 320, 240)));
            LaserTarget target = RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f);
            target.gameObject.SetActive(true);
            Add(rig);
            SerializedFields.Set(rig.Range, "_hitLayers", -1);
            rig.Play(3);
            Assert.That(rig.Shots.Select(shot => shot.Hit.Target), Is.EqualTo(new[] { "Plate 1", "Plate 1" }));
            Assert.That(PlayerLoop.All<ShotVisuals>()[0].GetComponentsInChildren<Collider>(), Is.Empty);
        }

        [Test]
        public void ShotVisuals_SwitchedOff_ShowsNothingAndHearsNothing()
        {
            var rig = new RangeRig(new StubSource(60, 0, (30, 320, 240)));
            RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f).gameObject.SetActive(true);
            ShotVisuals visuals = Add(rig);
            rig.Play(0.5);
            visuals.enabled = false;
            rig.Play(1.5);
            Assert.That((rig.Shots.Count, visuals.HolesShown, visuals.RaysShown), Is.EqualTo((1, 0, 0)));
        }

        [Test]
        public void ShotVisuals_Update_AllocatesNothingOnceWarm()
        {
            var rig = new RangeRig(new StubSource(60, 0, (30, 320, 240)));
            RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f).gameObject.SetActive(true);
            ShotVisuals visuals = Add(rig);
            PlayTo(rig, () => rig.Shots.Count == 1);
            var lateUpdate = (Action)Delegate.CreateDelegate(typeof(Action), visuals, "LateUpdate");
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 20; i++)
                    lateUpdate();
            }), Is.Zero);
            Assert.That(visuals.RaysShown, Is.EqualTo(1), "while all of it is shown");
        }

        [Test]
        public void ShooterColors_Shooters_GoRound()
        {
            var colors = new ShooterColors();
            Assert.That(colors.Of(0), Is.EqualTo(colors.unknown));
            Assert.That(colors.Of(1), Is.EqualTo(colors.shooters[0]));
            Assert.That(colors.Of(1 + colors.shooters.Length), Is.EqualTo(colors.shooters[0]));
            Assert.That(colors.shooters.Append(colors.unknown).Distinct().Count(), Is.EqualTo(colors.shooters.Length + 1));
        }

        private static ShotVisuals Add(RangeRig rig, int holes = 8, int rays = 4)
        {
            var owner = new GameObject("visuals");
            owner.SetActive(false);
            owner.transform.SetParent(rig.Range.transform, false);
            ShotVisuals visuals = owner.AddComponent<ShotVisuals>();
            SerializedFields.Set(visuals, "_holes", holes);
            SerializedFields.Set(visuals, "_rays", rays);
            rig.Range.gameObject.SetActive(true);
            owner.SetActive(true);
            return visuals;
        }

        private static void PlayTo(RangeRig rig, Func<bool> isSo)
        {
            for (int i = 0; i < 200 && !isSo(); i++)
                rig.Step(1 / 60.0);
            Assert.That(isSo(), Is.True);
        }

        private static Transform[] Holes(ShotVisuals visuals) =>
            Enumerable.Range(0, visuals.transform.childCount).Select(visuals.transform.GetChild).Where(child => child.name == "Hole").ToArray();

        private static Color ColorOf(Renderer renderer, string property = "_Color")
        {
            var block = new MaterialPropertyBlock();
            renderer.GetPropertyBlock(block);
            return block.GetColor(Shader.PropertyToID(property));
        }
    }
}
