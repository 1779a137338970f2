using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The share of the screen in which an ordinary dot, which rises to full brightness, would not be taken: because the background
    /// is that bright already, or because so much moves there that the tile's own threshold lies above it.
    /// </summary>
    internal sealed unsafe class BlindMeter
    {
        private readonly ShotDetectorSettings _settings;
        private bool[] _isOnScreen = System.Array.Empty<bool>();
        private int _onScreen;
        private int _maskVersion = -1;

        public BlindMeter(ShotDetectorSettings settings) => _settings = settings;

        /// <summary>The picture has another size.</summary>
        public void Resize() => _maskVersion = -1;

        /// <param name="view">The frame.</param>
        /// <param name="tiles">Those of the smallest channel.</param>
        /// <param name="mask">The screen.</param>
        /// <param name="factor">Source pixels per working pixel.</param>
        /// <param name="noise">Temporal noise, levels.</param>
        /// <param name="isContentKnown">Light above the projected picture is found whatever moves there.</param>
        /// <param name="detections">Receives the shares.</param>
        public void Measure(in FrameView view, TileGrid tiles, ScreenMask mask, int factor, double noise, bool isContentKnown, Detections detections)
        {
            if (_maskVersion != mask.Version)
                FindScreen(tiles, mask, factor);
            double atRest = DotRoom.LeastRiseLevels(_settings, noise);
            int saturated = 0, busy = 0;
            for (int row = 0, tile = 0; row < tiles.Rows; row++)
            {
                for (int column = 0; column < tiles.Columns; column++, tile++)
                {
                    if (!_isOnScreen[tile])
                        continue;
                    int room = 255 - Level(view, column, row);
                    if (room < atRest)
                        saturated++;
                    else if (!isContentKnown && room < DotRoom.LeastOnsetLevels(tiles.Activity(tile)))
                        busy++;
                }
            }

            detections.SaturatedShare = _onScreen == 0 ? 0 : saturated / (double)_onScreen;
            detections.BlindShare = _onScreen == 0 ? 0 : (saturated + busy) / (double)_onScreen;
        }

        /// <summary>The tile's brightness: the mean of four of its pixels.</summary>
        private static int Level(in FrameView view, int column, int row)
        {
            int left = System.Math.Min(view.Width - 1, column * TileGrid.Size + 4), right = System.Math.Min(view.Width - 1, column * TileGrid.Size + 12);
            byte* upper = view.OldSmallest + System.Math.Min(view.Height - 1, row * TileGrid.Size + 4) * view.Width;
            byte* lower = view.OldSmallest + System.Math.Min(view.Height - 1, row * TileGrid.Size + 12) * view.Width;
            return (upper[left] + upper[right] + lower[left] + lower[right] + 2) / 4;
        }

        private void FindScreen(TileGrid tiles, ScreenMask mask, int factor)
        {
            _maskVersion = mask.Version;
            _onScreen = 0;
            _isOnScreen = new bool[tiles.Columns * tiles.Rows];
            for (int tile = 0; tile < _isOnScreen.Length; tile++)
            {
                var middle = new Vector2D((tile % tiles.Columns + 0.5) * TileGrid.Size * factor, (tile / tiles.Columns + 0.5) * TileGrid.Size * factor);
                _isOnScreen[tile] = mask.SignedDistancePx(middle) <= 0;
                if (_isOnScreen[tile])
                    _onScreen++;
            }
        }
    }
}
