using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Finds the projected boards in a camera's frames. Frames that show the same are averaged; the difference of two such pictures is
    /// searched for a board, since that of a board and its inverse holds nothing but the board. Neither the order nor the timing of the
    /// pictures matters, and frames of other things between them do no harm. A single picture will do where the room allows it. For
    /// set-up: allocates; one thread.
    /// </summary>
    public sealed class ScreenPatternFinder : IDisposable
    {
        /// <summary>Pictures remembered; of more the ones seen most briefly are dropped.</summary>
        private const int MostPictures = 12;

        /// <summary>From so many frames of one picture on, single frames are mixtures of two pictures.</summary>
        private const int LongPicture = 3;

        private const double WellSeenShare = 0.8;

        /// <summary>Pictures so far apart are compared, first the neighbours.</summary>
        private const int FurthestApart = 3;

        private const int SearchedPixels = 600_000, LeastSide = 120, LeastCorners = 25, MostSeeds = 40;

        private readonly List<HeldPicture> _pictures = new List<HeldPicture>();
        private readonly PictureChange _change = new PictureChange();
        private readonly SignalPicture _signal = new SignalPicture();
        private readonly SaddlePointFinder _saddles = new SaddlePointFinder();
        private readonly CornerLattice _lattice;
        private readonly ScreenBoardDecoder _decoder;
        private readonly BoardSighting?[] _best = new BoardSighting?[2];
        private int _width, _height, _frames;

        public ScreenPatternFinder()
        {
            _lattice = new CornerLattice(_saddles);
            var boards = new List<ScreenBoard>();
            for (int down = ScreenBoard.LeastCellsDown; down <= ScreenBoard.MostCellsDown; down++)
            {
                boards.Add(new ScreenBoard(down, false));
                boards.Add(new ScreenBoard(down, true));
            }

            _decoder = new ScreenBoardDecoder(boards.ToArray());
        }

        /// <summary>The next frame. All must have the size of the first, 64 pixels or more either way; any colour or grey format.</summary>
        /// <returns>False when it is left out for its size or format.</returns>
        public bool Add(Image image)
        {
            if (image.Format == PixelFormat.None || image.Format > PixelFormat.Gray8 || image.Width < 64 || image.Height < 64)
                return false;
            if (_frames == 0)
                (_width, _height) = (image.Width, image.Height);
            if (image.Width != _width || image.Height != _height)
                return false;
            bool isAnother = _change.Update(image) || _frames == 0;
            _frames++;
            if (isAnother)
                Begin(image);
            else
                _pictures[_pictures.Count - 1].Add(image);
            return true;
        }

        /// <summary>Looks for the boards in what was added. No frame may be added afterwards.</summary>
        public ScreenPatternView Find()
        {
            var shown = new List<HeldPicture>(_pictures);
            if (shown.Exists(picture => picture.Frames >= LongPicture))
                shown.RemoveAll(picture => picture.Frames == 1);
            for (int apart = 1; apart <= FurthestApart && !(IsWellSeen(0) && IsWellSeen(1)); apart++)
            {
                for (int i = 0; i + apart < shown.Count; i++)
                {
                    _signal.SetToDifference(shown[i], shown[i + apart]);
                    Keep(Search());
                }
            }

            for (int i = 0; i < shown.Count && (_best[0] == null || _best[1] == null); i++)
            {
                _signal.SetToFlattened(shown[i]);
                Keep(Search());
            }

            return new ScreenPatternView(_width, _height, _frames, shown.Count, Movement(shown), _best[0], _best[1]);
        }

        public void Dispose() => _signal.Dispose();

        /// <summary>Most of a board is there: no other pair of pictures will show more.</summary>
        private bool IsWellSeen(int board) => _best[board] is BoardSighting sighting && sighting.Measured > WellSeenShare * sighting.Points.Length;

        /// <summary>The largest displacement of a board between two of the pictures, or against where it was measured.</summary>
        private Vector2D Movement(List<HeldPicture> shown)
        {
            var places = new[] { new List<Vector2D> { default }, new List<Vector2D> { default } };
            Vector2D largest = default;
            for (int i = 0; i < shown.Count && shown.Count > 1; i++)
            {
                _signal.SetToFlattened(shown[i]);
                if (!(Search() is BoardSighting sighting))
                    continue;
                int board = sighting.Board.IsShifted ? 1 : 0;
                if (!(_best[board] is BoardSighting best) || best.Board.CellsDown != sighting.Board.CellsDown)
                    continue;
                Vector2D place = sighting.MovedFrom(best);
                foreach (Vector2D other in places[board])
                    largest = (place - other).LengthSquared > largest.LengthSquared ? place - other : largest;
                places[board].Add(place);
            }

            return largest;
        }

        private void Keep(BoardSighting? sighting)
        {
            if (sighting == null)
                return;
            ref BoardSighting? best = ref _best[sighting.Board.IsShifted ? 1 : 0];
            if (best == null || sighting.Worth > best.Worth)
                best = sighting;
        }

        private void Begin(Image image)
        {
            HeldPicture? picture = null;
            if (_pictures.Count == MostPictures)
            {
                picture = _pictures[0];
                foreach (HeldPicture other in _pictures)
                    picture = other.Frames < picture.Frames ? other : picture;
                _pictures.Remove(picture);
            }

            picture ??= new HeldPicture();
            picture.Begin(image);
            _pictures.Add(picture);
        }

        /// <summary>Looks for one board in the signal, at the resolution that makes cells neither tiny nor soft, then at its neighbours.</summary>
        private BoardSighting? Search()
        {
            int usual = 0;
            while ((long)(_width >> usual) * (_height >> usual) > SearchedPixels && usual < SignalPicture.MostLevels - 1)
                usual++;
            return Search(usual) ?? Search(usual + 1) ?? Search(usual - 1);
        }

        private BoardSighting? Search(int level)
        {
            if (level < 0 || level >= SignalPicture.MostLevels || Math.Min(_width, _height) >> level < LeastSide)
                return null;
            Image picture = _signal.Level(level);
            int count = _saddles.Find(picture).Length;
            _lattice.Use(picture.Width, picture.Height);
            var isTried = new bool[count];
            for (int seed = 0, tried = 0; seed < count && tried < MostSeeds; seed++)
            {
                if (isTried[seed])
                    continue;
                tried++;
                _lattice.Grow(seed);
                for (int i = 0; i < count; i++)
                    isTried[i] |= _lattice.Contains(i);
                if (_lattice.Count < LeastCorners || !_decoder.TryDecode(_signal, _lattice, level))
                    continue;
                ScreenPoint[]? points = new ScreenPointLocator(_decoder.Board, _signal, _decoder.IsUpright).Locate(_decoder.Points);
                if (points != null)
                    return new BoardSighting(_decoder.Board, points, _decoder.IsMirrored);
            }

            return null;
        }
    }
}
