using System;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// The last poses of something that moves in a way nobody can compute, so that its place at a shot's photon time can be looked
    /// up. A ring of fixed length; no allocation after construction; one thread at a time.
    /// </summary>
    public sealed class PoseHistory
    {
        private readonly double[] _timesS;
        private readonly Pose[] _poses;
        private int _start;

        /// <param name="capacity">Poses kept, at least two. 128 at 60 per second reach two seconds back.</param>
        public PoseHistory(int capacity)
        {
            if (capacity < 2)
                throw new ArgumentException("a pose history keeps at least two poses");
            _timesS = new double[capacity];
            _poses = new Pose[capacity];
        }

        public int Count { get; private set; }

        /// <summary>
        /// Remembers a pose. A time before the last one means that the clock was set back: the past is forgotten. While the clock stands
        /// still the newest pose counts.
        /// </summary>
        public void Add(double timeS, Pose pose)
        {
            if (Count > 0 && timeS == _timesS[Slot(Count - 1)])
            {
                _poses[Slot(Count - 1)] = pose;
                return;
            }

            if (Count > 0 && !(timeS > _timesS[Slot(Count - 1)]))
                Count = 0;
            if (Count == _timesS.Length)
                _start = (_start + 1) % _timesS.Length;
            else
                Count++;
            int slot = Slot(Count - 1);
            _timesS[slot] = timeS;
            _poses[slot] = pose;
        }

        /// <summary>
        /// The pose at a time, between two remembered ones interpolated: linearly, and by the normalised mean of the rotations.
        /// Before the first and after the last it is the first and the last. False while nothing is remembered.
        /// </summary>
        public bool TryGetPoseAt(double timeS, out Pose pose)
        {
            if (Count == 0)
            {
                pose = Pose.Identity;
                return false;
            }

            int after = 0;
            while (after < Count && _timesS[Slot(after)] <= timeS)
                after++;
            if (after == 0 || after == Count)
            {
                pose = _poses[Slot(after == 0 ? 0 : Count - 1)];
                return true;
            }

            int a = Slot(after - 1), b = Slot(after);
            pose = Between(_poses[a], _poses[b], (timeS - _timesS[a]) / (_timesS[b] - _timesS[a]));
            return true;
        }

        public void Clear() => Count = 0;

        internal static Pose Between(Pose a, Pose b, double part)
        {
            Rotation3D p = a.Rotation, q = b.Rotation;
            // q and -q are the same rotation: take the nearer one, or the mean goes the long way round.
            double s = p.X * q.X + p.Y * q.Y + p.Z * q.Z + p.W * q.W < 0 ? -part : part;
            double r = 1 - part;
            return new Pose(a.Position + (b.Position - a.Position) * part,
                new Rotation3D(r * p.X + s * q.X, r * p.Y + s * q.Y, r * p.Z + s * q.Z, r * p.W + s * q.W));
        }

        private int Slot(int index) => (_start + index) % _timesS.Length;
    }
}
