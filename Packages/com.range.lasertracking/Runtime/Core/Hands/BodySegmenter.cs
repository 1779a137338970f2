using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Splits a grid into connected surfaces and finds, in each, the parts that stand out before the torso: arms. Surfaces that are
    /// small enough to be an arm without a body in sight count whole; parts that are too large are bodies again.
    /// </summary>
    internal sealed class BodySegmenter
    {
        private const int MaxLevel = 3;

        private readonly DepthHandSettings _settings;
        private readonly TorsoProfile[] _torsos = new TorsoProfile[MaxLevel + 1];
        private int[] _cells = Array.Empty<int>();
        private byte[] _level = Array.Empty<byte>();
        private int _used;
        private DepthGrid _grid = null!;

        public BodySegmenter(DepthHandSettings settings)
        {
            _settings = settings;
            Arms = new ArmPart[settings.MaxHands];
            for (int i = 0; i < _torsos.Length; i++)
                _torsos[i] = new TorsoProfile(settings);
        }

        /// <summary>The arms found; valid up to <see cref="ArmCount"/>, until the next call.</summary>
        public ArmPart[] Arms { get; }

        public int ArmCount { get; private set; }

        public ReadOnlySpan<int> CellsOf(in ArmPart arm) => new ReadOnlySpan<int>(_cells, arm.First, arm.Count);

        public void Segment(DepthGrid grid)
        {
            _grid = grid;
            int cells = grid.Z.Length;
            if (_level.Length != cells)
            {
                _level = new byte[cells];
                _cells = new int[cells * (MaxLevel + 2)];
            }

            _used = 0;
            ArmCount = 0;
            float[] z = grid.Z;
            for (int i = 0; i < cells; i++)
                _level[i] = z[i] > 0 ? (byte)1 : (byte)0;
            for (int i = 0; i < cells; i++)
            {
                if (_level[i] == 1)
                    Examine(Flood(i, 1), 1, null);
            }
        }

        /// <summary>Level n marks cells that wait to be gathered at depth n; a gathered cell carries 0.</summary>
        private void Examine(ArmPart part, int level, TorsoProfile? torso)
        {
            if (part.AreaMm2 < _settings.MinArmAreaMm2)
            {
                _used = part.First;
                return;
            }

            if (part.AreaMm2 <= _settings.MaxArmAreaMm2)
            {
                if (torso != null)
                {
                    double x = torso.MiddleXMm(part.MiddleXMm);
                    part.HasTorso = true;
                    part.TorsoMm = new Vector3D(x, 0, torso.TorsoZ(x));
                }

                Keep(part);
                return;
            }

            if (level > MaxLevel)
                return;
            TorsoProfile profile = _torsos[level - 1];
            MarkForward(part, (byte)(level + 1), profile);
            int end = part.First + part.Count;
            for (int i = part.First; i < end; i++)
            {
                if (_level[_cells[i]] == level + 1)
                    Examine(Flood(_cells[i], (byte)(level + 1)), level + 1, profile);
            }
        }

        private void MarkForward(in ArmPart part, byte level, TorsoProfile profile)
        {
            ReadOnlySpan<int> cells = CellsOf(part);
            profile.Build(_grid, cells);
            float forward = (float)_settings.ForwardMm;
            foreach (int cell in cells)
            {
                float z = _grid.Z[cell];
                double x = _grid.RayX[cell % _grid.Width] * z;
                if (z < profile.TorsoZ(x) - forward)
                    _level[cell] = level;
                else
                    profile.AddTorso(x, z);
            }
        }

        private ArmPart Flood(int seed, byte level)
        {
            int width = _grid.Width, height = _grid.Height;
            float[] z = _grid.Z;
            float step = (float)_settings.SurfaceStepMm;
            int first = _used, next = first;
            double area = 0, sumX = 0;
            float nearest = float.MaxValue;
            _cells[_used++] = seed;
            _level[seed] = 0;
            while (next < _used)
            {
                int cell = _cells[next++];
                float here = z[cell];
                int y = cell / width, x = cell - y * width;
                area += (double)here * here;
                sumX += (double)here * here * here * _grid.RayX[x];
                nearest = Math.Min(nearest, here);
                if (x > 0)
                    Visit(cell - 1, here);
                if (x + 1 < width)
                    Visit(cell + 1, here);
                if (y > 0)
                    Visit(cell - width, here);
                if (y + 1 < height)
                    Visit(cell + width, here);
            }

            return new ArmPart
            {
                First = first, Count = _used - first, AreaMm2 = area * _grid.UnitArea, NearestMm = nearest, MiddleXMm = sumX / area,
            };

            void Visit(int neighbour, float here)
            {
                if (_level[neighbour] != level || Math.Abs(z[neighbour] - here) > step)
                    return;
                _level[neighbour] = 0;
                _cells[_used++] = neighbour;
            }
        }

        /// <summary>Keeps the nearest arms when there are more than there is room for.</summary>
        private void Keep(in ArmPart part)
        {
            if (ArmCount < Arms.Length)
            {
                Arms[ArmCount++] = part;
                return;
            }

            int farthest = 0;
            for (int i = 1; i < ArmCount; i++)
            {
                if (Arms[i].NearestMm > Arms[farthest].NearestMm)
                    farthest = i;
            }

            if (part.NearestMm < Arms[farthest].NearestMm)
                Arms[farthest] = part;
        }
    }
}
