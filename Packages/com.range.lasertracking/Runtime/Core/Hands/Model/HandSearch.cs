using System;
using LaserTracking.Imaging;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// Finds one hand in a picture when nothing tells where it is: squares of falling size, each in four rotations, the best of each
    /// size followed over three crops from its own landmarks. Presence alone proves nothing, for it stays high on a hand that is
    /// turned; a hand counts when its landmarks lead back to the same region. Takes up to some hundred runs of the network.
    /// </summary>
    public sealed class HandSearch
    {
        private const int Sizes = 4;
        private const int Followed = 4;
        private const int Crops = 3;
        private const double MinSidePx = 32;
        private const double SurePresence = 0.9;

        private readonly HandLandmarkNetwork _network;
        private readonly HandLandmarks _trial = new HandLandmarks();
        private readonly HandRegion[] _regions = new HandRegion[Followed];
        private readonly double[] _presences = new double[Followed];

        public HandSearch(HandLandmarkNetwork network) => _network = network;

        /// <summary>True when a hand was found; else <paramref name="found"/> says what is seen in the picture as a whole.</summary>
        /// <param name="picture">Colour, grey or infrared.</param>
        /// <param name="found">The hand, as seen in the last crop.</param>
        /// <exception cref="ArgumentException">No such picture.</exception>
        public bool TryFind(Image picture, HandLandmarks found)
        {
            int width = picture.Width, height = picture.Height;
            double side = Math.Max(width, height), best = 0;
            _network.Run(picture, new HandRegion(width / 2.0, height / 2.0, side, 0), found);
            for (int size = 0; size < Sizes && side >= MinSidePx; size++, side = Math.Min(width, height) / (double)(1 << (size - 1)))
            {
                Array.Clear(_presences, 0, Followed);
                Scan(picture, side);
                for (int i = 0; i < Followed; i++)
                {
                    if (_presences[i] < HandLandmarkNetwork.MinPresence || !TryFollow(picture, _regions[i]) || _trial.Presence <= best)
                        continue;
                    best = _trial.Presence;
                    found.CopyFrom(_trial);
                }

                if (best >= SurePresence)
                    return true;
            }

            return best > 0;
        }

        /// <summary>Two regions show the same hand: about one place, one size, one rotation.</summary>
        public static bool IsSame(HandRegion a, HandRegion b)
        {
            double dx = a.CenterXPx - b.CenterXPx, dy = a.CenterYPx - b.CenterYPx;
            double side = Math.Min(a.SidePx, b.SidePx);
            double turn = Math.Abs(new HandRegion(0, 0, 1, a.RotationRad - b.RotationRad).RotationRad);
            return dx * dx + dy * dy < 0.0225 * side * side && Math.Max(a.SidePx, b.SidePx) < 1.25 * side && turn < 0.35;
        }

        /// <summary>Squares over the picture, half of one apart.</summary>
        private void Scan(Image picture, double side)
        {
            int columns = Positions(picture.Width, side), rows = Positions(picture.Height, side);
            for (int row = 0; row < rows; row++)
            {
                for (int column = 0; column < columns; column++)
                {
                    double x = Place(column, columns, picture.Width, side), y = Place(row, rows, picture.Height, side);
                    for (int turn = 0; turn < 4; turn++)
                    {
                        var region = new HandRegion(x, y, side, turn * Math.PI / 2);
                        _network.Run(picture, region, _trial);
                        Keep(region, _trial.Presence);
                    }
                }
            }
        }

        private static int Positions(int length, double side) => side >= length ? 1 : 1 + (int)Math.Ceiling((length - side) / (side / 2));

        private static double Place(int index, int count, int length, double side) =>
            count == 1 ? length / 2.0 : side / 2 + index * (length - side) / (count - 1);

        private void Keep(HandRegion region, double presence)
        {
            int i = Followed - 1;
            if (!(presence > _presences[i]))
                return;
            for (; i > 0 && presence > _presences[i - 1]; i--)
            {
                _presences[i] = _presences[i - 1];
                _regions[i] = _regions[i - 1];
            }

            _presences[i] = presence;
            _regions[i] = region;
        }

        private bool TryFollow(Image picture, HandRegion region)
        {
            _network.Run(picture, region, _trial);
            for (int i = 0; i < Crops; i++)
            {
                if (!_trial.NextRegion.IsValid)
                    return false;
                _network.Run(picture, _trial.NextRegion, _trial);
                if (_trial.Presence < HandLandmarkNetwork.MinPresence)
                    return false;
            }

            return _trial.NextRegion.IsValid && IsSame(_trial.Region, _trial.NextRegion);
        }
    }
}
