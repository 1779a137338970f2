using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Tracking;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// Gives shots to people, or to hands whose person is unknown. Shots of one frame are assigned together at minimal total cost
    /// −log(likelihood × prior), each to one of them or to nobody; the probability is a softmax over the same hypotheses, less what other shots of the frame already claim.
    /// Stateful, bounded, without allocation, deterministic; one thread at a time.
    /// </summary>
    public sealed class ShooterAssignment
    {
        /// <summary>Whose line of sight passes farther from the dot is no rival by an error of that line.</summary>
        private const double RivalRad = 0.2;

        private readonly HandCamera _camera;
        private readonly FusionSettings _settings;
        private readonly ShotHypotheses _hypotheses;
        private readonly ShooterRegistry _registry;
        private readonly HungarianAssignment _hungarian;
        private readonly int[] _shooters;
        private readonly double[] _nobody;
        private readonly double[] _cost;
        private readonly double[] _probability;
        private readonly PairedHand[] _published;
        private readonly int[] _chosen;

        /// <param name="camera">Camera 1: its place relative to the screen.</param>
        /// <param name="settings">Null: the defaults. Read at construction and while running; do not change it.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public ShooterAssignment(HandCamera camera, FusionSettings? settings = null)
        {
            _camera = camera;
            _settings = settings ?? new FusionSettings();
            _settings.Validate();
            int shots = _settings.MaxShots, hands = _settings.MaxHands;
            _hypotheses = new ShotHypotheses(camera, _settings);
            _registry = new ShooterRegistry(_settings);
            _hungarian = new HungarianAssignment(hands + shots);
            _shooters = new int[shots * hands];
            _probability = new double[shots * hands];
            _nobody = new double[shots];
            _cost = new double[shots * (hands + shots)];
            _published = new PairedHand[hands];
            _chosen = new int[shots];
        }

        /// <summary>
        /// Camera 1's clock minus camera 0's as the shots have told so far, microseconds; frames are taken as that much earlier.
        /// Positive: they are stamped late.
        /// </summary>
        public long HandClockOffsetUs => _hypotheses.Clock.OffsetUs;

        /// <summary>Standard deviation of the last step of that; 0 while nothing has told.</summary>
        public long HandClockSigmaUs => _hypotheses.Clock.SigmaUs;

        /// <summary>Notes one frame of camera 1, its time on camera 0's clock. Frames may come before or after the shots they belong to.</summary>
        public void AddHands(HandObservations hands)
        {
            _hypotheses.Add(hands);
            foreach (ref readonly HandObservation hand in hands.Hands)
                _registry.See(ShotHypotheses.KeyOf(hand), _camera.ToScreenM(hand.MuzzleMm), hands.TimeUs - HandClockOffsetUs);
        }

        /// <summary>One shot that is alone in its frame.</summary>
        public FusedShot Fuse(in Shot shot, Vector2D screenM)
        {
            Span<FusedShot> fused = stackalloc FusedShot[1];
            ReadOnlySpan<Vector2D> places = stackalloc Vector2D[1] { screenM };
            Span<Shot> shots = stackalloc Shot[1];
            shots[0] = shot;
            Fuse(shots, places, fused);
            return fused[0];
        }

        /// <summary>The shots of one frame together; those beyond <see cref="FusionSettings.MaxShots"/> stay unknown.</summary>
        /// <param name="shots">Any number.</param>
        /// <param name="screenM">Where each lies on the screen.</param>
        /// <param name="fused">As long as the shots.</param>
        public void Fuse(ReadOnlySpan<Shot> shots, ReadOnlySpan<Vector2D> screenM, Span<FusedShot> fused)
        {
            if (screenM.Length < shots.Length || fused.Length < shots.Length)
                throw new ArgumentException("each shot needs a place on the screen and room for its result");
            fused.Slice(0, shots.Length).Clear();
            int count = Math.Min(shots.Length, _settings.MaxShots);
            if (_settings.Mode == FusionMode.Published)
            {
                for (int i = 0; i < count; i++)
                    fused[i] = FusePublished(shots[i], screenM[i]);
                return;
            }

            _hypotheses.Begin();
            for (int i = 0; i < count; i++)
                _hypotheses.Collect(shots[i]);
            for (int i = 0; i < count; i++)
                Weigh(i, shots[i], screenM[i]);
            Assign(count, _hypotheses.Columns);
            for (int i = 0; i < count; i++)
                fused[i] = Decide(i, shots[i], _hypotheses.Columns);
            for (int i = 0; i < count; i++)
            {
                var probabilities = new ReadOnlySpan<double>(_probability, i * _settings.MaxHands, _hypotheses.Columns);
                _hypotheses.NoteTime(shots[i], screenM[i]);
                _hypotheses.Learn(i, shots[i], screenM[i], probabilities);
            }
        }

        public void Reset()
        {
            _hypotheses.Clear();
            _registry.Clear();
        }

        private FusedShot FusePublished(in Shot shot, Vector2D screenM)
        {
            Span<PairedHand> hands = _published;
            int count = _hypotheses.History.At(shot.TimeUs, _settings.WindowUs, 0, hands);
            int nearest = -1;
            for (int i = 0; i < count; i++)
            {
                if (nearest < 0 || Math.Abs(hands[i].DeltaUs) < Math.Abs(hands[nearest].DeltaUs))
                    nearest = i;
            }

            if (nearest < 0 || !ShotHandPairing.TryPair(hands[nearest], screenM, _camera, _settings, out FusedShot fused))
                return default;
            fused.Shooter = 1;
            fused.ShooterProbability = 1;
            return fused;
        }

        private void Weigh(int i, in Shot shot, Vector2D screenM)
        {
            _hypotheses.Weigh(i, shot, screenM);
            int row = i * _settings.MaxHands;
            ReadOnlySpan<int> keys = _hypotheses.Keys;
            for (int k = 0; k < keys.Length; k++)
            {
                bool hasEyes = _hypotheses.TryEyes(keys[k], out Vector3D eyes);
                _shooters[row + k] = _registry.Find(keys[k], hasEyes ? eyes : (Vector3D?)null, _hypotheses.Pairs[row + k], shot.TimeUs, keys);
                if (!hasEyes)
                    _hypotheses.Weights[row + k] *= _registry.ColorFactor(_shooters[row + k], shot.Dot.Color);
            }

            _nobody[i] = _settings.NobodyPrior / _settings.AimedAreaM2;
        }

        private void Assign(int count, int columns)
        {
            // Behind the hands each shot has its own column for nobody.
            int width = columns + count;
            for (int i = 0; i < count; i++)
            {
                for (int k = 0; k < width; k++)
                {
                    double weight = k < columns ? _hypotheses.Weights[i * _settings.MaxHands + k] : k - columns == i ? _nobody[i] : 0;
                    _cost[i * width + k] = weight > 0 ? -Math.Log(weight) : HungarianAssignment.Forbidden;
                }
            }

            _hungarian.Solve(_cost, count, width, _chosen);
            // First each shot alone, then once more with what the others leave: one hand fires one shot a frame.
            for (int round = 0; round < 2; round++)
            {
                for (int i = 0; i < count; i++)
                    Soften(i, count, columns, round > 0);
                Array.Copy(_cost, 0, _probability, 0, count * _settings.MaxHands);
            }
        }

        /// <summary>Probabilities of one shot's hypotheses into the cost buffer, which is free by then.</summary>
        private void Soften(int i, int count, int columns, bool shared)
        {
            int row = i * _settings.MaxHands;
            double sum = _nobody[i];
            Array.Clear(_cost, row, _settings.MaxHands);
            for (int k = 0; k < columns; k++)
            {
                double weight = _hypotheses.Weights[row + k];
                for (int j = 0; shared && j < count; j++)
                {
                    if (j != i)
                        weight *= 1 - _probability[j * _settings.MaxHands + k];
                }

                _cost[row + k] = weight;
                sum += weight;
            }

            for (int k = 0; k < columns; k++)
                _cost[row + k] /= sum;
        }

        private FusedShot Decide(int i, in Shot shot, int columns)
        {
            int column = _chosen[i], row = i * _settings.MaxHands;
            if (column < 0 || column >= columns || !(_hypotheses.Weights[row + column] > 0))
                return default;
            FusedShot fused = _hypotheses.Pairs[row + column];
            int shooter = _shooters[row + column], key = _hypotheses.Keys[column];
            // Under whichever key they are seen, the shooter is the same.
            double mine = 0, rivals = 0, all = 0;
            for (int k = 0; k < columns; k++)
            {
                double part = _probability[row + k];
                all += part;
                if (k == column || (shooter != 0 && _shooters[row + k] == shooter))
                    mine += part;
                else
                    rivals += part * RivalWeight(_hypotheses.Pairs[row + k]);
            }

            double probability = _hypotheses.Clock.KnownProbability * mine / (mine + rivals + Math.Max(0, 1 - all));
            if (probability < _settings.MinProbability)
                return default;
            bool hasEyes = _hypotheses.TryEyes(key, out Vector3D eyes);
            fused.Shooter = _registry.Fired(shooter, key, hasEyes ? eyes : (Vector3D?)null, fused, shot.TimeUs, shot.Dot.Color);
            if (fused.Shooter == 0)
                return default;
            fused.ShooterProbability = Math.Min(1, probability);
            return fused;
        }

        private double RivalWeight(in FusedShot pair) =>
            !pair.HasMuzzle && _hypotheses.HasPicture ? _settings.HiddenRivalWeight : pair.HasMuzzle && pair.SightErrorRad < RivalRad ? _settings.RivalWeight : 1;
    }
}
