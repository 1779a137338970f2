using System;
using System.Collections.Generic;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Finds the projected boards in a camera's frames. Frames that show the same are averaged; the difference of two such pictures is
    /// searched for a board, since that of a board and its inverse holds nothing but the board. Neither the order nor the timing of the
    /// pictures matters, and frames of other things between them do no harm. A single picture will do where the room allows it. For
    /// set-up: allocates; one thread.
    /// </summary>
    public sealed class ScreenPatternFinder
    {
        /// <summary>Pictures remembered; of more the ones seen most briefly are dropped.</summary>
        private const int MostPictures = 16;

        /// <summary>Levels by which a patch must change, and the share of the patches, to be another picture.</summary>
        private const int PatchChange = 8;
        private const double ChangedShare = 0.04;
        private const int PatchesAcross = 64, PatchesDown = 36, PatchSize = 4;

        /// <summary>Widths of picture at which corners are looked for: the first at which a board is recognised counts.</summary>
        private static readonly int[] SearchWidths = { 640, 1280, 320, 1920 };

        private const double SearchBlurPx = 1.5;
        private const int LeastCorners = 25;

        private readonly List<HeldPicture> _pictures = new List<HeldPicture>();
        private readonly ScreenBoard[] _boards;
        private int[] _patches = Array.Empty<int>();
        private int[] _before = Array.Empty<int>();
        private HeldPicture? _current;
        private int _width, _height, _frames;
        private readonly LightPlane _difference = new LightPlane(), _reduced = new LightPlane(), _blurred = new LightPlane(), _scratch = new LightPlane();
        private readonly BoardSighting?[] _best = new BoardSighting?[2];

        public ScreenPatternFinder()
        {
            var boards = new List<ScreenBoard>();
            for (int down = ScreenBoard.LeastCellsDown; down <= ScreenBoard.MostCellsDown; down++)
            {
                boards.Add(new ScreenBoard(down, false));
                boards.Add(new ScreenBoard(down, true));
            }

            _boards = boards.ToArray();
        }

        /// <summary>The next frame; all must have one size, others are left out. Any colour or grey format.</summary>
        /// <returns>False when it is left out.</returns>
        public bool Add(Image image)
        {
            if (image.Format == PixelFormat.None || image.Format > PixelFormat.Gray8 || image.Width < 64 || image.Height < 64)
                return false;
            if (_frames == 0)
                (_width, _height) = (image.Width, image.Height);
            if (image.Width != _width || image.Height != _height)
                return false;
            _frames++;
            ReadPatches(image);
            if (_current != null && !IsAnother())
            {
                _current.Add(image);
                return true;
            }

            _current = Free();
            _current.Begin(image);
            _pictures.Add(_current);
            return true;
        }

        /// <summary>Looks for the boards in what was added.</summary>
        public ScreenPatternView Find()
        {
            var shown = new List<HeldPicture>(_pictures);
            int longest = 0;
            foreach (HeldPicture picture in shown)
                longest = Math.Max(longest, picture.Frames);

            // Where pictures last, single frames are mixtures of two of them.
            if (longest >= 3)
                shown.RemoveAll(picture => picture.Frames == 1);
            _best[0] = _best[1] = null;
            for (int apart = 1; apart <= 3 && (_best[0] == null || _best[1] == null); apart++)
            {
                for (int i = 0; i + apart < shown.Count; i++)
                {
                    _difference.SetToDifference(shown[i].Sum, 0.5f / shown[i].Frames, shown[i + apart].Sum, 0.5f / shown[i + apart].Frames);
                    Search();
                }
            }

            for (int i = 0; i < shown.Count && (_best[0] == null || _best[1] == null); i++)
            {
                SetToFlattened(shown[i]);
                Search();
            }

            bool isMirrored = _best[0]?.IsMirrored ?? _best[1]?.IsMirrored ?? false;
            return new ScreenPatternView(_width, _height, _frames, shown.Count, isMirrored, _best[0]?.Points ?? Array.Empty<ScreenPoint>(), _best[1]?.Points ?? Array.Empty<ScreenPoint>());
        }

        private HeldPicture Free()
        {
            if (_pictures.Count < MostPictures)
                return new HeldPicture();
            int briefest = 0;
            for (int i = 1; i < _pictures.Count; i++)
            {
                if (_pictures[i].Frames < _pictures[briefest].Frames)
                    briefest = i;
            }

            HeldPicture picture = _pictures[briefest];
            _pictures.RemoveAt(briefest);
            return picture;
        }

        private unsafe void ReadPatches(Image image)
        {
            int step = image.Format == PixelFormat.Bgra32 ? 4 : image.Format == PixelFormat.Yuy2 ? 2 : 1, offset = step == 4 ? 1 : 0;
            (_patches, _before) = (_before, _patches);
            if (_patches.Length == 0)
                _patches = new int[PatchesAcross * PatchesDown];
            for (int i = 0; i < _patches.Length; i++)
            {
                int x = (image.Width - PatchSize) * (i % PatchesAcross) / (PatchesAcross - 1), y = (image.Height - PatchSize) * (i / PatchesAcross) / (PatchesDown - 1);
                int sum = 0;
                for (int j = 0; j < PatchSize * PatchSize; j++)
                    sum += image.Pixels[(long)(y + j / PatchSize) * image.Stride + (x + j % PatchSize) * step + offset];
                _patches[i] = sum;
            }
        }

        private bool IsAnother()
        {
            int changed = 0;
            for (int i = 0; i < _patches.Length; i++)
                changed += Math.Abs(_patches[i] - _before[i]) > PatchChange * PatchSize * PatchSize ? 1 : 0;
            return changed > ChangedShare * _patches.Length;
        }

        /// <summary>A single picture less its surroundings' mean: black and white on either side of zero.</summary>
        private void SetToFlattened(HeldPicture picture)
        {
            int factor = Math.Max(1, _width / 160);
            float share = 1f / picture.Frames;
            _reduced.SetToReduced(picture.Sum, factor);
            _blurred.SetToBlurred(_reduced, _reduced.Width / 24.0, _scratch);
            _difference.Fit(_width, _height);
            for (int y = 0; y < _height; y++)
            {
                for (int x = 0; x < _width; x++)
                    _difference.Values[y * _width + x] = (picture.Sum.Values[y * _width + x] - (float)_blurred.At((x + 0.5) / factor - 0.5, (y + 0.5) / factor - 0.5)) * share;
            }
        }

        private void Search()
        {
            int last = 0;
            foreach (int width in SearchWidths)
            {
                int factor = Math.Max(1, (int)Math.Round(_width / (double)width));
                if (factor == last)
                    continue;
                last = factor;
                _reduced.SetToReduced(_difference, factor);
                _blurred.SetToBlurred(_reduced, SearchBlurPx, _scratch);
                bool isFound = false;
                foreach (SaddleGrid grid in SaddleGrid.FindAll(SaddleFinder.Find(_blurred), LeastCorners))
                {
                    var decoder = new ScreenBoardDecoder(_boards);
                    if (!decoder.TryDecode(_reduced, grid) || !(BoardSighting.TryMeasure(decoder, _difference, factor) is BoardSighting sighting))
                        continue;
                    isFound = true;
                    ref BoardSighting? best = ref _best[decoder.Board.IsShifted ? 1 : 0];
                    if (best == null || sighting.Worth > best.Worth)
                        best = sighting;
                    break;
                }

                if (isFound)
                    return;
            }
        }
    }
}
