using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Hands
{
    /// <summary>Renders ellipsoids and capsules into depth pictures, for tests. Camera space, mm.</summary>
    internal sealed class SolidScene
    {
        private readonly List<(Vector3D Middle, Vector3D Axes)> _ellipsoids = new List<(Vector3D, Vector3D)>();
        private readonly List<(Vector3D A, Vector3D B, double Radius)> _capsules = new List<(Vector3D, Vector3D, double)>();

        public static PinholeCamera Camera { get; } = new PinholeCamera(252, 252, 159.5, 143.5, 320, 288);

        public double WallMm { get; set; } = 3800;

        public double NoiseMm { get; set; }

        /// <summary>Share of pixels without depth.</summary>
        public double HoleShare { get; set; }

        public SolidScene Ellipsoid(Vector3D middle, Vector3D axes)
        {
            _ellipsoids.Add((middle, axes));
            return this;
        }

        public SolidScene Capsule(Vector3D a, Vector3D b, double radius)
        {
            _capsules.Add((a, b, radius));
            return this;
        }

        /// <summary>A standing body; x of its middle, distance of its middle.</summary>
        public SolidScene Body(double x, double z) =>
            Ellipsoid(new Vector3D(x, 250, z), new Vector3D(210, 380, 120)).Ellipsoid(new Vector3D(x, -240, z), new Vector3D(75, 115, 95));

        /// <summary>An arm from the shoulder to a fist, with a pistol of the length beyond the fist's middle (0: none). Returns the muzzle.</summary>
        public Vector3D Arm(Vector3D shoulder, Vector3D fist, double pistolMm)
        {
            Vector3D axis = (fist - shoulder).Normalized;
            Vector3D wrist = fist - axis * 60;
            Capsule(shoulder, (shoulder + fist) * 0.5, 48);
            Capsule((shoulder + fist) * 0.5, wrist, 35);
            Ellipsoid(fist, new Vector3D(45, 45, 45));
            if (pistolMm > 0)
                Capsule(fist, fist + axis * (pistolMm - 15), 15);
            return fist + axis * pistolMm;
        }

        public unsafe void Render(Frame frame, int index, long timeUs, int seed = 1)
        {
            var random = new Random(seed);
            PinholeCamera camera = Camera;
            frame.Begin(index, timeUs);
            frame.Depth.Reset(PixelFormat.Depth16, camera.Width, camera.Height, timeUs);
            for (int y = 0; y < camera.Height; y++)
            {
                var row = (ushort*)(frame.Depth.Pixels + (long)y * frame.Depth.Stride);
                for (int x = 0; x < camera.Width; x++)
                {
                    double z = DepthAt(camera.Unproject(x, y, 1));
                    if (NoiseMm > 0)
                    {
                        double gauss = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
                        z += NoiseMm * gauss;
                    }

                    row[x] = HoleShare > 0 && random.NextDouble() < HoleShare ? (ushort)0 : (ushort)Math.Round(z);
                }
            }
        }

        private double DepthAt(Vector3D ray)
        {
            double nearest = WallMm;
            foreach ((Vector3D middle, Vector3D axes) in _ellipsoids)
            {
                var d = new Vector3D(ray.X / axes.X, ray.Y / axes.Y, ray.Z / axes.Z);
                var o = new Vector3D(middle.X / axes.X, middle.Y / axes.Y, middle.Z / axes.Z);
                double b = Vector3D.Dot(d, o), h = b * b - d.LengthSquared * (o.LengthSquared - 1);
                if (h > 0)
                    nearest = Math.Min(nearest, (b - Math.Sqrt(h)) / d.LengthSquared);
            }

            foreach ((Vector3D a, Vector3D b, double radius) in _capsules)
            {
                if (TryCapsule(ray, a, b, radius, out double z))
                    nearest = Math.Min(nearest, z);
            }

            return nearest;
        }

        private static bool TryCapsule(Vector3D ray, Vector3D a, Vector3D b, double radius, out double z)
        {
            z = double.MaxValue;
            Vector3D ba = b - a, oa = -a;
            double baba = ba.LengthSquared, bard = Vector3D.Dot(ba, ray), baoa = Vector3D.Dot(ba, oa);
            double k2 = baba * ray.LengthSquared - bard * bard, k1 = baba * Vector3D.Dot(oa, ray) - baoa * bard;
            double k0 = baba * oa.LengthSquared - baoa * baoa - radius * radius * baba, h = k1 * k1 - k2 * k0;
            if (h >= 0 && k2 > 1e-9)
            {
                double t = (-k1 - Math.Sqrt(h)) / k2, y = baoa + t * bard;
                if (y > 0 && y < baba)
                    z = t;
            }

            foreach (Vector3D end in new[] { a, b })
            {
                double dot = Vector3D.Dot(ray, end), disc = dot * dot - ray.LengthSquared * (end.LengthSquared - radius * radius);
                if (disc > 0)
                    z = Math.Min(z, (dot - Math.Sqrt(disc)) / ray.LengthSquared);
            }

            return z < double.MaxValue;
        }
    }
}
