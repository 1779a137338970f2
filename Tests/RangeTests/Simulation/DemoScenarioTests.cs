using System.Collections.Generic;
using System.IO;
using LaserTracking.Host.Scenes;
using LaserTracking.Scoring;
using NUnit.Framework;

namespace LaserTracking.Simulation
{
    public sealed class DemoScenarioTests
    {
        [Test]
        public void DemoScenario_ShippedFileAndScene_GiveASessionWorthShowing()
        {
            string root = TestFiles.Repository;
            SimulationScenario scenario = SimulationScenarioFile.Read(Path.Combine(root, "Assets", "Sources", "demo.scenario.json"));
            SceneModel scene = UnitySceneReader.Read(Path.Combine(root, "Assets", "Scenes", "Range.unity"));
            var range = new SimulatedRange(scenario, scene);
            var shooters = new HashSet<int>();
            int single = 0, held = 0, simultaneous = 0, doubleTaps = 0, onTarget = 0, aimed = 0;
            IReadOnlyList<TrueShot> shots = range.Truth.Shots;
            for (int i = 0; i < shots.Count; i++)
            {
                Assert.That(shots[i].FirstFrame, Is.GreaterThanOrEqualTo(0), "shot " + shots[i].Id + " is seen by no frame");
                Assert.That(shots[i].ScreenM.X >= 0 && shots[i].ScreenM.X <= scene.ScreenSizeM.X && shots[i].ScreenM.Y >= 0 && shots[i].ScreenM.Y <= scene.ScreenSizeM.Y, Is.True);
                shooters.Add(shots[i].Shooter);
                single += shots[i].FirstFrame == shots[i].LastFrame ? 1 : 0;
                held += shots[i].PulseUs > 1e6 ? 1 : 0;
                aimed += shots[i].AimedAt.Length > 0 ? 1 : 0;
                onTarget += shots[i].AimedAt.Length > 0 && shots[i].ShownTarget == shots[i].AimedAt ? 1 : 0;
                if (i == 0)
                    continue;
                simultaneous += shots[i].SceneTimeUs == shots[i - 1].SceneTimeUs ? 1 : 0;
                doubleTaps += shots[i].Shooter == shots[i - 1].Shooter && shots[i].SceneTimeUs - shots[i - 1].SceneTimeUs < 300000 ? 1 : 0;
            }

            Assert.That(shooters.Count, Is.InRange(2, 3));
            Assert.That(shots.Count, Is.InRange(18, 30));
            Assert.That(single, Is.GreaterThanOrEqualTo(3), "flashes in one single frame");
            Assert.That(held, Is.GreaterThanOrEqualTo(1));
            Assert.That(simultaneous, Is.GreaterThanOrEqualTo(1));
            Assert.That(doubleTaps, Is.GreaterThanOrEqualTo(1));
            Assert.That(onTarget, Is.GreaterThanOrEqualTo(aimed - 2), "most shots hit what they were aimed at");
        }

        [Test]
        public void DemoScenario_FolderOrMissingFile_IsRefusedInOneLine()
        {
            foreach (string path in new[] { TestFiles.Repository, Path.Combine(TestFiles.Repository, "no such.json"), "" })
            {
                var e = Assert.Throws<InputException>(() => SimulationScenarioFile.Read(path));
                Assert.That(e!.Message, Does.Not.Contain("\n"));
            }
        }
    }
}
