using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Session;

namespace LaserTracking.Health
{
    /// <summary>
    /// Whether the camera was bumped or drifts. Where the screen is known its edges tell, whatever is projected; otherwise the room that
    /// is seen beside the projected picture. Either must last: things that move displace a part only, or not for long. Where no room
    /// is seen, a picture that moves on its own cannot be told from a camera that does: that is said instead.
    /// </summary>
    internal sealed class MotionCheck
    {
        /// <summary>Frames in which all of the picture is looked at once.</summary>
        private const int FramesALook = 6;

        private const long SayAgainUs = 5_000_000;

        /// <summary>A displacement that still grows is said after this time all the same.</summary>
        private const long GrowingUs = 3_000_000;

        /// <summary>Looks in a row that must agree, and looks without an answer until the picture to compare with is renewed.</summary>
        private const int LooksToAgree = 4, LooksToRenew = 10;

        /// <summary>A view that moves as a whole without coming to rest is spoken of after this time.</summary>
        private const long ContinuingUs = 1_600_000;

        private const double StableBins = 0.3, RestingShare = 0.1;

        /// <summary>Standard deviations below which a displacement is none, and within which two are the same.</summary>
        private const double SureSigmas = 6, SameSigmas = 3;

        /// <summary>How much of the least displacement must be added to one that was said to be said again.</summary>
        private const double AgainFactor = 2;

        private readonly PictureMonitorSettings _settings;
        private readonly RoomMotion _room = new RoomMotion();
        private readonly EdgeMotion _edges = new EdgeMotion();
        private Vector2D[] _outlinePx = Array.Empty<Vector2D>();
        private Vector2D _last;
        private Vector2D _restingAt;
        private Vector2D _said;
        private int _stable;
        private int _resting;
        private int _unanswered;
        private int _beyond;
        private int _frame;
        private bool _hasReference;
        private bool _byEdges;
        private long _sinceUs = long.MinValue;
        private long _saidUs = long.MinValue;
        private bool _saidUnclear;
        private bool _saidMoved;

        public MotionCheck(PictureMonitorSettings settings) => _settings = settings;

        /// <summary>The screen's outline in the picture; no corners: not known.</summary>
        public void SetScreen(Vector2D[] outlinePx)
        {
            _outlinePx = (Vector2D[])outlinePx.Clone();
            Reset();
        }

        public void Reset()
        {
            _hasReference = false;
            _frame = _stable = _resting = _unanswered = 0;
            _said = default;
            _sinceUs = long.MinValue;
        }

        public void Update(Image image, HealthWriter health)
        {
            if (_frame == 0 && !_hasReference)
                _byEdges = _outlinePx.Length > 2 && _edges.TryLay(_outlinePx, image.Width, image.Height);
            if (!_hasReference)
            {
                _hasReference = _byEdges ? _edges.TryRefer(image) : _room.TryRefer(image);
                return;
            }

            if (_byEdges)
                _edges.Look(image, _frame, FramesALook);
            else
                _room.Look(image, _frame, FramesALook);
            if (++_frame < FramesALook)
                return;
            _frame = 0;
            Judge(health);
        }

        private void Judge(HealthWriter health)
        {
            Vector2D shift;
            double largest = 0;
            if (!(_byEdges ? _edges.TryAgree(out shift, out largest) : _room.TryAgree(out shift)))
            {
                _stable = _resting = 0;
                if (++_unanswered >= LooksToRenew)
                    Renew(default, true);
                return;
            }

            _unanswered = 0;
            double sigma = _byEdges ? _edges.SigmaBins : 0, same = Math.Max(StableBins, SameSigmas * sigma);
            _stable = (shift - _last).Length <= same ? _stable + 1 : 0;
            _last = shift;

            // Cells see a long way less exactly than edges do a short one.
            _resting = (shift - _restingAt).Length <= Math.Max(same, _byEdges ? 0 : RestingShare * shift.Length) ? _resting + 1 : 0;
            if (_resting == 0)
                _restingAt = shift;
            long now = health.TimeUs;
            double least = Math.Max(_settings.ShiftPx * (_saidMoved ? AgainFactor : 1), SureSigmas * sigma);
            if (Math.Max(largest - _said.Length, (shift - _said).Length) < least)
            {
                _sinceUs = long.MinValue;
                _beyond = 0;
                return;
            }

            // What a moving texture does to a noisy edge does not last.
            if (++_beyond < LooksToAgree)
                _resting = Math.Min(_resting, LooksToAgree - 1);
            if (_sinceUs == long.MinValue || now < _sinceUs)
                _sinceUs = now;
            bool isCamera = _byEdges || _room.IsCamera;

            // What has come to rest is said with its whole length; what creeps on is said in time.
            bool isDue = _resting >= LooksToAgree || (isCamera ? _stable >= 1 && _beyond >= LooksToAgree && now - _sinceUs >= GrowingUs : now - _sinceUs >= ContinuingUs);
            if (!isDue)
                return;
            if (isCamera)
                SayMoved(health, shift, Math.Max(largest, shift.Length));
            else
                SayUnclear(health, shift);
        }

        private void SayMoved(HealthWriter health, Vector2D shift, double largest)
        {
            long now = health.TimeUs;
            if (_saidUs != long.MinValue && now - _saidUs < SayAgainUs && now >= _saidUs)
                return;
            _saidUs = now;
            _said = shift;
            _saidMoved = true;
            _sinceUs = long.MinValue;
            int binPx = _byEdges ? _edges.BinPx : _room.BinPx;
            string way = shift.Length > 0.5 * largest
                ? Way(shift, largest, binPx)
                : FormattableString.Invariant($"has turned, by {largest * binPx:F1} px at its corners");
            health.Say(HealthKind.CameraMoved, largest * binPx, "the camera was moved: its picture " + way + "; calibrate again");
            if (!_byEdges)
                Renew(shift, false);
        }

        /// <summary>Said once: without a screen or a room in view nobody can tell whether the camera moves or what is shown.</summary>
        private void SayUnclear(HealthWriter health, Vector2D shift)
        {
            if (!_saidUnclear)
                health.Say(HealthKind.MotionUnclear, shift.Length * _room.BinPx, "all of the picture " + Way(shift, shift.Length, _room.BinPx) + ": whether that is what is shown or the camera cannot be told without a calibrated screen; calibrate, or let the camera see the room around the picture");
            _saidUnclear = true;
            Renew(shift, false);
        }

        private static string Way(Vector2D shift, double length, int binPx) =>
            FormattableString.Invariant($"has shifted by {length * binPx:F1} px {Compass.Of(shift)} ({shift.X * binPx:+0.0;-0.0;0.0}, {shift.Y * binPx:+0.0;-0.0;0.0})");

        private void Renew(Vector2D shift, bool isContent)
        {
            _unanswered = _stable = _resting = 0;
            _said = default;
            _sinceUs = long.MinValue;
            if (_byEdges)
                _hasReference = false;
            else
                _room.Renew(shift, isContent);
        }
    }
}
