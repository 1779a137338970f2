using System;
using LaserTracking.Geometry;
using LaserTracking.Kernels;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Splits a grid into connected surfaces and finds, in each, the parts that stand out before the torso: arms. Surfaces that are
    /// small enough to be an arm without a body in sight count whole; parts that are too large are bodies again.
    /// </summary>
    internal sealed unsafe class BodySegmenter
    {
        public const int MaybeHead = 128;

        private const int MaxLevel = 3;
        private const int MinContacts = 2;

        /// <summary>How much of an arm's depth, from behind, is its root.</summary>
        private const double RootShare = 0.2;

        /// <summary>Longest way from a hand back to what is seen of its own arm: half an arm.</summary>
        private const double MaxReachMm = 450;

        /// <summary>Neighbours' middles are at least 0.4 m apart.</summary>
        private const double SamePersonMm = 180;

        /// <summary>What is seen of a head is no deeper, what points at the camera is.</summary>
        private const double HeadDepthMm = 220;

        private readonly DepthHandSettings _settings;
        private readonly KernelRunner _kernels;
        private readonly TorsoProfile _torsos;
        private readonly int[] _contacts;
        private int[] _cells = Array.Empty<int>();
        private byte[] _owner = Array.Empty<byte>();
        private float[] _before = Array.Empty<float>();
        private byte[] _level = Array.Empty<byte>();
        private int _used;
        private DepthGrid _grid = null!;

        public BodySegmenter(DepthHandSettings settings, KernelRunner kernels)
        {
            _settings = settings;
            _kernels = kernels;
            _torsos = new TorsoProfile(settings, kernels);
            Arms = new ArmPart[2 * settings.MaxHands];
            _contacts = new int[Arms.Length * Arms.Length];
        }

        /// <summary>The arms found; valid up to <see cref="ArmCount"/>, until the next call.</summary>
        public ArmPart[] Arms { get; }

        public int ArmCount { get; private set; }

        /// <summary>0 beside arms, else i + 1 in the cells of arm i, or <see cref="MaybeHead"/> + i where that is no deeper than a head.</summary>
        public byte[] Owner => _owner;

        public ReadOnlySpan<int> CellsOf(in ArmPart arm) => new ReadOnlySpan<int>(_cells, arm.First, arm.Count);

        public void Segment(DepthGrid grid)
        {
            _grid = grid;
            int cells = grid.Z.Length;
            if (_level.Length != cells)
            {
                _level = new byte[cells];
                _owner = new byte[cells];
                _before = new float[cells];
                _cells = new int[cells * (MaxLevel + 2)];
            }

            _used = 0;
            ArmCount = 0;
            _torsos.Clear();
            fixed (float* z = grid.Z, rayX = grid.RayX, rayY = grid.RayY, before = _before)
            fixed (byte* levels = _level)
            fixed (int* list = _cells)
            {
                var start = new DepthLevelBands { Width = grid.Width, Z = z, Levels = levels, Before = before };
                _kernels.Run(&start, grid.Height);
                var whole = new SurfaceBands
                {
                    Width = grid.Width,
                    Height = grid.Height,
                    StepMm = (float)_settings.SurfaceStepMm,
                    Level = 1,
                    SeedCount = cells,
                    Z = z,
                    RayX = rayX,
                    Before = before,
                    Levels = levels,
                    Cells = list,
                };
                Gather(whole, rayY);
            }

            PlaceOnTorsos();
            JoinOccluded();
            Array.Clear(_owner, 0, _owner.Length);
            for (int i = 0; i < ArmCount; i++)
            {
                PlaceEye(ref Arms[i]);
                foreach (int cell in CellsOf(Arms[i]))
                    _owner[cell] = (byte)(Arms[i].IsShallow ? MaybeHead + i : i + 1);
            }
        }

        /// <summary>Finds each part's torso; what floats at a torso's distance is a head or a leg of it, cut off by lost edges.</summary>
        private void PlaceOnTorsos()
        {
            int kept = 0;
            for (int i = 0; i < ArmCount; i++)
            {
                ArmPart arm = Arms[i];
                if (_torsos.TryTorso(arm.MiddleXMm, out double x, out double z))
                {
                    double reach = z - arm.NearestMm;
                    arm.HasTorso = reach > 0 && reach < 2 * MaxReachMm;
                    arm.TorsoMm = new Vector3D(x, 0, z);
                    if (arm.ReachMm == float.MaxValue && reach < _settings.MinReachMm)
                    {
                        if (Math.Abs(reach) < _settings.MinReachMm)
                            AddTop(arm);
                        continue;
                    }
                }

                Arms[kept++] = arm;
            }

            ArmCount = kept;
        }

        /// <summary>The torso at the arm's rear end, where the shoulder is: a hand may well be before a neighbour.</summary>
        private void PlaceEye(ref ArmPart arm)
        {
            double far = 0;
            foreach (int cell in CellsOf(arm))
                far = Math.Max(far, _grid.Z[cell]);
            double limit = far - RootShare * (far - arm.NearestMm), low = double.MaxValue, high = double.MinValue;
            Vector3D sum = default, all = default;
            int count = 0;
            foreach (int cell in CellsOf(arm))
            {
                Vector3D point = _grid.Point(cell);
                all += point;
                if (point.Z < limit)
                    continue;
                sum += point;
                low = Math.Min(low, point.X);
                high = Math.Max(high, point.X);
                count++;
            }

            arm.MiddleMm = all * (1.0 / arm.Count);
            arm.IsShallow = far - arm.NearestMm < HeadDepthMm;
            arm.RootMm = sum * (1.0 / count);
            arm.RootXMm = arm.RootMm.X;
            arm.HasOneRoot = high - low < _settings.TorsoHalfWidthMm && far - arm.NearestMm > _settings.HandLengthMm;
            arm.HasTorso = _torsos.TryTorso(arm.RootXMm, out double x, out double z) && z > arm.NearestMm && z - arm.NearestMm < 2 * MaxReachMm;
            arm.TorsoMm = new Vector3D(x, 0, z);
            double top = 0;
            arm.HasEye = arm.HasTorso && _torsos.TryTop(x, out top);
            arm.EyeMm = new Vector3D(x, top + _settings.EyeBelowCrownMm, z);
        }

        private void AddTop(in ArmPart part)
        {
            foreach (int cell in CellsOf(part))
            {
                Vector3D point = _grid.Point(cell);
                _torsos.AddTop(point.X, point.Y);
            }
        }

        /// <summary>All surfaces of a level. Level n marks cells that wait to be gathered at depth n.</summary>
        private void Gather(SurfaceBands surfaces, float* rayY)
        {
            while (true)
            {
                surfaces.Used = _used;
                _kernels.Run(&surfaces, 1);
                if (surfaces.Count == 0)
                    return;
                _used = surfaces.Used;
                Examine(surfaces, rayY);
            }
        }

        private void Examine(in SurfaceBands surface, float* rayY)
        {
            var part = new ArmPart
            {
                First = surface.Used - surface.Count, Count = surface.Count, AreaMm2 = surface.Area * _grid.UnitArea, NearestMm = surface.NearestMm,
                MiddleXMm = surface.SumX / surface.Area, ReachMm = surface.ReachMm,
            };
            if (part.AreaMm2 < _settings.MinArmAreaMm2 / 4)
            {
                _used = part.First;
                return;
            }

            if (part.AreaMm2 <= _settings.MaxArmAreaMm2)
            {
                Keep(part);
                return;
            }

            if (surface.Level > MaxLevel)
                return;
            int* cells = surface.Cells + part.First;
            _torsos.Split(surface, cells, part.Count, rayY);
            SurfaceBands parts = surface;
            parts.Level++;
            parts.Seeds = cells;
            parts.SeedCount = part.Count;
            parts.Next = 0;
            Gather(parts, rayY);
        }

        /// <summary>
        /// A hand that points at the camera hides most of its own forearm; what is seen of that begins far behind it and is a part
        /// of its own. Parts of one person that touch in the picture, one behind the other within an arm's reach, are one arm.
        /// </summary>
        private void JoinOccluded()
        {
            Array.Clear(_owner, 0, _owner.Length);
            Array.Clear(_contacts, 0, _contacts.Length);
            int stride = Arms.Length;
            for (int i = 0; i < ArmCount; i++)
            {
                foreach (int cell in CellsOf(Arms[i]))
                    _owner[cell] = (byte)(i + 1);
            }

            for (int i = 0; i < ArmCount; i++)
            {
                foreach (int cell in CellsOf(Arms[i]))
                {
                    int x = cell % _grid.Width;
                    if (x + 2 < _grid.Width)
                        Touch(cell, cell + 1, cell + 2);
                    if (cell + 2 * _grid.Width < _owner.Length)
                        Touch(cell, cell + _grid.Width, cell + 2 * _grid.Width);
                }
            }

            for (int i = ArmCount - 1; i > 0; i--)
            {
                int best = -1;
                for (int k = 0; k < i; k++)
                {
                    if (_contacts[k * stride + i] >= MinContacts && AreOnePerson(Arms[i], Arms[k])
                        && (best < 0 || _contacts[k * stride + i] > _contacts[best * stride + i]))
                        best = k;
                }

                if (best >= 0)
                    Join(best, i);
            }

            int kept = 0;
            for (int i = 0; i < ArmCount; i++)
            {
                if (Arms[i].AreaMm2 >= _settings.MinArmAreaMm2 && Arms[i].ReachMm >= _settings.MinReachMm)
                    Arms[kept++] = Arms[i];
            }

            ArmCount = kept;

            // The cell between may be lost: edges often are.
            void Touch(int cell, int next, int afterNext)
            {
                int a = _owner[cell] - 1, b = _owner[next] - 1;
                int other = next;
                if (b < 0 && _grid.Z[next] == 0)
                {
                    b = _owner[afterNext] - 1;
                    other = afterNext;
                }

                if (b < 0 || a == b || Math.Abs(_grid.Z[cell] - _grid.Z[other]) > MaxReachMm)
                    return;
                _contacts[Math.Min(a, b) * stride + Math.Max(a, b)]++;
            }
        }

        private static bool AreOnePerson(in ArmPart a, in ArmPart b) =>
            !a.HasTorso || !b.HasTorso || Math.Abs(a.TorsoMm.X - b.TorsoMm.X) < SamePersonMm;

        /// <summary>Moves part i behind part k; both are copied to the end of the list.</summary>
        private void Join(int k, int i)
        {
            ref ArmPart a = ref Arms[k];
            ref readonly ArmPart b = ref Arms[i];
            int first = _used;
            // One arm seen in two pieces is no larger than half of what two arms may be; more are neighbours' that cross.
            if (first + a.Count + b.Count > _cells.Length || a.AreaMm2 + b.AreaMm2 > 0.5 * _settings.MaxArmAreaMm2)
                return;
            Array.Copy(_cells, a.First, _cells, first, a.Count);
            Array.Copy(_cells, b.First, _cells, first + a.Count, b.Count);
            _used += a.Count + b.Count;
            double area = a.AreaMm2 + b.AreaMm2;
            a = new ArmPart
            {
                First = first,
                Count = a.Count + b.Count,
                AreaMm2 = area,
                NearestMm = Math.Min(a.NearestMm, b.NearestMm),
                ReachMm = Math.Max(a.ReachMm, b.ReachMm),
                MiddleXMm = (a.MiddleXMm * a.AreaMm2 + b.MiddleXMm * b.AreaMm2) / area,
                HasTorso = a.HasTorso || b.HasTorso,
                TorsoMm = a.HasTorso ? a.TorsoMm : b.TorsoMm,
            };
            for (int m = 0; m < k; m++)
                _contacts[m * Arms.Length + k] += _contacts[m * Arms.Length + i];
            Arms[i].AreaMm2 = 0;
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
