using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>Who stands where: heads averaged over many frames. Upright space inside (x along the screen, y up, z away from it), mm.</summary>
    internal sealed class PersonSet
    {
        private struct Person
        {
            public int Id;
            public Vector3D EyeMm;
            public int Sightings;

            /// <summary>Of the sightings that the place is the mean of.</summary>
            public double Weight;

            /// <summary>Their arms were seen, never their head.</summary>
            public bool IsHeadHidden;
            public long SeenUs;
        }

        /// <summary>Two heads are farther apart; neighbours' middles are at least 400 mm apart.</summary>
        private const double SamePersonMm = 230;

        private const double HeadRadiusMm = 150;

        /// <summary>A shoulder is at most so far from its head, seen from above.</summary>
        private const double ShoulderMm = 420;

        /// <summary>Nor is it behind the eyes: such an arm belongs to somebody whom this one hides.</summary>
        private const double BehindEyesMm = 300;

        /// <summary>From where a hidden person's arm appears up to about their eyes, and how well that is known.</summary>
        private const double EyesAboveArmMm = 150;
        private const double HiddenSigmaMm = 150;

        /// <summary>So many sightings of an arm without a head make a person whose head is hidden: one second.</summary>
        private const int NeededArms = 30;

        /// <summary>Further off in height it is not the same head.</summary>
        private const double HeadStepMm = 70;

        /// <summary>What is so much nearer to the screen is an arm before the head.</summary>
        private const double NearerStepMm = 150;

        /// <summary>How fast a head that is seen only lower comes down, a sighting.</summary>
        private const double SinkShare = 0.005;

        /// <summary>Fewer sightings may be a chair or a raised hand.</summary>
        private const int NeededSightings = 10;

        /// <summary>From the eyes to a muzzle held out.</summary>
        private const double MinArmMm = 450;
        private const double MaxArmMm = 1050;

        /// <summary>
        /// A weapon's bearing is known to 0.18 rad: with 2.5 times that between the squares another is twenty times likelier. An arm without a
        /// person goes to whom it points away from within that.
        /// </summary>
        private const double ClearRad = 0.45;
        private const double AnybodysRad = 0.55;

        private const long MemoryUs = 20_000_000;
        private const int MaxWeight = 30;

        /// <summary>What is so much lower or nearer than known is hardly all of the head; how much it counts nevertheless.</summary>
        private const double HiddenStepMm = 12;
        private const double LeastWeight = 0.02;

        private readonly DepthHandSettings _settings;
        private readonly UprightFrame _upright;
        private readonly Person[] _people;
        private int _count;
        private int _nextId = 1;

        public PersonSet(DepthHandSettings settings, UprightFrame upright)
        {
            _settings = settings;
            _upright = upright;
            _people = new Person[settings.MaxHands];
        }

        public void Reset()
        {
            _count = 0;
            _nextId = 1;
        }

        public int Count => _count;

        /// <summary>Forgets who left.</summary>
        public void Begin(long timeUs)
        {
            int kept = 0;
            for (int i = 0; i < _count; i++)
            {
                long age = timeUs - _people[i].SeenUs;
                // Also when time runs backwards, after a seek.
                if (age >= 0 && age <= MemoryUs && (age < MemoryUs / 20 || _people[i].Sightings >= NeededSightings))
                    _people[kept++] = _people[i];
            }

            _count = kept;
            Merge();
        }

        /// <summary>Two that have come to stand at one place were one; the one known longer stays.</summary>
        private void Merge()
        {
            for (int i = 0; i < _count; i++)
            {
                for (int k = _count - 1; k > i; k--)
                {
                    if (Beside(_people[i].EyeMm, _people[k].EyeMm) >= SamePersonMm)
                        continue;
                    bool isBetter = _people[i].IsHeadHidden != _people[k].IsHeadHidden ? _people[i].IsHeadHidden : _people[k].Sightings > 2 * _people[i].Sightings;
                    int stays = isBetter ? k : i;
                    _people[i] = _people[stays];
                    for (int m = k + 1; m < _count; m++)
                        _people[m - 1] = _people[m];
                    _count--;
                }
            }
        }

        /// <summary>Notes a head; upright space. Of what stands at one place the highest is the head: a shoulder may hide it, or an arm.</summary>
        public void See(Vector3D eyeMm, long timeUs)
        {
            int best = -1;
            double bestDistance = SamePersonMm;
            for (int i = 0; i < _count; i++)
            {
                double distance = Beside(_people[i].EyeMm, eyeMm);
                if (distance >= bestDistance)
                    continue;
                best = i;
                bestDistance = distance;
            }

            if (best < 0)
            {
                if (_count < _people.Length)
                    _people[_count++] = new Person { EyeMm = eyeMm, Sightings = 1, Weight = 1, SeenUs = timeUs };
                return;
            }

            ref Person person = ref _people[best];
            person.SeenUs = timeUs;
            if (person.IsHeadHidden)
            {
                person.IsHeadHidden = false;
                person.Sightings = 1;
                person.Weight = 1;
                person.EyeMm = eyeMm;
                return;
            }

            double higher = eyeMm.Y - person.EyeMm.Y, nearer = person.EyeMm.Z - eyeMm.Z;
            if (higher < -HeadStepMm || nearer > NearerStepMm)
            {
                // Not for ever: people crouch and come nearer.
                person.EyeMm += (eyeMm - person.EyeMm) * SinkShare;
                return;
            }

            if (higher > HeadStepMm || nearer < -NearerStepMm)
            {
                person.Sightings = Math.Min(person.Sightings, NeededSightings);
                person.Weight = Math.Min(person.Weight, NeededSightings);
            }

            person.Sightings++;

            // With a hand or a weapon before it a head seems lower and nearer than it is.
            double low = Math.Max(0, -higher) / HiddenStepMm, near = Math.Max(0, nearer) / HiddenStepMm;
            double weight = LeastWeight + (1 - LeastWeight) * Math.Exp(-0.5 * (low * low + near * near));
            person.Weight = Math.Min(MaxWeight, person.Weight + weight);
            person.EyeMm += (eyeMm - person.EyeMm) * (weight / person.Weight);
            if (person.Id == 0 && person.Sightings >= NeededSightings)
                person.Id = _nextId++;
        }

        /// <summary>Notes where an arm begins over which nobody's head is known; camera space.</summary>
        public void SeeArm(Vector3D rootMm, long timeUs)
        {
            Vector3D eye = _upright.ToUpright(rootMm) + new Vector3D(0, EyesAboveArmMm, 0);
            for (int i = 0; i < _count; i++)
            {
                ref Person person = ref _people[i];
                if (Beside(person.EyeMm, eye) >= ShoulderMm || eye.Z - person.EyeMm.Z > BehindEyesMm)
                    continue;
                if (!person.IsHeadHidden)
                    return;
                person.SeenUs = timeUs;
                person.Sightings++;
                person.EyeMm += (eye - person.EyeMm) * (1.0 / Math.Min(MaxWeight, person.Sightings));
                if (person.Id == 0 && person.Sightings >= NeededArms)
                    person.Id = _nextId++;
                return;
            }

            if (_count < _people.Length)
                _people[_count++] = new Person { EyeMm = eye, Sightings = 1, SeenUs = timeUs, IsHeadHidden = true };
        }

        /// <summary>Distance seen from above; that from the screen counts a third: nobody fires from right behind another.</summary>
        private static double Beside(Vector3D a, Vector3D b)
        {
            double x = a.X - b.X, z = 0.35 * (a.Z - b.Z);
            return Math.Sqrt(x * x + z * z);
        }

        /// <summary>Whose arm begins here, or 0; camera space. Gives their eyes too, which are a guess where only arms were seen.</summary>
        public int Find(Vector3D rootMm, out Vector3D eyeMm, out bool isHeadHidden)
        {
            Vector3D root = _upright.ToUpright(rootMm);
            int best = -1;
            double bestDistance = ShoulderMm;
            for (int i = 0; i < _count; i++)
            {
                double distance = Beside(_people[i].EyeMm, root);
                if (_people[i].Id == 0 || distance >= bestDistance || root.Z - _people[i].EyeMm.Z > BehindEyesMm)
                    continue;
                best = i;
                bestDistance = distance;
            }

            eyeMm = best < 0 ? default : _upright.ToCamera(_people[best].EyeMm);
            isHeadHidden = best >= 0 && _people[best].IsHeadHidden;
            return best < 0 ? 0 : _people[best].Id;
        }

        /// <summary>Who may hold a weapon's muzzle here: whose eyes are at about an arm's length; camera space. Somebody else than who is given.</summary>
        public bool TryReach(Vector3D muzzleMm, int exceptId, out int id, out Vector3D eyeMm)
        {
            Vector3D muzzle = _upright.ToUpright(muzzleMm);
            double best = double.MaxValue;
            id = 0;
            eyeMm = default;
            for (int i = 0; i < _count; i++)
            {
                double reach = (_people[i].EyeMm - muzzle).Length, off = Math.Abs(reach - (MinArmMm + MaxArmMm) / 2);
                if (_people[i].Id == 0 || _people[i].Id == exceptId || _people[i].IsHeadHidden || reach < MinArmMm || reach > MaxArmMm || off >= best)
                    continue;
                best = off;
                id = _people[i].Id;
                eyeMm = _upright.ToCamera(_people[i].EyeMm);
            }

            return id != 0;
        }

        /// <summary>
        /// Whose weapon lies along this direction; camera space. True, with somebody else than now, when their eyes are so much nearer behind it that
        /// it is clearly theirs: where arms cross, an arm's rear end is a neighbour's.
        /// </summary>
        public bool TryOwner(Vector3D muzzleMm, Vector3D direction, int nowId, out int id, out Vector3D eyeMm)
        {
            Vector3D muzzle = _upright.ToUpright(muzzleMm), ahead = _upright.ToUpright(muzzleMm + direction * MaxArmMm) - muzzle;
            double best = double.MaxValue, now = AnybodysRad * AnybodysRad;
            id = 0;
            eyeMm = default;
            for (int i = 0; i < _count; i++)
            {
                Vector3D sight = muzzle - _people[i].EyeMm;
                if (_people[i].Id == 0 || _people[i].IsHeadHidden)
                    continue;
                double turn = Vector3D.Turn(ahead, sight);
                if (_people[i].Id == nowId)
                    now = turn * turn;
                if (sight.Length < MinArmMm || sight.Length > MaxArmMm || turn * turn >= best)
                    continue;
                best = turn * turn;
                id = _people[i].Id;
                eyeMm = _upright.ToCamera(_people[i].EyeMm);
            }

            return id != 0 && id != nowId && now - best > ClearRad * ClearRad;
        }

        /// <summary>One of all who were seen: where about their eyes are, upright space, and the standard deviation of that; false for who is not known yet.</summary>
        public bool TryEyes(int index, out int id, out Vector3D eyeMm, out double sigmaMm)
        {
            ref readonly Person person = ref _people[index];
            id = person.Id;
            eyeMm = person.EyeMm;
            sigmaMm = person.IsHeadHidden ? HiddenSigmaMm : _settings.EyeSigmaMm;
            return id != 0;
        }

        /// <summary>Where somebody's eyes are; camera space. False for who left, and whose head nobody has seen.</summary>
        public bool TryEyesOf(int id, out Vector3D eyeMm)
        {
            for (int i = 0; i < _count; i++)
            {
                if (_people[i].Id != id || _people[i].IsHeadHidden)
                    continue;
                eyeMm = _upright.ToCamera(_people[i].EyeMm);
                return true;
            }

            eyeMm = default;
            return false;
        }

        /// <summary>Whether a surface with this middle is somebody's head.</summary>
        public bool IsHead(Vector3D middleMm)
        {
            Vector3D middle = _upright.ToUpright(middleMm);
            for (int i = 0; i < _count; i++)
            {
                if (_people[i].Id != 0 && !_people[i].IsHeadHidden && (_people[i].EyeMm - middle).Length < HeadRadiusMm)
                    return true;
            }

            return false;
        }

        public void Report(HandObservations observations)
        {
            for (int i = 0; i < _count; i++)
            {
                if (_people[i].Id != 0)
                    observations.Add(new PersonObservation { PersonId = _people[i].Id, EyeMm = _upright.ToCamera(_people[i].EyeMm), SigmaMm = _people[i].IsHeadHidden ? HiddenSigmaMm : _settings.EyeSigmaMm, HeightSigmaMm = _people[i].IsHeadHidden ? HiddenSigmaMm : _settings.EyeHeightSigmaMm });
            }
        }
    }
}
