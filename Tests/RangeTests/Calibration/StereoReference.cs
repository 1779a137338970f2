using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Calibration
{
    /// <summary>Reads the stored corners and the reference calibrations of real board pictures.</summary>
    internal static class StereoReference
    {
        public static JObject Load(params string[] path) => JObject.Parse(File.ReadAllText(TestFiles.Reference(path)));

        /// <summary>The pairs of one corner file, the side of a square being 1.</summary>
        public static List<BoardPair> Pairs(JObject corners)
        {
            Vector2D[] board = Points(corners["object_points"]!);
            return corners["pairs"]!.Select(pair => new BoardPair(View((string)pair["left"]!, board, Points(pair["left_px"]!)), View((string)pair["right"]!, board, Points(pair["right_px"]!)))).ToList();
        }

        /// <summary>Views with a subset of a board's corners each, in mm.</summary>
        public static List<BoardView> SubsetViews(JObject corners)
        {
            Vector2D[] board = Points(corners["object_points_mm"]!);
            return corners["images"]!.Select(image => View((string)image["image"]!, image["ids"]!.Select(id => board[(int)id]).ToArray(), Points(image["px"]!))).ToList();
        }

        public static BoardView View(string name, Vector2D[] board, Vector2D[] px)
        {
            Assert.That(BoardView.TryCreate(name, board, px, out BoardView? view, out string reason), Is.True, reason);
            return view!;
        }

        public static LensModel Model(string name) => name switch { "brown5" => LensModel.Brown5, "rational8" => LensModel.Rational8, _ => LensModel.Radial2 };

        public static Vector2D[] Points(JToken list) => list.Select(p => new Vector2D((double)p[0]!, (double)p[1]!)).ToArray();

        public static double[] Numbers(JToken list) => list.SelectMany(v => v is JArray row ? row.Select(n => (double)n) : new[] { (double)v }).ToArray();

        public static LensCamera Camera(JToken k, JToken distortion, int width, int height)
        {
            double[] m = Numbers(k);
            return new LensCamera(new PinholeCamera(m[0], m[4], m[2], m[5], width, height), BrownDistortion.FromOpenCv(Numbers(distortion).Take(distortion.Count() > 5 ? 8 : 5).ToArray()));
        }

        public static double AngleRad(Rotation3D a, Rotation3D b)
        {
            Rotation3D turn = a * b.Inverse;
            return 2 * System.Math.Atan2(new Vector3D(turn.X, turn.Y, turn.Z).Length, System.Math.Abs(turn.W));
        }
    }
}
