using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Tracking;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// Gives shots to hands. Shots of one frame are assigned together at minimal total cost −log(likelihood × prior), each to one
    /// hand or to nobody; the probability is a softmax over the same hypotheses, less what other shots of the frame already claim.
    /// Stateful, bounded, without allocation, deterministic; one thread at a time.
    /// </summary>
    public sealed class ShooterAssignment
    {
        private readonly HandCamera _camera;
        private readonly FusionSettings _settings;
        private readonly HandHistory _history;
        private readonly ShooterRegistry _registry;
        private readonly HungarianAssignment _hungarian;
        private readonly PairedHand[] _hands;
        private readonly int[] _handCount;
        private readonly FusedShot[] _pairs;
        private readonly int[] _shooters;
        private readonly double[] _weights;
        private readonly double[] _nobody;
        private readonly double[] _cost;
        private readonly double[] _probability;
        private readonly int[] _ids;
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
            _history = new HandHistory(_settings.HistoryLength);
            _registry = new ShooterRegistry(_settings);
            _hungarian = new HungarianAssignment(hands + shots);
            _hands = new PairedHand[shots * hands];
            _handCount = new int[shots];
            _pairs = new FusedShot[shots * hands];
            _shooters = new int[shots * hands];
            _weights = new double[shots * hands];
            _probability = new double[shots * hands];
            _nobody = new double[shots];
            _cost = new double[shots * (hands + shots)];
            _ids = new int[hands];
            _chosen = new int[shots];
        }

        /// <summary>Notes one frame of camera 1, its time on camera 0's clock. Frames may come before or after the shots they belong to.</summary>
        public void AddHands(HandObservations hands)
        {
            _history.Add(hands);
            foreach (ref readonly HandObservation hand in hands.Hands)
                _registry.See(hand.TrackId, _camera.ToScreenM(hand.MuzzleMm), hands.TimeUs);
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

            int columns = CollectHands(shots.Slice(0, count));
            for (int i = 0; i < count; i++)
                Weigh(i, shots[i], screenM[i], columns);
            Assign(count, columns);
            for (int i = 0; i < count; i++)
                fused[i] = Decide(i, shots[i], columns);
        }

        public void Reset()
        {
            _history.Clear();
            _registry.Clear();
        }

        private FusedShot FusePublished(in Shot shot, Vector2D screenM)
        {
            Span<PairedHand> hands = _hands;
            int count = _history.At(shot.TimeUs, _settings.WindowUs, 0, hands.Slice(0, _settings.MaxHands));
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

        /// <summary>Every hand that any of the shots can be paired with is one column.</summary>
        private int CollectHands(ReadOnlySpan<Shot> shots)
        {
            int columns = 0;
            for (int i = 0; i < shots.Length; i++)
            {
                Span<PairedHand> hands = HandsOf(i);
                _handCount[i] = _history.At(shots[i].TimeUs, _settings.WindowUs, _settings.MaxInterpolationUs, hands);
                for (int k = 0; k < _handCount[i]; k++)
                {
                    int id = hands[k].Hand.TrackId;
                    if (columns < _ids.Length && Array.IndexOf(_ids, id, 0, columns) < 0)
                        _ids[columns++] = id;
                }
            }

            return columns;
        }

        private Span<PairedHand> HandsOf(int shot) => new Span<PairedHand>(_hands, shot * _settings.MaxHands, _settings.MaxHands);

        private void Weigh(int i, in Shot shot, Vector2D screenM, int columns)
        {
            int row = i * _settings.MaxHands;
            Array.Clear(_weights, row, _settings.MaxHands);
            ReadOnlySpan<PairedHand> hands = HandsOf(i).Slice(0, _handCount[i]);
            double prior = hands.Length > 0 ? (1 - _settings.NobodyPrior) / hands.Length : 0;
            foreach (ref readonly PairedHand hand in hands)
            {
                int column = Array.IndexOf(_ids, hand.Hand.TrackId, 0, columns);
                if (column < 0 || !ShotHandPairing.TryPair(hand, screenM, _camera, _settings, out FusedShot pair))
                    continue;
                int at = row + column;
                _pairs[at] = pair;
                _shooters[at] = _registry.Find(hand.Hand.TrackId, pair.MuzzleM, shot.TimeUs, hands);
                _weights[at] = prior * ShotHandPairing.ScreenDensity(hand, pair, screenM, _settings)
                    * _registry.ColorFactor(_shooters[at], shot.Dot.Color);
            }

            _nobody[i] = _settings.NobodyPrior / _settings.ScreenAreaM2;
        }

        private void Assign(int count, int columns)
        {
            // Behind the hands each shot has its own column for nobody.
            int width = columns + count;
            for (int i = 0; i < count; i++)
            {
                for (int k = 0; k < width; k++)
                {
                    double weight = k < columns ? _weights[i * _settings.MaxHands + k] : k - columns == i ? _nobody[i] : 0;
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
                double weight = _weights[row + k];
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
            if (column < 0 || column >= columns || !(_weights[row + column] > 0))
                return default;
            FusedShot fused = _pairs[row + column];
            int shooter = _shooters[row + column];
            double probability = _probability[row + column];
            // Whichever of their hands it was, the shooter is the same.
            for (int k = 0; k < columns; k++)
            {
                if (k != column && shooter != 0 && _weights[row + k] > 0 && _shooters[row + k] == shooter)
                    probability += _probability[row + k];
            }

            if (probability < _settings.MinProbability)
                return default;
            LaserColor color = shot.Dot.Color;
            fused.Shooter = _registry.Fired(shooter, fused.HandTrackId, fused.MuzzleM, shot.TimeUs, color);
            if (fused.Shooter == 0)
                return default;
            fused.ShooterProbability = Math.Min(1, probability);
            return fused;
        }
    }
}
