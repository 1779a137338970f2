using System;
using System.Numerics;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// Paints what stands behind the targets: an indoor bay of concrete, wood and rubber in the perspective of the viewpoint. Colours
    /// are display values 0…255 in the order blue, green, red.
    /// </summary>
    internal sealed class RoomPainter
    {
        private readonly Vector3D _eye;
        private readonly double _floor, _ceiling, _side, _back;

        /// <param name="view">Decides how large the bay must be to hold all targets.</param>
        public RoomPainter(SceneView view)
        {
            _eye = view.EyeM;
            double back = 6, side = view.Scene.ScreenSizeM.X * 0.9;
            foreach (int i in view.FarToNear)
            {
                Vector3D p = view.Scene.Surface.InverseTransformPoint(view.Scene.Objects[i].RestPose.Position);
                Vector3D travel = view.Scene.Objects[i].Motion.TravelM;
                back = Math.Max(back, p.Z + Math.Abs(travel.Z) + 2);
                side = Math.Max(side, Math.Abs(p.X) + Math.Abs(travel.X) + 1);
            }

            _back = back;
            _side = side;
            // The scene's ground is Unity's y = 0 unless the eye lies there.
            double ground = view.Scene.Surface.InverseTransformPoint(default).Y;
            _floor = ground < _eye.Y - 0.3 ? ground : _eye.Y - 1.6;
            _ceiling = _floor + 3.4;
        }

        public double FloorM => _floor;

        /// <summary>Display colour at a point of the screen surface (its own axes, m).</summary>
        public Vector3 Color(Vector2D surfaceM)
        {
            var direction = new Vector3D(surfaceM.X - _eye.X, surfaceM.Y - _eye.Y, -_eye.Z);
            double reach = (_back - _eye.Z) / direction.Z;
            int wall = 0;
            Nearer((direction.Y < 0 ? _floor - _eye.Y : _ceiling - _eye.Y) / direction.Y, direction.Y < 0 ? 1 : 2, ref reach, ref wall);
            Nearer((direction.X < 0 ? -_side - _eye.X : _side - _eye.X) / direction.X, 3, ref reach, ref wall);
            Vector3D p = _eye + direction * reach;
            float fade = (float)(0.55 + 0.45 * Math.Min(1, (p.Z + 1) / (_back + 1)));
            switch (wall)
            {
                case 1: return Floor(p) * (0.75f + 0.25f * fade);
                case 2: return Ceiling(p) * fade;
                case 3: return Side(p) * fade;
                default: return Back(p);
            }
        }

        private static void Nearer(double reach, int wall, ref double nearest, ref int nearestWall)
        {
            if (!(reach > 0 && reach < nearest))
                return;
            nearest = reach;
            nearestWall = wall;
        }

        private Vector3 Back(Vector3D p)
        {
            // Rubber granulate, lit by a row of lamps from above.
            float light = (float)(0.42 + 0.5 * Math.Exp(-Square((p.Y - (_floor + 1.7)) / 1.1)));
            light *= 0.85f + 0.15f * (float)Math.Cos(p.X * 2 * Math.PI / 2.4);
            float grain = 0.94f + 0.12f * ValueNoise.At(p.X * 14, p.Y * 14, 1) - 0.05f * ValueNoise.At(p.X * 2, p.Y * 2, 2);
            return new Vector3(104, 98, 90) * (light * grain);
        }

        private Vector3 Floor(Vector3D p)
        {
            float grain = 0.9f + 0.14f * ValueNoise.At(p.X * 6, p.Z * 6, 3) + 0.08f * ValueNoise.At(p.X * 1.3, p.Z * 1.3, 4);
            var color = new Vector3(92, 104, 112) * (0.78f * grain);
            double lane = Math.Abs(p.X / 1.6 - Math.Round(p.X / 1.6)) * 1.6;
            double mark = Math.Abs(p.Z / 5 - Math.Round(p.Z / 5)) * 5;
            float line = Math.Max(Edge(lane, 0.03), p.Z > 1 ? Edge(mark, 0.05) : 0);
            return Mix.Of(color, new Vector3(70, 170, 190), 0.55f * line);
        }

        private Vector3 Ceiling(Vector3D p)
        {
            var color = new Vector3(46, 44, 42);
            // Four rows of lamps in a deep bay, one every 2.5 m in a short one.
            double spacing = Math.Max(2.5, (_back + 1) / 4), z = p.Z - spacing * Math.Floor(p.Z / spacing);
            bool lamp = Math.Abs(z - spacing / 2) < 0.2 && Math.Abs(p.X) < _side * 0.72;
            // Baffles of wood between the lamps.
            return lamp ? new Vector3(205, 212, 214) : z < 0.5 ? new Vector3(50, 68, 84) : color;
        }

        private Vector3 Side(Vector3D p)
        {
            float grain = 0.94f + 0.1f * ValueNoise.At(p.Z * 5, p.Y * 5, 5);
            double panel = Math.Abs(p.Z / 1.25 - Math.Round(p.Z / 1.25)) * 1.25;
            float joint = Edge(panel, 0.02);
            float stripe = Edge(Math.Abs(p.Y - (_floor + 1.0)), 0.06);
            Vector3 color = Mix.Of(new Vector3(112, 106, 98) * grain, new Vector3(60, 56, 52), joint);
            return Mix.Of(color, new Vector3(60, 130, 160), 0.7f * stripe) * 0.8f;
        }

        private static float Edge(double distance, double halfWidth) =>
            (float)Math.Max(0, Math.Min(1, (halfWidth - distance) / 0.012 + 0.5));

        private static double Square(double x) => x * x;
    }
}
