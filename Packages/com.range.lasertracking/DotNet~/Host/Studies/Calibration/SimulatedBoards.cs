using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Calibration;
using LaserTracking.Geometry;
using LaserTracking.Host.Calibration;
using LaserTracking.Patterns;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Studies.Calibration
{
    /// <summary>A calibration session whose truth is known: two cameras as of the published system, and its board held before them.</summary>
    internal sealed class SimulatedBoards
    {
        private const int Width = 1280;
        private const int Height = 720;
        private const int MostTries = 10_000;

        private readonly Random _random;

        /// <param name="seed">The same seed gives the same cameras and the same boards.</param>
        public SimulatedBoards(int seed)
        {
            _random = new Random(seed);
            Board = new Board(new BoardSize(8, 6), 80);
            var turn = new Vector3D(Even(0.03), Even(0.06), Even(0.03));
            var between = new Pose(new Vector3D(-400 + Even(100), Even(15), Even(30)), Rotation3D.AboutAxis(turn, turn.Length));
            Truth = new StereoRig(Camera(), Camera(), between);
        }

        public StereoRig Truth { get; }

        /// <summary>The published system's: 8×6 inner corners, 80 mm.</summary>
        public Board Board { get; }

        /// <summary>Boards at 1.2 to 2.6 m, tilted by up to 40° about any axis, wholly seen by both cameras.</summary>
        /// <param name="count">Number of pairs.</param>
        /// <param name="sigmaPx">Noise of each corner along each axis.</param>
        /// <param name="sigmaOfFirstPx">Another noise for the first pair: a blurred one.</param>
        public List<BoardPair> Pairs(int count, double sigmaPx, double? sigmaOfFirstPx = null)
        {
            var pairs = new List<BoardPair>();
            for (int tries = 0; pairs.Count < count && tries < MostTries; tries++)
            {
                Pose pose = RandomPose();
                double sigma = pairs.Count == 0 && sigmaOfFirstPx is double blurred ? blurred : sigmaPx;
                if (TryView("left", pairs.Count, Truth.Left, pose, sigma, out BoardView? left) && TryView("right", pairs.Count, Truth.Right, Truth.LeftToRight * pose, sigma, out BoardView? right))
                    pairs.Add(new BoardPair(left!, right!));
            }

            return pairs.Count == count ? pairs : throw new InvalidOperationException("the cameras share no view");
        }

        /// <summary>Views of camera 0 alone, all boards turned away from one direction by at most half the spread.</summary>
        /// <param name="count">Number of views.</param>
        /// <param name="sigmaPx">Noise of each corner along each axis.</param>
        /// <param name="leanDegrees">Of that direction against the camera's axis.</param>
        /// <param name="spreadDegrees">Largest angle between two boards; the first four reach it.</param>
        public List<BoardView> Alike(int count, double sigmaPx, double leanDegrees, double spreadDegrees)
        {
            double towards = _random.NextDouble() * 2 * Math.PI;
            Rotation3D lean = Tilt(towards, leanDegrees);
            var views = new List<BoardView>();
            for (int tries = 0; views.Count < count && tries < MostTries; tries++)
            {
                bool isOutermost = views.Count < 4;
                double direction = isOutermost ? views.Count * Math.PI / 2 : _random.NextDouble() * 2 * Math.PI;
                double angle = spreadDegrees / 2 * (isOutermost ? 1 : Math.Sqrt(_random.NextDouble()));
                if (TryView("view", views.Count, Truth.Left, Place(lean * Tilt(direction, angle)), sigmaPx, out BoardView? view))
                    views.Add(view!);
            }

            return views.Count == count ? views : throw new InvalidOperationException("the camera does not see the board");
        }

        /// <summary>The pairs as a file of stored corners.</summary>
        public string Format(IReadOnlyList<BoardPair> pairs)
        {
            JArray List(IEnumerable<Vector2D> points) => new(points.Select(p => new JArray(Math.Round(p.X, 3), Math.Round(p.Y, 3))));
            var root = new JObject
            {
                ["v"] = CalibrationJson.Version,
                ["note"] = "a simulated session: synthetic corners, no pictures",
                ["image_size"] = new JArray(Width, Height),
                ["object_points_mm"] = List(Board.CornersMm()),
                ["pairs"] = new JArray(pairs.Select(pair => new JObject { ["left"] = pair.Left.Name, ["left_px"] = List(pair.Left.ImagePx), ["right"] = pair.Right.Name, ["right_px"] = List(pair.Right.ImagePx) })),
            };
            return root.ToString(Formatting.None) + "\n";
        }

        private LensCamera Camera()
        {
            double focal = 610 + Even(20);
            var pinhole = new PinholeCamera(focal, focal * (1 + Even(0.003)), Width / 2.0 + Even(15), Height / 2.0 + Even(15), Width, Height);
            return new LensCamera(pinhole, BrownDistortion.FromOpenCv(new[] { -0.08 + Even(0.05), 0.05 + Even(0.03), Even(0.001), Even(0.001), Even(0.01) }));
        }

        private Pose RandomPose()
        {
            double angle = _random.NextDouble() * 40, direction = _random.NextDouble() * 2 * Math.PI;
            return Place(Tilt(direction, angle));
        }

        private static Rotation3D Tilt(double direction, double degrees) => Rotation3D.AboutAxis(new Vector3D(Math.Cos(direction), Math.Sin(direction), 0), degrees * Math.PI / 180);

        private Pose Place(Rotation3D tilt)
        {
            Rotation3D roll = Rotation3D.AboutAxis(new Vector3D(0, 0, 1), Even(0.3));
            double depth = 1200 + _random.NextDouble() * 1400;
            Rotation3D rotation = tilt * roll;
            var middle = new Vector3D(Even(0.8) * depth, Even(0.45) * depth, depth);
            Vector2D last = Board.CornersMm()[^1];
            return new Pose(middle - rotation * new Vector3D(last.X / 2, last.Y / 2, 0), rotation);
        }

        private bool TryView(string side, int number, LensCamera camera, Pose pose, double sigmaPx, out BoardView? view)
        {
            view = null;
            Vector2D[] boardMm = Board.CornersMm();
            var px = new Vector2D[boardMm.Length];
            for (int i = 0; i < px.Length; i++)
            {
                if (!camera.TryProject(pose.TransformPoint(new Vector3D(boardMm[i].X, boardMm[i].Y, 0)), out px[i]) || px[i].X < 20 || px[i].Y < 20 || px[i].X > Width - 20 || px[i].Y > Height - 20)
                    return false;
                px[i] += new Vector2D(Normal(), Normal()) * sigmaPx;
            }

            return BoardView.TryCreate(FormattableString.Invariant($"{side}{number + 1:00}"), boardMm, px, out view, out _);
        }

        private double Even(double range) => (2 * _random.NextDouble() - 1) * range;

        private double Normal() => Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
    }
}
