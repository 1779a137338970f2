using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using LaserTracking.Session;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.UIElements;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>The shipped prefab as it is dropped into a scene that has a camera and a target and nothing else.</summary>
    public sealed class PrefabTests : StandInTests
    {
        private static readonly string Prefab = Path.Combine(TestFiles.Repository, "Packages", "com.range.lasertracking", "Prefabs", "LaserRange.prefab");

        [Test]
        public void Prefab_InAnySceneWithACamera_MakesClicksHits()
        {
            using var folder = new TemporaryFolder();
            Desk.PersistentDataPath = folder.Path;
            var eye = new GameObject("Main Camera") { tag = "MainCamera" };
            eye.transform.SetPositionAndRotation(new Vector3(3, 1, -10), Quaternion.Euler(0, 30, 0));
            eye.AddComponent<Camera>();
            LaserTarget target = RangeRig.AddPlate("Plate 1", eye.transform.TransformPoint(new Vector3(0.4f, -0.3f, 8)), 0.5f);
            target.transform.rotation = eye.transform.rotation;
            target.gameObject.SetActive(true);
            SceneLoader.Load(Prefab);
            LaserRange range = PlayerLoop.All<LaserRange>().Single();
            var shots = new List<ShotEvent>();
            range.ShotFired += shot => shots.Add(shot);
            Play(() => false, 30);
            Assert.That(range.IsRunning, Is.True);

            // Where the camera shows the plate: 60 degrees over 1080 pixels.
            double up = Math.Tan(Math.PI / 6);
            Desk.Mouse = new Vector3((float)(960 + 0.4 / 8 / up * 540), (float)(540 - 0.3 / 8 / up * 540), 0);
            Desk.IsPressed = true;
            PlayerLoop.Step(1 / 60.0);
            Desk.IsPressed = false;
            Play(() => shots.Count > 0, 1200);
            Assert.That((shots.Single().Hit.Target, shots[0].Hit.Points), Is.EqualTo(("Plate 1", 5)));
            Assert.That(shots[0].Hit.LocalPointM.Length, Is.LessThan(0.02));
            Assert.That(PlayerLoop.All<ShotVisuals>().Single().HolesShown, Is.EqualTo(1));
            Assert.That(PlayerLoop.All<Scoreboard>().Single().Sheet.Total.Score, Is.EqualTo(5).Within(0.5));
            Assert.That(PlayerLoop.All<UIDocument>().Select(document => document.sortingOrder), Is.EqualTo(new[] { 0, 10 }), "the calibration lies over all else");
            Assert.That(ConsoleLog.Entries.Where(entry => !entry.Message.Contains("frames are missing") && !entry.Message.Contains("frames keep getting lost") && !entry.Message.Contains("will be caught")), Is.Empty);
        }

        private static void Play(Func<bool> isSo, int frames)
        {
            for (int i = 0; i < frames && !isSo(); i++)
            {
                PlayerLoop.Step(1 / 60.0);
                Thread.Sleep(5);
            }
        }
    }
}
