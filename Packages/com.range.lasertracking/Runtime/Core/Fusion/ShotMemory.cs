using System;
using LaserTracking.Geometry;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// The last shots and who may have fired them, weighed again and again with what later shots have shown: a shot that nobody could be
    /// told for at first teaches once the others' lines are known. Each is weighed against what all others tell (expectation
    /// propagation, sequential), a few a frame. Bounded, without allocation, deterministic.
    /// </summary>
    internal sealed class ShotMemory
    {
        private struct Line
        {
            public int PersonId;
            public int TrackId;
            public Vector3D MuzzleM;
            public double MuzzleSigmaM;
            public bool IsSwing;
            public Vector3D EyeM;

            /// <summary>Probability that is due to the line, through its density, and the rest of it.</summary>
            public double Factor;
            public double Rest;

            public double Share;
            public SightEvidence Evidence;
        }

        private struct Remembered
        {
            public long TimeUs;
            public Vector3D DotM;
            public int Lines;
            public bool IsRipe;

            /// <summary>Probability, when it was weighed first, that it came from none of the lines.</summary>
            public double Others;
        }

        private const int Capacity = 32;
        private const int LinesEach = 6;

        /// <summary>Weighed again for each of camera 1's frames: of the newest those whose hands are known better by now, and some in turn.</summary>
        private const int Newest = 4;
        private const int EachFrame = 4;

        /// <summary>Logarithm of how much likelier all shots must be with a line learned anew.</summary>
        private const double MinGain = 1;

        /// <summary>Sightings farther apart are not interpolated between.</summary>
        private const long GapUs = 120_000;

        /// <summary>Who moved that far has half forgotten how they stood.</summary>
        private const double MovedM = 0.2;

        /// <summary>
        /// From a swing, the muzzle is known worse by so much: at half a metre a second it is that far on after the 100 ms that camera 1's clock may be off.
        /// </summary>
        private const double SwingSigmaM = 0.05;

        private readonly HandCamera _camera;
        private readonly FusionSettings _settings;
        private readonly SightLines _sights;
        private readonly Remembered[] _shots = new Remembered[Capacity];
        private readonly Line[] _lines = new Line[Capacity * LinesEach];
        private readonly PairedHand[] _hands;

        /// <summary>Those of one moment: shots of one frame ripen together.</summary>
        private readonly PairedHand[] _gathered;
        private int _gatheredCount;
        private long? _gatheredUs;
        private int _count;
        private int _start;
        private int _next;

        /// <summary>All lines as they were before one was tried anew, and for whom that is to be done.</summary>
        private readonly Line[] _kept = new Line[Capacity * LinesEach];
        private readonly int[] _doubted = new int[LinesEach];
        private int _doubtedCount;

        /// <summary>Highest probability of the newest shot's lines.</summary>
        private double _likeliest;

        public ShotMemory(HandCamera camera, FusionSettings settings, SightLines sights)
        {
            _camera = camera;
            _settings = settings;
            _sights = sights;
            _hands = new PairedHand[settings.MaxHands];
            _gathered = new PairedHand[settings.MaxHands];
        }

        public void Clear()
        {
            _count = _start = _next = _doubtedCount = 0;
        }

        /// <summary>Begins to remember a shot; its lines are added next.</summary>
        public void Begin(long timeUs, Vector2D screenM)
        {
            if (_count == Capacity)
                Forget();
            _likeliest = 0;
            _shots[Place(_count++)] = new Remembered { TimeUs = timeUs, DotM = new Vector3D(screenM.X, screenM.Y, 0), Others = 1 };
        }

        /// <param name="personId">Whose.</param>
        /// <param name="pair">With which hand.</param>
        /// <param name="probability">That it was them.</param>
        /// <param name="sightShare">Share of that which the line of sight's density stands for; 0: this line is not to be learned from.</param>
        /// <param name="isSwing">Fired from a swing: shows roughly where the line lies, and nothing of how closely they keep to it.</param>
        public void Add(int personId, in FusedShot pair, double probability, double sightShare, bool isSwing)
        {
            int at = Place(_count - 1);
            ref Remembered shot = ref _shots[at];
            if (shot.Lines == LinesEach || !_sights.TryEyes(personId, out Vector3D eyes))
                return;
            var line = new Line { PersonId = personId, TrackId = pair.HandTrackId, MuzzleM = pair.MuzzleM, MuzzleSigmaM = SigmaM(pair.MuzzleSigmaM, isSwing), IsSwing = isSwing, EyeM = eyes, Rest = probability };
            if (sightShare > 0 && TryDensity(line, shot.DotM, out double density, out _) && density > 0)
            {
                line.Factor = probability * sightShare / density;
                line.Rest = probability * (1 - sightShare);
            }

            shot.Others = Math.Max(0, shot.Others - probability);
            _likeliest = Math.Max(_likeliest, probability);
            _lines[at * LinesEach + shot.Lines++] = line;
        }

        /// <summary>Learns from the shot just added.</summary>
        public void End()
        {
            int at = Place(_count - 1);
            Weigh(at);
            if (_likeliest >= _settings.MinProbability)
                return;

            // A shot that nobody can be told for may be somebody's whose line was learned from another's.
            _doubtedCount = 0;
            for (int i = 0; i < _shots[at].Lines; i++)
            {
                if (_lines[at * LinesEach + i].Factor > 0)
                    _doubted[_doubtedCount++] = _lines[at * LinesEach + i].PersonId;
            }
        }

        /// <summary>
        /// Learns somebody's line anew and keeps it where all shots together are likelier so. A line that one wrong shot has taught holds itself up, as
        /// shots beside it teach nothing.
        /// </summary>
        private void TryAnew(int personId)
        {
            double before = Reweigh();
            Array.Copy(_lines, _kept, _lines.Length);
            SightEvidence old = _sights.Old(personId);
            LearnAnew(personId);
            Reweigh();
            if (Reweigh() > before + MinGain)
                return;
            for (int i = 0; i < _count; i++)
                Unlearn(Place(i));
            Array.Copy(_kept, _lines, _lines.Length);
            for (int i = 0; i < _count; i++)
                Learn(Place(i), 1);
            _sights.SetOld(personId, old);
        }

        /// <summary>Weighs all shots again. Returns the logarithm of their likelihood, of each as all others tell.</summary>
        private double Reweigh()
        {
            double sum = 0;
            for (int i = 0; i < _count; i++)
            {
                Unlearn(Place(i));
                sum += Math.Log(Weigh(Place(i)));
            }

            return sum;
        }

        /// <summary>Forgets somebody's line and learns it from the newest shot back.</summary>
        private void LearnAnew(int personId)
        {
            for (int i = 0; i < _count * LinesEach; i++)
            {
                ref Line line = ref _lines[Place(i / LinesEach) * LinesEach + i % LinesEach];
                if (i % LinesEach >= _shots[Place(i / LinesEach)].Lines || line.PersonId != personId)
                    continue;
                _sights.Add(personId, line.Evidence, -1);
                line.Evidence = default;
            }

            _sights.SetOld(personId, default);
            for (int i = _count - 1; i >= 0; i--)
            {
                Unlearn(Place(i));
                Weigh(Place(i));
            }
        }

        /// <summary>Weighs some shots again, those first whose hands are known better by now, after one line of those in doubt.</summary>
        public void Refresh(HandHistory history, long nowUs)
        {
            if (_doubtedCount > 0)
                TryAnew(_doubted[--_doubtedCount]);
            _gatheredUs = null;
            for (int i = Math.Max(0, _count - Newest); i < _count; i++)
            {
                int at = Place(i);
                if (_shots[at].IsRipe || nowUs < _shots[at].TimeUs)
                    continue;
                Unlearn(at);
                Ripen(at, history);
                Weigh(at);
            }

            for (int i = 0; i < Math.Min(EachFrame, _count); i++)
            {
                if (_next >= _count)
                    _next = 0;
                int at = Place(_next++);
                Unlearn(at);
                Weigh(at);
            }
        }

        private int Place(int logical) => (_start + logical) % Capacity;

        private void Forget()
        {
            int at = _start;
            Unlearn(at);
            for (int i = 0; i < _shots[at].Lines; i++)
            {
                ref readonly Line line = ref _lines[at * LinesEach + i];
                _sights.Settle(line.PersonId, line.Evidence, line.Share);
            }

            _start = Place(1);
            _count--;
            _next = Math.Max(0, _next - 1);
        }

        private void Unlearn(int at) => Learn(at, -1);

        private void Learn(int at, double share)
        {
            for (int i = 0; i < _shots[at].Lines; i++)
                _sights.Add(_lines[at * LinesEach + i].PersonId, _lines[at * LinesEach + i].Evidence, share);
        }

        /// <summary>The hands at the moment of the shot, now that camera 1 has seen them before and after it.</summary>
        private void Ripen(int at, HandHistory history)
        {
            ref Remembered shot = ref _shots[at];
            shot.IsRipe = true;
            if (shot.TimeUs != _gatheredUs)
                _gatheredCount = history.At(shot.TimeUs, GapUs, GapUs, _gathered);
            _gatheredUs = shot.TimeUs;
            int found = _gatheredCount;
            Array.Copy(_gathered, _hands, found);
            for (int i = 0; i < shot.Lines; i++)
            {
                ref Line line = ref _lines[at * LinesEach + i];
                for (int k = 0; k < found; k++)
                {
                    if (_hands[k].Hand.TrackId != line.TrackId || !_hands[k].IsInterpolated)
                        continue;
                    SteadyMuzzle.TryFind(history, shot.TimeUs, ref _hands[k]);
                    line.MuzzleM = _camera.ToScreenM(_hands[k].Hand.MuzzleMm);
                    line.MuzzleSigmaM = SigmaM(_hands[k].Hand.MuzzleSigmaMm * Axes.MetresPerMillimetre, line.IsSwing);
                }
            }
        }

        /// <summary>Who fired, as far as all other shots tell, and what that tells of their lines. Returns how likely the shot is so, 1 when it was weighed first.</summary>
        private double Weigh(int at)
        {
            ref readonly Remembered shot = ref _shots[at];
            Span<double> weights = stackalloc double[LinesEach], cores = stackalloc double[LinesEach];
            double sum = shot.Others;
            for (int i = 0; i < shot.Lines; i++)
            {
                ref readonly Line line = ref _lines[at * LinesEach + i];
                weights[i] = line.Rest;
                if (line.Factor > 0 && TryDensity(line, shot.DotM, out double density, out cores[i]))
                    weights[i] += line.Factor * density;
                sum += weights[i];
            }

            for (int i = 0; i < shot.Lines; i++)
            {
                ref Line line = ref _lines[at * LinesEach + i];
                line.Evidence = default;
                line.Share = weights[i] / sum;
                if (!(line.Share >= _settings.LearnProbability) || !(line.Factor > 0) || !_sights.TryEyes(line.PersonId, out Vector3D eyes))
                    continue;
                double still = 1 / (1 + (eyes - line.EyeM).LengthSquared / (MovedM * MovedM));
                line.Share *= line.Factor * cores[i] / weights[i] * still;
                line.Evidence = _sights.Weigh(line.PersonId, line.MuzzleM, line.MuzzleSigmaM, shot.DotM - line.MuzzleM, line.Share);
                if (line.IsSwing)
                    line.Evidence.SpreadSum = line.Evidence.SpreadCount = 0;
                _sights.Add(line.PersonId, line.Evidence, 1);
            }

            return sum;
        }

        private static double SigmaM(double seenM, bool isSwing) => isSwing ? Math.Sqrt(seenM * seenM + SwingSigmaM * SwingSigmaM) : seenM;

        private bool TryDensity(in Line line, Vector3D dotM, out double density, out double core)
        {
            density = core = 0;
            Vector3D v = dotM - line.MuzzleM;
            double lever = line.MuzzleSigmaM / Math.Max(0.1, v.Length);
            if (!_sights.TryMatch(line.PersonId, line.MuzzleM, line.MuzzleSigmaM, v, lever * lever, out double error, out double sigma))
                return false;
            density = ShotHandPairing.SightDensity(error, sigma * sigma, _settings, out core);
            return true;
        }
    }
}
