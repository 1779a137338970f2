using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Tracking;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// Who may have fired the shots of one frame: every person in sight, with one of their hands or with a hand that camera 1 does
    /// not see, and every hand whose person is unknown. One column each; the likelihood of every shot under every column.
    /// </summary>
    internal sealed class ShotHypotheses
    {
        /// <summary>Learned from only when that well seen and that near in time.</summary>
        private const double MaxLearnSigmaM = 0.1;

        /// <summary>Dots that move less during an exposure do not tell the time.</summary>
        private const double MovingDotPx = 1.5;
        private const long LearnUs = 60_000;

        /// <summary>A picture farther off in time does not show where weapons are: as of <see cref="HandOwners"/>.</summary>
        private const long PictureUs = 50_000;

        /// <summary>Less likely hypotheses are not remembered.</summary>
        private const double MinRemembered = 0.01;

        private readonly HandCamera _camera;
        private readonly FusionSettings _settings;
        private readonly HandHistory _history;
        private readonly SightLines _sights;
        private readonly ShotMemory _memory;
        private readonly HandOwners _owners;
        private readonly SeenDepths _depths = new SeenDepths();
        private readonly WeaponPlace _places;
        private readonly PairedHand[] _hands;
        private readonly int[] _keys;
        private readonly double[] _weights;
        private readonly FusedShot[] _pairs;
        private readonly double[] _sightShares;
        private int _handCount;
        private SeenDepth? _depth;

        /// <summary>For when the hands were gathered last; shots of one frame share it.</summary>
        private long? _gatheredUs;
        private bool _isSharedOut;

        public ShotHypotheses(HandCamera camera, FusionSettings settings)
        {
            _camera = camera;
            _settings = settings;
            _history = new HandHistory(settings.HistoryLength);
            _sights = new SightLines(settings);
            _memory = new ShotMemory(camera, settings, _sights);
            Clock = new HandClock(camera);
            _hands = new PairedHand[settings.MaxHands];
            _keys = new int[settings.MaxHands];
            _weights = new double[settings.MaxShots * settings.MaxHands];
            _pairs = new FusedShot[_weights.Length];
            _sightShares = new double[_weights.Length];
            _owners = new HandOwners(camera, settings, _sights);
            _places = new WeaponPlace(camera, _sights);
        }

        public HandHistory History => _history;

        public HandClock Clock { get; }

        /// <summary>Whether camera 1's picture of just then is known: what it does not show is hidden, not merely long unseen.</summary>
        public bool HasPicture => _depth != null;

        public int Columns { get; private set; }

        /// <summary>Row by row, <see cref="FusionSettings.MaxHands"/> wide.</summary>
        public double[] Weights => _weights;

        public FusedShot[] Pairs => _pairs;

        /// <summary>Above zero: a person; below: minus the track of a hand whose person is unknown.</summary>
        public ReadOnlySpan<int> Keys => new ReadOnlySpan<int>(_keys, 0, Columns);

        public void Clear()
        {
            _history.Clear();
            _sights.Clear();
            _memory.Clear();
            Clock.Clear();
            _depths.Clear();
        }

        public void Add(HandObservations hands)
        {
            long timeUs = hands.TimeUs - Clock.OffsetUs;
            _history.Add(hands, timeUs);
            _depths.Add(hands);
            foreach (ref readonly PersonObservation person in hands.People)
                _sights.See(person, _camera, timeUs);
            _memory.Refresh(_history, timeUs);
            Clock.Update(timeUs, _history, _sights);
        }

        public static int KeyOf(in HandObservation hand) => hand.PersonId > 0 ? hand.PersonId : -hand.TrackId;

        /// <summary>Where the eyes of a column's person are; false when they are unknown.</summary>
        public bool TryEyes(int key, out Vector3D eyesM) => _sights.TryEyes(key, out eyesM);

        public void Begin()
        {
            Columns = 0;
            _gatheredUs = null;
            _depth = null;
        }

        /// <summary>Adds the columns that a shot needs; call for all shots of a frame before weighing any.</summary>
        public void Collect(in Shot shot)
        {
            for (int i = 0; i < _sights.Count; i++)
            {
                if (Math.Abs(_sights.SeenUsAt(i) - shot.TimeUs) <= _settings.WindowUs)
                    AddColumn(_sights.PersonAt(i));
            }

            GatherHands(shot.TimeUs);
            for (int i = 0; i < _handCount; i++)
                AddColumn(KeyOf(_hands[i].Hand));
        }

        public void Weigh(int row, in Shot shot, Vector2D screenM)
        {
            GatherHands(shot.TimeUs);
            if (!_isSharedOut)
                _owners.ShareOut(new ReadOnlySpan<PairedHand>(_hands, 0, _handCount), Keys);
            _isSharedOut = true;
            int first = row * _settings.MaxHands;
            double sum = 0;
            for (int k = 0; k < Columns; k++)
                sum += _keys[k] > 0 ? 1 : _settings.StrangerShare;
            for (int k = 0; k < Columns; k++)
            {
                double prior = (1 - _settings.NobodyPrior) * (_keys[k] > 0 ? 1 : _settings.StrangerShare) / sum;
                _weights[first + k] = prior * Likelihood(k, screenM, out _pairs[first + k], out _sightShares[first + k]) * _sights.ColorFactor(_keys[k], shot.Dot.Color);
            }
        }

        /// <summary>Notes with which probabilities a shot is the columns'.</summary>
        public void Learn(int row, in Shot shot, Vector2D screenM, ReadOnlySpan<double> probabilities)
        {
            _memory.Begin(shot.TimeUs, screenM);
            for (int k = 0; k < Columns; k++)
            {
                if (_keys[k] < 0 || probabilities[k] < MinRemembered)
                    continue;
                ref readonly FusedShot pair = ref _pairs[row * _settings.MaxHands + k];
                bool isSwing = IsMoving(shot), isClear = pair.HasMuzzle && Math.Abs(pair.PairDeltaUs) <= LearnUs && pair.MuzzleSigmaM < MaxLearnSigmaM;
                _memory.Add(_keys[k], pair, probabilities[k], isClear ? _sightShares[row * _settings.MaxHands + k] : 0, isSwing);
                if (probabilities[k] < _settings.LearnProbability)
                    continue;
                _sights.CountColor(_keys[k], shot.Dot.Color, probabilities[k]);
                if (isClear && !isSwing)
                    _sights.NoteReach(_keys[k], pair.MuzzleM, probabilities[k]);
            }

            _memory.End();
        }

        /// <summary>Notes a shot for camera 1's clock, whoever fired: with a clock that is off nobody's line meets it well enough to be named.</summary>
        public void NoteTime(in Shot shot, Vector2D screenM)
        {
            Clock.NoteLine();
            if (IsMoving(shot))
                Clock.Note(shot.TimeUs, shot.TimeSigmaUs, new Vector3D(screenM.X, screenM.Y, 0));
        }

        /// <summary>Fired from a swing: tells the time, and of the line less than what the time is off.</summary>
        private static bool IsMoving(in Shot shot) => shot.Dot.StreakPx.LengthSquared >= MovingDotPx * MovingDotPx;

        private void GatherHands(long timeUs)
        {
            if (timeUs == _gatheredUs)
                return;
            _gatheredUs = timeUs;
            _isSharedOut = false;
            _handCount = _history.At(timeUs, _settings.WindowUs, _settings.MaxInterpolationUs, _hands);
            for (int i = 0; i < _handCount; i++)
                CarryOn(ref _hands[i], timeUs);
            _depth = _depths.At(timeUs + Clock.OffsetUs, PictureUs);
        }

        private void AddColumn(int key)
        {
            if (Columns == _keys.Length || Array.IndexOf(_keys, key, 0, Columns) >= 0)
                return;
            _keys[Columns++] = key;
            _isSharedOut = false;
        }

        /// <summary>Density of this dot, per m² of the screen, if it is this column's; the pair is that of their likeliest hand.</summary>
        private double Likelihood(int column, Vector2D screenM, out FusedShot best, out double sightShare)
        {
            int key = _keys[column];
            best = default;
            sightShare = 0;
            double sum = 0, highest = 0, shares = 0;
            double place = key > 0 && _depth != null ? _places.Factor(key, new Vector3D(screenM.X, screenM.Y, 0), _depth) : 1;
            for (int i = 0; i < _handCount; i++)
            {
                double share = _owners.Share(column, i);
                if (!(share > 0))
                    continue;
                shares += share;
                PairedHand hand = _hands[i];
                if (!ShotHandPairing.TryPair(hand, screenM, _camera, _settings, out FusedShot pair))
                    continue;
                Match(key, screenM, ref hand, ref pair);
                double bearing = _owners.BearingFit(hand.Hand, pair.Direction);
                double density = share * Turned(key, hand.Hand, pair, bearing) * ShotHandPairing.ScreenDensity(hand, pair, screenM, _settings, out double bySight, bearing) * Stillness(hand, pair);

                // A hand at that place fills it itself: it speaks for its owner once.
                if (!_owners.IsWeaponSeen(i))
                    density *= Math.Min(1, place);
                sum += density;
                if (density <= highest)
                    continue;
                highest = density;
                best = pair;
                sightShare = bySight;
            }

            double seen = shares > 0 ? sum / Math.Max(1, shares) : 0;
            if (key < 0)
                return seen;
            double hidden = HiddenShare(key, screenM, _owners.Visible(column));
            double unseen = hidden * place / _settings.AimedAreaM2;
            double total = (1 - hidden) * seen + unseen;
            sightShare *= (1 - hidden) * highest / Math.Max(1, shares) / total;
            if (unseen > (1 - hidden) * highest)
                best = default;
            return total;
        }

        /// <summary>
        /// How much less a weapon's own picture agrees with the dot than with the line over which it is aimed, 0…1. Of somebody whose eyes are hidden that
        /// line is known to 0.2 rad, and the picture tells as much.
        /// </summary>
        private double Turned(int key, in HandObservation hand, in FusedShot pair, double bearing)
        {
            // 1: agrees, or its weapon is not seen.
            if (key < 0 || bearing >= 1 || !_sights.TryReach(key, out Vector3D pivot, out _, out _))
                return 1;
            return Math.Min(1, bearing / _owners.BearingFit(hand, pair.MuzzleM - pivot));
        }

        /// <summary>How much likelier this hand's motion is of somebody who fires than of somebody who does not: most hold still for it.</summary>
        private double Stillness(in PairedHand hand, in FusedShot pair)
        {
            if (!(hand.VelocitySeconds > 0))
                return 1;
            Vector3D velocity = _camera.PoseInScreenMm.TransformDirection(hand.MuzzleVelocityMmS) * Axes.MetresPerMillimetre;
            double speed = (velocity - pair.Direction * Vector3D.Dot(velocity, pair.Direction)).Length;
            double noise = Math.Sqrt(2) * hand.Hand.MuzzleSigmaMm * Axes.MetresPerMillimetre / hand.VelocitySeconds;
            // From still to swinging over the width that the velocity's own error has.
            double swings = 1 / (1 + Math.Exp(-(speed - _settings.SwingMPerS - noise) / (0.25 * (_settings.SwingMPerS + noise))));
            return (1 - swings) * (1 - _settings.SwingShare) / (1 - _settings.IdleSwingShare) + swings * _settings.SwingShare / _settings.IdleSwingShare;
        }

        /// <summary>
        /// Probability that camera 1 does not see the hand that fires at this point: it would be before the eyes towards that point,
        /// which is in the picture or not. Whose hand is seen elsewhere has no other.
        /// </summary>
        private double HiddenShare(int personId, Vector2D screenM, double visible) =>
            visible * _settings.SecondWeaponShare + (1 - visible) * HiddenShare(personId, screenM);

        private double HiddenShare(int personId, Vector2D screenM)
        {
            if (!_sights.TryEyes(personId, out Vector3D eyes))
                return _settings.HiddenShare;
            Vector3D towards = (new Vector3D(screenM.X, screenM.Y, 0) - eyes).Normalized;
            if (!_sights.TryReach(personId, out Vector3D pivot, out double reach, out _))
                return _settings.HiddenShare;
            Vector3D hand = _camera.ToCameraMm(pivot + towards * reach);
            PinholeCamera view = _camera.Intrinsics;
            if (!view.TryProject(hand, out Vector2D px))
                return _settings.OutOfViewShare;
            double marginX = _settings.ViewMargin * view.Width, marginY = _settings.ViewMargin * view.Height;
            bool isInView = px.X > marginX && px.X < view.Width - marginX && px.Y > marginY && px.Y < view.Height - marginY;
            return isInView ? _settings.HiddenShare : _settings.OutOfViewShare;
        }

        /// <summary>Shots are reported before camera 1's next frame: a weapon that does not hold still is a little way on as it went.</summary>
        private void CarryOn(ref PairedHand hand, long timeUs)
        {
            if (Math.Abs(hand.DeltaUs) <= LearnUs && !SteadyMuzzle.TryFind(_history, timeUs, ref hand) && !hand.IsInterpolated)
                hand.Hand.MuzzleMm -= hand.MuzzleVelocityMmS * (hand.DeltaUs * 1e-6);
        }

        /// <summary>Sets the sight line of a pair to the one from where this person is known to aim over.</summary>
        private void Match(int key, Vector2D screenM, ref PairedHand hand, ref FusedShot pair)
        {
            if (key < 0)
                return;
            Vector3D v = new Vector3D(screenM.X, screenM.Y, 0) - pair.MuzzleM;
            double common = ShotHandPairing.CommonVariance(hand, pair, v.Length, _settings);
            if (!_sights.TryMatch(key, pair.MuzzleM, hand.Hand.MuzzleSigmaMm * Axes.MetresPerMillimetre, v, common, out double error, out double sigma))
                return;
            pair.SightErrorRad = error;
            hand.Hand.SightSigmaRad = Math.Sqrt(Math.Max(0, sigma * sigma - common));
        }
    }
}
