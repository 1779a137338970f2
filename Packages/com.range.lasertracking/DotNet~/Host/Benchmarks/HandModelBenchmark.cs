using System;
using LaserTracking.Hands.Model;
using LaserTracking.Host.HandModels;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>The hand landmark model on a colour picture: crop and network, one hand. Its time does not depend on what it sees.</summary>
    internal static class HandModelBenchmark
    {
        public static Benchmark Create(string name, HandModelFile file) =>
            new(name, $"one hand's square of a 1280×720 BGRA picture in, 21 landmarks out; model {file.Name}", () => Prepare(file)) { Missing = () => HandModelStore.ProblemOf(file) };

        private static Action<int> Prepare(HandModelFile file)
        {
            HandLandmarkNetwork network = HandModelStore.Open(file);
            var picture = new Image();
            picture.Reset(PixelFormat.Bgra32, 1280, 720, 0);
            new Random(1).NextBytes(picture.Bytes);
            var landmarks = new HandLandmarks();
            return number => network.Run(picture, new HandRegion(500 + number % 100, 300, 250, 0.3), landmarks);
        }
    }
}
