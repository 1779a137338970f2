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
        /// <summary>Blocks looked at in a frame: a look at the whole picture takes six frames.</summary>
        private const int BlocksAFrame = 2;

        private const long SayAgainUs = 5_000_000;

        /// <summary>Looks in a row that must agree, and looks without an answer until the picture to compare with is renewed.</summary>
        private const int LooksToAgree = 4, LooksToRenew = 10;

        private const double AgreeBins = 0.75, StableBins = 0.3, LeastAgreement = 0.6;
        private const int LeastLists = 3;

        private readonly PictureMonitorSettings _settings;
        private readonly double[][] _shifts = { new double[ShiftProfiles.Blocks], new double[ShiftProfiles.Blocks] };
        private readonly double[] _sorted = new double[ShiftProfiles.Blocks];
        private readonly int[] _counts = new int[2];
        private ShiftProfiles _reference = new ShiftProfiles();
        private ShiftProfiles _now = new ShiftProfiles();
        private Vector2D _last;
        private int _agreed;
        private int _unanswered;
        private int _block;
        private bool _hasReference;
        private long _saidUs = long.MinValue;

        public MotionCheck(PictureMonitorSettings settings) => _settings = settings;

        public void Reset()
        {
            _hasReference = false;
            _block = _agreed = _unanswered = _counts[0] = _counts[1] = 0;
        }

        public void Update(Image image, HealthWriter health)
        {
            for (int i = 0; i < BlocksAFrame; i++, _block++)
            {
                if (!_now.TryFill(image, _block))
                    return;
                if (_hasReference)
                    Match(2 * _block);
            }

            if (_block < ShiftProfiles.Blocks)
                return;
            _block = 0;
            if (_hasReference)
                Judge(health);
            else
                Renew();
            _hasReference = true;
            _counts[0] = _counts[1] = 0;
        }

        private void Match(int list)
        {
            for (int axis = 0; axis < 2; axis++)
            {
                if (_now.TryMatch(_reference, list + axis, out double found))
                    _shifts[axis][_counts[axis]++] = found;
            }
        }

        private void Judge(HealthWriter health)
        {
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
            long now = health.TimeUs;
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
            int count = _counts[axis];
            double[] shifts = _shifts[axis];
            shift = 0;
            if (count < LeastLists)
                return false;
            Array.Copy(shifts, _sorted, count);
            Array.Sort(_sorted, 0, count);
            double middle = _sorted[count / 2];
            int agreed = 0;
            for (int i = 0; i < count; i++)
            {
                if (Math.Abs(shifts[i] - middle) > AgreeBins)
                    continue;
                agreed++;
                shift += (shifts[i] - shift) / agreed;
            }

            return agreed >= LeastLists && agreed >= LeastAgreement * count;
        }
    }
}
