using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>Against Unity's manual, "Order of execution for event functions" and the pages of GameObject and Object.</summary>
    public sealed class LifeCycleTests : StandInTests
    {
        [Test]
        public void AddComponent_OnActiveObject_WakesAndEnablesAtOnceAndStartsWithTheFrame()
        {
            new GameObject("a").AddComponent<Recorder>();
            Assert.That(Recorder.Messages, Is.EqualTo(new[] { "a Awake", "a OnEnable" }));
            Recorder.Messages.Clear();
            PlayerLoop.Step(0.01);
            PlayerLoop.Step(0.011);
            Assert.That(Recorder.Messages, Is.EqualTo(new[] { "a Start", "a Update", "a LateUpdate", "a FixedUpdate", "a Update", "a LateUpdate" }));
        }

        [Test]
        public void AddComponent_OnInactiveObject_WaitsForActivation()
        {
            var inactive = new GameObject("a");
            inactive.SetActive(false);
            inactive.AddComponent<Recorder>();
            PlayerLoop.Step(0.01);
            Assert.That(Recorder.Messages, Is.Empty);
            inactive.SetActive(true);
            inactive.SetActive(false);
            inactive.SetActive(true);
            Assert.That(Recorder.Messages, Is.EqualTo(new[] { "a Awake", "a OnEnable", "a OnDisable", "a OnEnable" }));
        }

        [Test]
        public void Enabled_SetFalse_StopsUpdatesButNotAwake()
        {
            var owner = new GameObject("a");
            Recorder recorder = owner.AddComponent<Recorder>();
            recorder.enabled = false;
            PlayerLoop.Step(0.01);
            Assert.That(Recorder.Messages, Is.EqualTo(new[] { "a Awake", "a OnEnable", "a OnDisable" }));
            Assert.That(recorder.isActiveAndEnabled, Is.False);
            recorder.enabled = true;
            Recorder.Messages.Clear();
            PlayerLoop.Step(0.01);
            Assert.That(Recorder.Messages.First(), Is.EqualTo("a Start"));
        }

        [Test]
        public void SetActive_OfParent_ReachesChildren()
        {
            var parent = new GameObject("parent");
            var child = new GameObject("child");
            child.transform.SetParent(parent.transform);
            child.AddComponent<Recorder>();
            parent.SetActive(false);
            Assert.That(child.activeSelf, Is.True);
            Assert.That(child.activeInHierarchy, Is.False);
            Assert.That(Recorder.Messages.Last(), Is.EqualTo("child OnDisable"));
            child.transform.SetParent(null);
            Assert.That(Recorder.Messages.Last(), Is.EqualTo("child OnEnable"));
        }

        [Test]
        public void Update_OfSeveral_RunsByExecutionOrderThenAge()
        {
            new GameObject("first").AddComponent<Recorder>();
            new GameObject("second").AddComponent<Recorder>();
            new GameObject("early").AddComponent<EarlyRecorder>();
            PlayerLoop.Step(0.01);
            Assert.That(Recorder.Messages.Where(message => message.EndsWith(" Update")), Is.EqualTo(new[] { "early Update", "first Update", "second Update" }));
        }

        [Test]
        public void Destroy_OfObject_HappensAtTheEndOfTheFrame()
        {
            var doomed = new GameObject("a");
            Recorder recorder = doomed.AddComponent<Recorder>();
            Object.Destroy(doomed);
            Assert.That(doomed == null, Is.False);
            PlayerLoop.Step(0.01);
            Assert.That(Recorder.Messages.Skip(2), Is.EqualTo(new[] { "a Start", "a Update", "a LateUpdate", "a OnDisable", "a OnDestroy" }));
            Assert.That(doomed == null, Is.True);
            Assert.That(recorder == null, Is.True);
            Assert.That(doomed, Is.Not.Null, "the C# reference itself stays");
            Assert.That((bool)recorder, Is.False);
            Recorder.Messages.Clear();
            PlayerLoop.Step(0.01);
            Assert.That(Recorder.Messages, Is.Empty);
        }

        [Test]
        public void Destroy_OfComponent_LeavesItsObject()
        {
            var owner = new GameObject("a");
            Recorder recorder = owner.AddComponent<Recorder>();
            Object.DestroyImmediate(recorder);
            Assert.That(owner.GetComponent<Recorder>() == null, Is.True);
            Assert.That(owner == null, Is.False);
            Assert.That(Recorder.Messages.Last(), Is.EqualTo("a OnDestroy"));
        }

        [Test]
        public void Destroy_OfParent_TakesChildrenAlong()
        {
            var parent = new GameObject("parent");
            var child = new GameObject("child");
            child.transform.SetParent(parent.transform);
            child.AddComponent<Recorder>();
            Object.DestroyImmediate(parent);
            Assert.That(child == null, Is.True);
            Assert.That(Recorder.Messages.Last(), Is.EqualTo("child OnDestroy"));
        }

        [Test]
        public void Update_ThatThrows_IsLoggedAndOthersRun()
        {
            new GameObject("bad").AddComponent<ThrowingBehaviour>();
            new GameObject("good").AddComponent<Recorder>();
            PlayerLoop.Step(0.01);
            Assert.That(Recorder.Messages, Does.Contain("good Update"));
            Assert.That(ConsoleLog.Entries.Single().Type, Is.EqualTo(LogType.Exception));
            Assert.That(ConsoleLog.Entries.Single().Message, Does.Contain("as asked"));
        }

        [Test]
        public void AddComponent_WithRequirements_BringsThemAndRefusesASecond()
        {
            var owner = new GameObject("a");
            owner.AddComponent<ThrowingBehaviour>();
            Assert.That(owner.GetComponent<BoxCollider>() == null, Is.False);
            Assert.That(owner.AddComponent<ThrowingBehaviour>() == null, Is.True);
            Assert.That(ConsoleLog.Entries.Single().Type, Is.EqualTo(LogType.Error));
        }

        [Test]
        public void GetComponentInParent_LooksUpwardsAndSkipsWhatIsInactive()
        {
            var parent = new GameObject("parent");
            var child = new GameObject("child");
            child.transform.SetParent(parent.transform);
            Recorder recorder = parent.AddComponent<Recorder>();
            Assert.That(child.transform.GetComponentInParent<Recorder>(), Is.SameAs(recorder));
            Assert.That(parent.GetComponentsInChildren<Transform>(), Has.Length.EqualTo(2));
            parent.SetActive(false);
            Assert.That(child.transform.GetComponentInParent<Recorder>() == null, Is.True);
        }

        [Test]
        public void Time_OverSteps_AddsUp()
        {
            PlayerLoop.Step(0.25);
            PlayerLoop.Step(0.5);
            Assert.That(Time.timeAsDouble, Is.EqualTo(0.75));
            Assert.That(Time.deltaTime, Is.EqualTo(0.5f));
            Assert.That(Time.frameCount, Is.EqualTo(2));
        }
    }
}
