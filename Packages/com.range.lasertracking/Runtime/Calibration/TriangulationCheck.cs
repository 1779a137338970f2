using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>Boards put back together from both views: distances between neighbouring points against those on the board.</summary>
    public sealed class TriangulationCheck
    {
        private TriangulationCheck(int edges, double mean, double deviation, int behind)
        {
            Edges = edges;
            EdgeRatioMean = mean;
            EdgeRatioDeviation = deviation;
            Behind = behind;
        }

        /// <summary>Number of distances compared.</summary>
        public int Edges { get; }

        /// <summary>Triangulated distance by true distance, mean: 1 is right.</summary>
        public double EdgeRatioMean { get; }

        /// <summary>Its standard deviation.</summary>
        public double EdgeRatioDeviation { get; }

        /// <summary>Number of points with negative depth: above 0 left and right are swapped.</summary>
        public int Behind { get; }

        public static TriangulationCheck Of(StereoCalibration calibration) => Of(calibration.Rig, calibration.Pairs);

        /// <param name="rig">Judged.</param>
        /// <param name="pairs">Points that both views of a pair show are used; neighbours are those nearest on the board.</param>
        public static TriangulationCheck Of(StereoRig rig, IReadOnlyList<BoardPair> pairs)
        {
            double sum = 0, squares = 0;
            int edges = 0, behind = 0;
            foreach (BoardPair pair in pairs)
            {
                var placed = new List<(Vector2D Board, Vector3D Space)>();
                foreach ((Vector2D board, Vector2D left, Vector2D right) in Common(pair))
                {
                    if (!Triangulation.TryTriangulate(rig, left, right, out Vector3D point))
                        continue;
                    placed.Add((board, point));
                    behind += point.Z < 0 ? 1 : 0;
                }

                double side = ShortestDistance(placed);
                for (int i = 0; i < placed.Count; i++)
                {
                    for (int j = i + 1; j < placed.Count; j++)
                    {
                        double distance = (placed[i].Board - placed[j].Board).Length;
                        if (distance > 1.01 * side)
                            continue;
                        double ratio = (placed[i].Space - placed[j].Space).Length / distance;
                        sum += ratio;
                        squares += ratio * ratio;
                        edges++;
                    }
                }
            }

            double mean = edges > 0 ? sum / edges : 0;
            return new TriangulationCheck(edges, mean, edges > 0 ? Math.Sqrt(Math.Max(0, squares / edges - mean * mean)) : 0, behind);
        }

        /// <summary>Points of the board that both views show.</summary>
        public static IEnumerable<(Vector2D Board, Vector2D Left, Vector2D Right)> Common(BoardPair pair)
        {
            var right = new Dictionary<Vector2D, Vector2D>();
            for (int i = 0; i < pair.Right.BoardMm.Length; i++)
                right[pair.Right.BoardMm[i]] = pair.Right.ImagePx[i];
            for (int i = 0; i < pair.Left.BoardMm.Length; i++)
            {
                if (right.TryGetValue(pair.Left.BoardMm[i], out Vector2D pixel))
                    yield return (pair.Left.BoardMm[i], pair.Left.ImagePx[i], pixel);
            }
        }

        private static double ShortestDistance(List<(Vector2D Board, Vector3D Space)> points)
        {
            double shortest = double.PositiveInfinity;
            for (int i = 0; i < points.Count; i++)
            {
                for (int j = i + 1; j < points.Count; j++)
                    shortest = Math.Min(shortest, (points[i].Board - points[j].Board).Length);
            }

            return shortest;
        }
    }
}
