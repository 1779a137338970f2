using System.IO;
using LaserTracking.Hands.Model;
using LaserTracking.Host.HandModels;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    /// <summary>The real hand models, which are fetched by `./range models` and by nothing else.</summary>
    internal static class HandModelForTests
    {
        /// <summary>Skips the running test when the model is not there.</summary>
        public static HandLandmarkNetwork Open(string model)
        {
            HandModelFile file = HandModelStore.Named(model);
            if (!File.Exists(HandModelStore.PathOf(file)))
                Assert.Ignore("the hand model is not there; './range models' fetches it");
            return HandModelStore.Open(file);
        }
    }
}
