using System;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// True depth in mm for every pixel of camera 1, cast ray by ray: only within each solid's bounding rectangle, over a room that
    /// is computed once. Negative = the surface is there but returns no depth; 0 = outside the illuminated hexagon. Not thread-safe.
    /// </summary>
    internal sealed class DepthScene
    {
        /// <summary>Where a ray meets nothing.</summary>
        public const float Nothing = 1e6f;

        private readonly SimulationScenario _scenario;
        private readonly DepthCameraGeometry _geometry;
        private readonly ShooterMotion[] _motions;
        private readonly DepthSolid[] _solids;
        private readonly float[] _rayX, _rayY, _room, _depth;
        private readonly PixelRectList _drawn = new PixelRectList();

        public DepthScene(SimulationScenario scenario, DepthCameraGeometry geometry, ShooterMotion[] motions)
        {
            _scenario = scenario;
            _geometry = geometry;
            _motions = motions;
            _solids = new DepthSolid[motions.Length * BodySolids.Count];
            PinholeCamera camera = geometry.HandCamera.Intrinsics;
            _rayX = new float[geometry.Width];
            _rayY = new float[geometry.Height];
            for (int x = 0; x < _rayX.Length; x++)
                _rayX[x] = (float)((x - camera.CenterXPx) / camera.FocalXPx);
            for (int y = 0; y < _rayY.Length; y++)
                _rayY[y] = (float)((y - camera.CenterYPx) / camera.FocalYPx);
            _room = new float[geometry.Width * geometry.Height];
            for (int y = 0; y < geometry.Height; y++)
            for (int x = 0; x < geometry.Width; x++)
                _room[y * geometry.Width + x] = IsIlluminated(_rayX[x], _rayY[y]) ? RoomDepth(_rayX[x], _rayY[y]) : 0;
            _depth = (float[])_room.Clone();
        }

        public float[] Depth => _depth;

        /// <summary>Casts the scene of a true time; the exposure's number keys what is lost.</summary>
        public void Cast(double timeS, int exposure)
        {
            foreach (PixelRect rect in _drawn.Rects)
            {
                for (int y = rect.Top; y < rect.Bottom; y++)
                    Array.Copy(_room, y * _geometry.Width + rect.Left, _depth, y * _geometry.Width + rect.Left, rect.Right - rect.Left);
            }

            _drawn.Clear();
            for (int i = 0; i < _motions.Length; i++)
            {
                BodyPose body = _motions[i].Body(timeS);
                BodySolids.Build(body, _motions[i].FeetM, _motions[i].Side, _geometry.HandCamera, HandLost(body.Weapon, i, exposure),
                    new Span<DepthSolid>(_solids, i * BodySolids.Count, BodySolids.Count));
            }

            for (int i = 0; i < _solids.Length; i++)
                Draw(_solids[i], (uint)CounterRandom.Hash(_scenario.Seed, RandomStream.LostPalm, exposure, i));
        }

        private float HandLost(in TrueHand hand, int shooter, int exposure)
        {
            DepthCameraSettings settings = _scenario.DepthCamera;
            if (CounterRandom.Uniform(_scenario.Seed, RandomStream.LostPalm, exposure, -1 - shooter) < settings.LostPalmShare)
                return 1;
            return (float)Math.Min(1, Math.Max(0, hand.SpeedMPerS - 0.5) * settings.MotionHoleShare);
        }

        private unsafe void Draw(in DepthSolid solid, uint key)
        {
            PixelRect rect = Bounds(solid);
            if (rect.IsEmpty)
                return;
            _drawn.Add(rect);
            int width = _geometry.Width;
            uint lostBelow = (uint)(solid.LostShare * 65536);
            fixed (float* depth = _depth, rays = _rayX)
            {
                for (int y = rect.Top; y < rect.Bottom; y++)
                {
                    float rayY = _rayY[y];
                    float* row = depth + y * width;
                    bool entered = false;
                    for (int x = rect.Left; x < rect.Right; x++)
                    {
                        float z = solid.Depth(rays[x], rayY);
                        if (z <= 0)
                        {
                            // Convex: after the ray has left the solid nothing more comes in this row.
                            if (entered)
                                break;
                            continue;
                        }

                        entered = true;
                        if (z >= Math.Abs(row[x]))
                            continue;
                        // Lost in patches of 3×3 pixels, as real holes are.
                        bool lost = lostBelow > 0 && CounterRandom.Pixel((uint)(y / 3 * width + x / 3), key) >> 16 < lostBelow;
                        row[x] = lost ? -z : z;
                    }
                }
            }
        }

        private PixelRect Bounds(in DepthSolid solid)
        {
            PinholeCamera camera = _geometry.HandCamera.Intrinsics;
            var all = new PixelRect(0, 0, _geometry.Width, _geometry.Height);
            float r = solid.EndRadius, nearest = Math.Min(solid.EndA.Z, solid.EndB.Z) - r;
            if (Math.Max(solid.EndA.Z, solid.EndB.Z) + r < _geometry.NearMm)
                return default;
            return nearest < 100 ? all : Ball(camera, solid.EndA, r).Union(Ball(camera, solid.EndB, r)).Intersect(all);
        }

        private static PixelRect Ball(PinholeCamera camera, System.Numerics.Vector3 c, float r)
        {
            // The tangents to the ball in the planes y = 0 and x = 0, exactly.
            Tangents(c.X, c.Z, r, out double left, out double right);
            Tangents(c.Y, c.Z, r, out double top, out double bottom);
            return new PixelRect((int)Math.Floor(left * camera.FocalXPx + camera.CenterXPx), (int)Math.Floor(top * camera.FocalYPx + camera.CenterYPx),
                (int)Math.Ceiling(right * camera.FocalXPx + camera.CenterXPx) + 1, (int)Math.Ceiling(bottom * camera.FocalYPx + camera.CenterYPx) + 1);
        }

        private static void Tangents(double x, double z, double r, out double low, out double high)
        {
            double d = z * z - r * r, root = r * Math.Sqrt(Math.Max(0, x * x + d));
            low = (x * z - root) / d;
            high = (x * z + root) / d;
        }

        // The narrow modes light a hexagon with its points left and right; outside it there is no depth.
        private static bool IsIlluminated(float x, float y)
        {
            double ax = Math.Abs(x) / 0.66, ay = Math.Abs(y) / 0.60;
            return ay <= 1 && ax + 0.5 * ay <= 1.25;
        }

        private float RoomDepth(float x, float y)
        {
            HandCamera camera = _geometry.HandCamera;
            Vector3D origin = camera.ToScreenM(default);
            Vector3D ray = camera.PoseInScreenMm.TransformDirection(new Vector3D(x, y, 1));
            double nearest = Nothing;
            double wall = (-_geometry.BackWallM - origin.Z) / ray.Z, floor = (_geometry.FloorM - origin.Y) / ray.Y;
            double ceiling = (_geometry.CeilingM - origin.Y) / ray.Y, screen = -origin.Z / ray.Z;

            // The screen hangs on a wall: a camera that looks towards it, rather than back at the trainees, sees that.
            if (screen > 0)
                nearest = screen * 1000;
            if (wall > 0)
                nearest = Math.Min(nearest, wall * 1000);
            if (floor > 0)
                nearest = Math.Min(nearest, floor * 1000);
            if (ceiling > 0)
                nearest = Math.Min(nearest, ceiling * 1000);
            return (float)nearest;
        }
    }
}
