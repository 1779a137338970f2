using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Scoring;

namespace LaserTracking.Simulation
{
    /// <summary>Small scenarios and the few measurements that several tests make on their frames.</summary>
    internal static class SimulationExamples
    {
        /// <summary>320×180 pictures, one shooter without tremor or aim error, no shots.</summary>
        public static SimulationScenario Small(double durationS = 0.4)
        {
            var scenario = new SimulationScenario { Name = "small", Seed = 5, DurationS = durationS };
            scenario.ColorCamera.Width = 320;
            scenario.ColorCamera.Height = 180;
            scenario.Projector.Width = 320;
            scenario.Projector.Height = 180;
            scenario.DepthCamera.Binned = true;
            scenario.Shooters.Add(Steady());
            return scenario;
        }

        public static ShooterSettings Steady()
        {
            var shooter = new ShooterSettings { AimErrorMrad = 0, BoresightErrorMrad = 0 };
            shooter.Tremor.AmplitudeMrad = 0;
            shooter.Tremor.SwayMrad = 0;
            return shooter;
        }

        /// <summary>Values proportional to light, nearly no noise, no speckle: what physics can be measured on.</summary>
        public static SimulationScenario Linear(double durationS = 0.4)
        {
            SimulationScenario scenario = Small(durationS);
            scenario.ColorCamera.Gamma = 1;
            scenario.ColorCamera.FullWellElectrons = 1e12;
            scenario.ColorCamera.ReadNoiseElectrons = 0;
            scenario.Shooters[0].Laser.SpeckleContrast = 0;
            scenario.Shooters[0].Laser.DotRadiusMm = 16;
            return scenario;
        }

        public static SceneModel EmptyScene() => new SceneModel("empty", new Pose(new Vector3D(0, 1.5, 0), Rotation3D.Identity),
            new Vector2D(3.2, 1.8), new Vector3D(0, 1.6, -2.4), 1, new SceneObject[0]);

        public static byte[] ColorFrame(SimulatedRange range, int index)
        {
            using IFrameSource source = range.CreateColorSource();
            using var frame = new Frame();
            while (source.TryRead(frame))
            {
                if (frame.Index == index)
                    return frame.Color.Bytes.ToArray();
            }

            throw new ArgumentException("no frame " + index);
        }

        /// <summary>Sum and centroid of one channel's difference between two BGRA pictures around a point.</summary>
        public static double Light(byte[] with, byte[] without, int width, int height, int channel, Vector2D around, int reach, out Vector2D centroid)
        {
            double sum = 0, x0 = 0, y0 = 0;
            for (int y = Math.Max(0, (int)Math.Round(around.Y) - reach); y <= Math.Min(height - 1, (int)Math.Round(around.Y) + reach); y++)
            for (int x = Math.Max(0, (int)Math.Round(around.X) - reach); x <= Math.Min(width - 1, (int)Math.Round(around.X) + reach); x++)
            {
                int offset = (y * width + x) * 4 + channel;
                double rise = with[offset] - without[offset];
                sum += rise;
                x0 += rise * x;
                y0 += rise * y;
            }

            centroid = new Vector2D(x0 / sum, y0 / sum);
            return sum;
        }

        public static ulong Fingerprint(Image image)
        {
            ulong hash = 14695981039346656037;
            foreach (byte value in image.Bytes)
                hash = (hash ^ value) * 1099511628211;
            return hash;
        }
    }
}
