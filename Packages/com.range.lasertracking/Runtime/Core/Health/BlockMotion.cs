using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Health
{
    /// <summary>Displacement of the whole picture by twelve blocks, for a picture whose screen is not known.</summary>
    internal sealed class BlockMotion
    {
        private const double AgreeBins = 0.75, LeastAgreement = 0.6;
        private const int LeastLists = 3;

        /// <summary>What rests while most of the picture moves by more than this stands outside of a picture that changes.</summary>
        private const double RestBins = 0.25, MovesBins = 0.6, LeastResting = 0.15;
        private const int LeastRestingLists = 2;

        private readonly double[][] _shifts = { new double[ShiftProfiles.Blocks], new double[ShiftProfiles.Blocks] };
        private readonly double[] _sorted = new double[ShiftProfiles.Blocks];
        private readonly int[] _counts = new int[2];
        private ShiftProfiles _reference = new ShiftProfiles();
        private ShiftProfiles _now = new ShiftProfiles();

        public int BinPx => _now.BinPx;

        /// <summary>Along one axis the blocks of the last look moved by different amounts: what it says of that axis, nought, is not known.</summary>
        public bool IsDisputed { get; private set; }

        /// <summary>Reads this frame's share of the blocks; false when the picture is too small.</summary>
        public bool Look(Image image, int frame, int frames, bool hasReference)
        {
            if (frame == 0)
                _counts[0] = _counts[1] = 0;
            for (int block = frame * ShiftProfiles.Blocks / frames; block < (frame + 1) * ShiftProfiles.Blocks / frames; block++)
            {
                if (!_now.TryFill(image, block))
                    return false;
                for (int axis = 0; axis < 2 && hasReference; axis++)
                {
                    if (_now.TryMatch(_reference, 2 * block + axis, out double found))
                        _shifts[axis][_counts[axis]++] = found;
                }
            }

            return true;
        }

        /// <summary>What most blocks of the last look say, bins.</summary>
        public bool TryAgree(out Vector2D shift, out double largest)
        {
            bool isX = TryAgree(0, out double x), isY = TryAgree(1, out double y);
            shift = new Vector2D(isX ? x : 0, isY ? y : 0);
            largest = shift.Length;
            IsDisputed = (!isX && _counts[0] >= LeastLists) || (!isY && _counts[1] >= LeastLists);
            return isX || isY;
        }

        /// <summary>The last look is what to compare with from now on.</summary>
        public void Renew() => (_reference, _now) = (_now, _reference);

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

            if (agreed < LeastLists || agreed < LeastAgreement * count)
                return false;
            if (Math.Abs(shift) < MovesBins)
                return true;

            // A camera takes everything with it. What stays behind is the room around a moving picture: the camera rests.
            int resting = 0;
            for (int i = 0; i < count; i++)
                resting += Math.Abs(shifts[i]) <= RestBins ? 1 : 0;
            if (resting >= LeastRestingLists && resting >= LeastResting * count)
                shift = 0;
            return true;
        }
    }
}
