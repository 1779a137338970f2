using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Session;

namespace LaserTracking.Health
{
    /// <summary>
    /// Whether the camera was bumped or drifts. Where the screen is known its edges tell, whatever is projected; otherwise most blocks of
    /// the picture that have something to see must be displaced by the same amount, at once and for good. Either must last: things that
    /// move displace a part only, or not for long. A picture that fills the view and moves on its own cannot be told from a camera that
    /// does: that is said instead.
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

        /// <summary>After the whole view was seen to move on its own, a step is trusted again when it has rested for so long.</summary>
        private const long ContentUs = 10_000_000;

        private const double StableBins = 0.3, RestingShare = 0.1;

        /// <summary>How much of the least displacement must be added to one that was said to be said again.</summary>
        private const double AgainFactor = 2;

        private readonly PictureMonitorSettings _settings;
        private readonly BlockMotion _blocks = new BlockMotion();
        private readonly EdgeMotion _edges = new EdgeMotion();
        private readonly StepEvidence _evidence = new StepEvidence();
        private Vector2D[] _outlinePx = Array.Empty<Vector2D>();
        private Vector2D _last;
        private Vector2D _restingAt;
        private Vector2D _said;
        private int _stable;
        private int _resting;
        private int _unanswered;
        private int _frame;
        private bool _hasReference;
        private bool _byEdges;
        private long _sinceUs = long.MinValue;
        private long _saidUs = long.MinValue;
        private long _contentUs = long.MinValue;
        private bool _saidUnclear;

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
            _sinceUs = _contentUs = long.MinValue;
            _evidence.Reset();
        }

        public void Update(Image image, HealthWriter health)
        {
            if (_frame == 0 && !_hasReference)
                _byEdges = _outlinePx.Length > 2 && _edges.TryLay(_outlinePx, image.Width, image.Height);
            if (!(_byEdges ? _edges.Look(image, _frame, FramesALook, !_hasReference) : _blocks.Look(image, _frame, FramesALook, _hasReference)))
                return;
            if (++_frame < FramesALook)
                return;
            _frame = 0;
            if (_hasReference)
                Judge(health);
            else if (!_byEdges)
                _blocks.Renew();
            _hasReference = true;
        }

        private void Judge(HealthWriter health)
        {
            Vector2D shift;
            double largest;
            if (!(_byEdges ? _edges.TryAgree(out shift, out largest) : _blocks.TryAgree(out shift, out largest)))
            {
                _stable = _resting = 0;
                if (++_unanswered >= LooksToRenew)
                    Renew();
                return;
            }

            _unanswered = 0;
            _stable = (shift - _last).Length <= StableBins ? _stable + 1 : 0;
            _last = shift;

            // Blocks see a long way less exactly: what lies askew in them moves along the other axis, too.
            _resting = (shift - _restingAt).Length <= Math.Max(StableBins, _byEdges ? 0 : RestingShare * shift.Length) ? _resting + 1 : 0;
            if (_resting == 0)
                _restingAt = shift;
            long now = health.TimeUs;

            // A look in the middle of a motion is no rest.
            if (!_byEdges && !(_blocks.IsDisputed && shift.Length < _settings.ShiftPx))
                _evidence.Add(now, shift);
            double least = _settings.ShiftPx * (_said.Equals(default) ? 1 : AgainFactor);
            if (Math.Max(largest - _said.Length, (shift - _said).Length) < least)
            {
                _sinceUs = long.MinValue;
                return;
            }

            if (_sinceUs == long.MinValue || now < _sinceUs)
                _sinceUs = now;

            // What has come to rest is said with its whole length; what creeps on is said in time.
            bool isDue = _resting >= LooksToAgree || (_byEdges ? _stable >= LooksToAgree && now - _sinceUs >= GrowingUs : _evidence.IsContinuing);
            if (isDue && !_byEdges && !IsStepOfTheCamera(health))
                return;
            if (!isDue || (_saidUs != long.MinValue && now - _saidUs < SayAgainUs && now >= _saidUs))
                return;
            _saidUs = now;
            _said = shift;
            _sinceUs = long.MinValue;
            int binPx = _byEdges ? _edges.BinPx : _blocks.BinPx;
            double px = Math.Max(largest, shift.Length) * binPx;
            string way = shift.Length > 0.5 * largest
                ? FormattableString.Invariant($"has shifted by {px:F1} px {Compass.Of(shift)} ({shift.X * binPx:+0.0;-0.0}, {shift.Y * binPx:+0.0;-0.0})")
                : FormattableString.Invariant($"has turned, by {px:F1} px at its corners");
            health.Say(HealthKind.CameraMoved, px, "the camera was moved: its picture " + way + "; calibrate again");
            if (!_byEdges)
                Renew();
        }

        /// <summary>
        /// Without a screen only a step from rest to rest is the camera's for sure. Anything else that moves the whole view may be the
        /// picture: said once, and for a while not even a step is trusted.
        /// </summary>
        private bool IsStepOfTheCamera(HealthWriter health)
        {
            long now = health.TimeUs;
            bool isContent = _contentUs != long.MinValue && now >= _contentUs && now - _contentUs < ContentUs;
            if (_evidence.IsStep && !isContent)
                return true;
            _contentUs = now;
            if (!_saidUnclear)
                health.Say(HealthKind.MotionUnclear, _last.Length * _blocks.BinPx, "all of the picture moves: whether that is what is shown or the camera cannot be told without a calibrated screen; calibrate, or let the camera see the room around the picture");
            _saidUnclear = true;
            Renew();
            return false;
        }

        private void Renew()
        {
            _evidence.Reset();
            _unanswered = _stable = _resting = 0;
            _said = default;
            _sinceUs = long.MinValue;
            if (_byEdges)
                _hasReference = false;
            else
                _blocks.Renew();
        }
    }
}
