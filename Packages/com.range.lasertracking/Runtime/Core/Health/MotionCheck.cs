using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Session;

namespace LaserTracking.Health
{
    /// <summary>
    /// Whether the camera was bumped: most blocks of the picture that have something to see are displaced by the same amount, and stay
    /// so. Things that move displace a few blocks, or not for long.
    /// </summary>
    internal sealed class MotionCheck
    {
        private const long CheckUs = 250_000;
        private const long SayAgainUs = 5_000_000;

        /// <summary>Looks in a row that must agree, and looks without an answer until the picture to compare with is renewed.</summary>
        private const int LooksToAgree = 3, LooksToRenew = 8;

        private const double AgreeBins = 0.75, StableBins = 0.3, LeastAgreement = 0.6;
        private const int LeastLists = 3;

        private readonly PictureMonitorSettings _settings;
        private readonly double[] _shifts = new double[ShiftProfiles.Lists / 2];
        private readonly double[] _sorted = new double[ShiftProfiles.Lists / 2];
        private ShiftProfiles _reference = new ShiftProfiles();
        private ShiftProfiles _now = new ShiftProfiles();
        private Vector2D _last;
        private int _agreed;
        private int _unanswered;
        private long _checkedUs;
        private long _saidUs = long.MinValue;

        public MotionCheck(PictureMonitorSettings settings) => _settings = settings;

        public void Reset() => _reference.Clear();

        public void Update(Image image, HealthWriter health)
        {
            long now = health.TimeUs;
            if (_reference.IsFilled && now - _checkedUs < CheckUs && now >= _checkedUs)
                return;
            _checkedUs = now;
            if (!_now.TryFill(image))
                return;
            if (!_reference.IsFilled)
            {
                Renew();
                return;
            }

            bool isX = TryAgree(0, out double x), isY = TryAgree(1, out double y);
            if (!isX && !isY)
            {
                _agreed = 0;
                if (++_unanswered >= LooksToRenew)
                    Renew();
                return;
            }

            _unanswered = 0;
            var shift = new Vector2D(isX ? x : 0, isY ? y : 0);
            bool isStable = shift.Length >= _settings.ShiftPx && (_agreed == 0 || (shift - _last).Length <= StableBins);
            _agreed = isStable ? _agreed + 1 : 0;
            _last = shift;
            if (_agreed < LooksToAgree || (_saidUs != long.MinValue && now - _saidUs < SayAgainUs && now >= _saidUs))
                return;
            _saidUs = now;
            double px = shift.Length * _now.BinPx;
            health.Say(HealthKind.CameraMoved, px, FormattableString.Invariant($"the camera was moved: its picture has shifted by {px:F1} px; calibrate again"));
            Renew();
        }

        private void Renew()
        {
            (_reference, _now) = (_now, _reference);
            _agreed = _unanswered = 0;
        }

        private bool TryAgree(int axis, out double shift)
        {
            int count = 0;
            for (int list = axis; list < ShiftProfiles.Lists; list += 2)
            {
                if (_now.TryMatch(_reference, list, out double found))
                    _shifts[count++] = found;
            }

            shift = 0;
            if (count < LeastLists)
                return false;
            Array.Copy(_shifts, _sorted, count);
            Array.Sort(_sorted, 0, count);
            double middle = _sorted[count / 2];
            int agreed = 0;
            for (int i = 0; i < count; i++)
            {
                if (Math.Abs(_shifts[i] - middle) > AgreeBins)
                    continue;
                agreed++;
                shift += (_shifts[i] - shift) / agreed;
            }

            return agreed >= LeastLists && agreed >= LeastAgreement * count;
        }
    }
}
