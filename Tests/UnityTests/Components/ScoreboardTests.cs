using System.Linq;
using LaserTracking.Session;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.UIElements;
using UnityStandIn;

namespace LaserTracking.Unity
{
    public sealed class ScoreboardTests : StandInTests
    {
        [Test]
        public void Scoreboard_Shots_ShowTotalLastShotSplitAndShooter()
        {
            var rig = new RangeRig(new StubSource(120, 0, (30, 320, 240), (45, 330, 240), (60, 600, 100)));
            RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f).gameObject.SetActive(true);
            Scoreboard board = Add(rig);
            rig.Play(0.5);
            Assert.That(Texts(board), Is.EqualTo(new[] { "0", "no shot yet" }));
            rig.Play(3);
            Assert.That(rig.Shots, Has.Count.EqualTo(3));
            Assert.That(rig.Shots.Take(2).All(shot => shot.Hit.Score == 5), Is.True);
            Assert.That(Texts(board), Is.EqualTo(new[] { "10", "miss, 0.50 s after the last", "unknown: 10, 2 of 3 hit, splits 0.50 s, best 0.50 s" }));
            Assert.That(board.Sheet.Total.Score, Is.EqualTo(10));
            board.Clear();
            Assert.That(Shown(board), Is.EqualTo(new[] { "0", "no shot yet" }));
        }

        [Test]
        public void Scoreboard_SwitchedOff_TakesItsPanelAway()
        {
            var rig = new RangeRig(new StubSource(60, 0));
            Scoreboard board = Add(rig);
            rig.Play(0.2);
            VisualElement root = board.GetComponent<UIDocument>().rootVisualElement;
            Assert.That(root.childCount, Is.EqualTo(1));
            board.enabled = false;
            Assert.That(root.childCount, Is.Zero);
            board.enabled = true;
            Assert.That(root.childCount, Is.EqualTo(1));
        }

        private static Scoreboard Add(RangeRig rig)
        {
            var owner = new GameObject("board");
            owner.SetActive(false);
            owner.AddComponent<UIDocument>().panelSettings = ScriptableObject.CreateInstance<PanelSettings>();
            Scoreboard board = owner.AddComponent<Scoreboard>();
            SerializedFields.Set(board, "_emitter", rig.Range);
            owner.SetActive(true);
            return board;
        }

        private static string[] Texts(Scoreboard board) => Labels(board).Select(label => label.text).ToArray();

        private static string[] Shown(Scoreboard board) => Labels(board).Where(label => label.style.display.value == DisplayStyle.Flex).Select(label => label.text).ToArray();

        private static Label[] Labels(Scoreboard board)
        {
            VisualElement box = board.GetComponent<UIDocument>().rootVisualElement[0];
            return Enumerable.Range(0, box.childCount).Select(i => box[i]).OfType<Label>().ToArray();
        }
    }
}
