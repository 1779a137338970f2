using NUnit.Framework;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>Every test gets an empty scene.</summary>
    public abstract class StandInTests
    {
        [SetUp]
        public void EmptyTheScene()
        {
            PlayerLoop.Reset();
            Recorder.Messages.Clear();
        }

        [TearDown]
        public void LeaveNothing() => PlayerLoop.Reset();
    }
}
