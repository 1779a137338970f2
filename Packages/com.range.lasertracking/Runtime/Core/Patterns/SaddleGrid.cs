using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>Saddle points that lie as the corners of a checkerboard do, numbered along its two directions from an arbitrary one.</summary>
    internal sealed class SaddleGrid
    {
        private const double LeastCellPx = 4, MostCellPx = 160;

        /// <summary>How far from an edge's direction its next corner may lie (sine), and from where it is expected, as a share of a cell.</summary>
        private const double LargestSine = 0.2, LargestMiss = 0.3;

        private readonly List<ScreenSaddle> _saddles;
        private readonly Queue<Node> _open = new Queue<Node>();

        private SaddleGrid(List<ScreenSaddle> saddles) => _saddles = saddles;

        /// <summary>Corners by their numbers.</summary>
        public Dictionary<(int U, int V), Vector2D> Corners { get; } = new Dictionary<(int, int), Vector2D>();

        /// <summary>All grids of at least so many corners, largest first. No saddle belongs to two.</summary>
        public static List<SaddleGrid> FindAll(List<ScreenSaddle> saddles, int leastCorners)
        {
            var grids = new List<SaddleGrid>();
            var isUsed = new bool[saddles.Count];
            for (int seed = 0; seed < saddles.Count; seed++)
            {
                if (isUsed[seed])
                    continue;
                var grid = new SaddleGrid(saddles);
                if (grid.TryGrow(seed, isUsed, leastCorners))
                    grids.Add(grid);
            }

            grids.Sort((a, b) => b.Corners.Count.CompareTo(a.Corners.Count));
            return grids;
        }

        private bool TryGrow(int seed, bool[] isUsed, int leastCorners)
        {
            ScreenSaddle start = _saddles[seed];
            if (!TryStep(seed, start.FirstEdge, isUsed, out Vector2D along) || !TryStep(seed, start.SecondEdge, isUsed, out Vector2D across))
                return false;
            if (Vector2D.Cross(along, across) < 0)
                (along, across) = (across, along);
            if (Vector2D.Cross(along, across) < 0.2 * along.Length * across.Length)
                return false;
            var members = new List<int>();
            Enter(new Node(seed, 0, 0, along, across), isUsed, members);
            while (_open.Count > 0)
            {
                Node node = _open.Dequeue();
                for (int side = 0; side < 4; side++)
                    Extend(node, side, isUsed, members);
            }

            if (Corners.Count >= leastCorners)
                return true;
            foreach (int member in members)
                isUsed[member] = false;
            return false;
        }

        private void Extend(in Node node, int side, bool[] isUsed, List<int> members)
        {
            int sign = side % 2 == 0 ? 1 : -1, u = node.U + (side < 2 ? sign : 0), v = node.V + (side < 2 ? 0 : sign);
            if (Corners.ContainsKey((u, v)))
                return;
            ScreenSaddle here = _saddles[node.Saddle];
            Vector2D step = (side < 2 ? node.Along : node.Across) * sign;
            int next = Nearest(here, here.Place + step, LargestMiss * step.Length, isUsed);
            if (next < 0)
                return;
            Vector2D taken = (_saddles[next].Place - here.Place) * sign;
            Enter(new Node(next, u, v, side < 2 ? taken : node.Along, side < 2 ? node.Across : taken), isUsed, members);
        }

        private void Enter(in Node node, bool[] isUsed, List<int> members)
        {
            isUsed[node.Saddle] = true;
            members.Add(node.Saddle);
            Corners.Add((node.U, node.V), _saddles[node.Saddle].Place);
            _open.Enqueue(node);
        }

        private int Nearest(in ScreenSaddle from, Vector2D place, double radius, bool[] isUsed)
        {
            int best = -1;
            double least = radius * radius;
            for (int i = 0; i < _saddles.Count; i++)
            {
                double distance = (_saddles[i].Place - place).LengthSquared;
                if (distance < least && !isUsed[i] && from.IsOpposite(_saddles[i]))
                {
                    best = i;
                    least = distance;
                }
            }

            return best;
        }

        /// <summary>The way to the nearest corner along an edge, to either side.</summary>
        private bool TryStep(int seed, Vector2D edge, bool[] isUsed, out Vector2D step)
        {
            ScreenSaddle start = _saddles[seed];
            step = default;
            double least = MostCellPx * MostCellPx;
            for (int i = 0; i < _saddles.Count; i++)
            {
                Vector2D way = _saddles[i].Place - start.Place;
                double squared = way.LengthSquared;
                if (squared >= least || squared < LeastCellPx * LeastCellPx || isUsed[i] || !start.IsOpposite(_saddles[i]))
                    continue;
                double cross = Vector2D.Cross(edge, way);
                if (cross * cross > LargestSine * LargestSine * squared)
                    continue;
                least = squared;
                step = Vector2D.Dot(edge, way) < 0 ? way * -1 : way;
            }

            return least < MostCellPx * MostCellPx;
        }

        private readonly struct Node
        {
            public readonly int Saddle, U, V;
            public readonly Vector2D Along, Across;

            public Node(int saddle, int u, int v, Vector2D along, Vector2D across)
            {
                Saddle = saddle;
                U = u;
                V = v;
                Along = along;
                Across = across;
            }
        }
    }
}
