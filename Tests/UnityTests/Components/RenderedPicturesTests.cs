using System.Linq;
using LaserTracking.Session;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>What the projector shows reaches the detector, and shots are found while all of it moves.</summary>
    public sealed class RenderedPicturesTests : StandInTests
    {
        [Test]
        public void LaserRange_PictureOfItsTextureKnown_FindsEveryShotWhileAllMoves()
        {
            using var moving = new MovingPicture(3, 9);
            RenderTexture texture = new RenderTexture(640, 360, 24);
            SerializedFields.Set(moving.Rig.Range.gameObject.AddComponent<RenderedPictures>(), "_picture", texture);
            moving.Play(() => GraphicsCard.Draw(texture));
            AssertFoundAll(moving);
        }

        [Test]
        public void LaserRange_SceneDrawnAgainByACopyOfItsCamera_FindsEveryShotWhileAllMoves()
        {
            using var moving = new MovingPicture(4, 9);
            RangeRig.AddMainCamera();
            SerializedFields.Set(moving.Rig.Range, "_viewpoint", null);
            RenderedPictures pictures = moving.Rig.Range.gameObject.AddComponent<RenderedPictures>();
            moving.Play();
            AssertFoundAll(moving);
            pictures.enabled = false;
            PlayerLoop.Step(0.01);
            Assert.That(PlayerLoop.All<Camera>(), Has.Count.EqualTo(1));
            Assert.That(GraphicsCard.Textures, Is.Zero);
        }

        [Test]
        public void LaserRange_CardThatCannotBeReadBack_SaysSoOnceAndPlaysAsWithoutIt()
        {
            using var moving = new MovingPicture(5, 2);
            GraphicsCard.CanBeReadBack = false;
            moving.Rig.Range.gameObject.AddComponent<RenderedPictures>();
            moving.Play();
            Assert.That(ConsoleLog.Entries.Count(entry => entry.Message.Contains("cannot be read back")), Is.EqualTo(1));
            Assert.That(moving.Rig.Range.Pictures, Is.Null);
        }

        [Test]
        public void LaserRange_ReadingBackFails_SaysSoOnceAndIsNeverReliedOn()
        {
            using var moving = new MovingPicture(5, 3);
            GraphicsCard.Fails = true;
            SerializedFields.Set(moving.Rig.Range.gameObject.AddComponent<RenderedPictures>(), "_picture", new RenderTexture(1280, 720, 24));
            moving.Play();
            Assert.That(ConsoleLog.Entries.Count(entry => entry.Message.Contains("could not be read back")), Is.EqualTo(1));
            Assert.That(moving.Rig.Health.Where(health => health.Kind == HealthKind.Rendered && health.Text.Contains("are found")), Is.Empty);
            Assert.That(GraphicsCard.Textures, Is.EqualTo(1), "what was borrowed was given back");
        }

        [Test]
        public void LaserRange_PlayedAndNotLive_IsToldNothingOfThePicture()
        {
            var rig = new RangeRig(new StubSource(20, 0));
            GraphicsCard.Scene = (width, height) => new Color32[width * height];
            RangeRig.AddMainCamera();
            SerializedFields.Set(rig.Range, "_viewpoint", null);
            rig.Range.gameObject.AddComponent<RenderedPictures>();
            rig.Play(0.5);
            Assert.That(PlayerLoop.All<Camera>(), Has.Count.EqualTo(1), "no copy draws for nothing");
        }

        [Test]
        public void RenderedPictures_WindowOfAnotherShape_AreDrawnInThatShape()
        {
            using var moving = new MovingPicture(4, 1);
            RangeRig.AddMainCamera();
            SerializedFields.Set(moving.Rig.Range, "_viewpoint", null);
            moving.Rig.Range.gameObject.AddComponent<RenderedPictures>();
            int frame = 0;
            moving.Play(() => Desk.Height = frame++ < 30 ? 1080 : 1440);
            RenderTexture drawn = PlayerLoop.All<Camera>().Single(camera => camera.targetTexture != null).targetTexture;
            Assert.That((drawn.width, drawn.height), Is.EqualTo((640, 480)));
            Assert.That(GraphicsCard.Textures, Is.EqualTo(1));
        }

        private static void AssertFoundAll(MovingPicture moving)
        {
            Assert.That(ConsoleLog.Entries.Where(entry => entry.Message.Contains("RenderedPictures")), Is.Empty);
            Assert.That(moving.Rig.Health.Where(health => health.Kind == HealthKind.Rendered).Select(health => health.Text), Has.Some.Contains("shots count wherever they move"));
            Assert.That(moving.Shots, Is.GreaterThan(10));
            Assert.That(moving.Rig.Shots.Count(shot => shot.Shot.TimeUs > 2_900_000), Is.EqualTo(moving.Shots));
        }
    }
}
