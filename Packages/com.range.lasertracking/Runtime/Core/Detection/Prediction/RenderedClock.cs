using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Finds how the clock of a recording of the rendered pictures differs from the camera's, however much: the changes from frame to
    /// frame, seen through a coarse grid over the screen, are correlated at every difference at which the recordings overlap. For
    /// recordings, before they are played; the fine delay is the detector's own to measure. Not for live use: keeps all it is given.
    /// </summary>
    public sealed unsafe class RenderedClock
    {
        /// <summary>Pictures beyond these are not kept: 20 minutes at 60 a second.</summary>
        public const int MaxPictures = 72_000;

        /// <summary>Moving frames of the camera after which more tell nothing new.</summary>
        public const int EnoughMovingFrames = 300;

        private const int Columns = ScreenGrid.Columns / 2, Cells = ScreenGrid.CellCount / 4;
        private const long StepUs = 12_000;
        private const int MaxPairs = 120, MinPairs = 8;
        private const double MinEnergy = 60 * 60;

        private readonly RangeCalibration _calibration;
        private readonly List<Look> _camera = new List<Look>();
        private readonly List<Look> _pictures = new List<Look>();
        private readonly uint[] _pixels = new uint[ScreenGrid.LookCount];
        private readonly int[] _order = new int[ScreenGrid.LookCount];
        private readonly short[] _cells = new short[ScreenGrid.CellCount];
        private int[] _pictureLooks = Array.Empty<int>();
        private int _pictureWidth;
        private int _pictureHeight;
        private ScreenGrid? _grid;

        public RenderedClock(RangeCalibration calibration)
        {
            _calibration = calibration;
            for (int i = 0; i < _order.Length; i++)
                _order[i] = i;
        }

        /// <summary>Frames of the camera in which something moved since the one before.</summary>
        public int MovingFrames { get; private set; }

        /// <summary>The next frame of the camera; of the size that the calibration is for.</summary>
        public void AddCameraFrame(Image image, long timeUs)
        {
            _grid ??= new ScreenGrid(_calibration.Screen, image.Width, image.Height, 1, 1, 1);
            short[] cells = Sum(image, _grid.CameraLooks);
            if (_camera.Count > 0 && Energy(_camera[_camera.Count - 1].Cells, cells) > MinEnergy)
                MovingFrames++;
            _camera.Add(new Look(timeUs, cells));
        }

        /// <summary>The next picture of the projector; what comes after <see cref="MaxPictures"/> is left out.</summary>
        public void AddPicture(Image picture, long timeUs)
        {
            if (_pictures.Count >= MaxPictures)
                return;
            if (picture.Width != _pictureWidth || picture.Height != _pictureHeight)
            {
                _pictureWidth = picture.Width;
                _pictureHeight = picture.Height;
                _pictureLooks = ScreenGrid.Looks(picture.Width, picture.Height);
            }

            _pictures.Add(new Look(timeUs, Sum(picture, _pictureLooks)));
        }

        /// <summary>
        /// What to add to the pictures' times so that each is the time at which the camera saw it, to about 10 ms. False: nothing
        /// fits well; the correlation, 0…1, tells how well at best.
        /// </summary>
        public bool TryFind(double minCorrelation, out long offsetUs, out double correlation)
        {
            offsetUs = 0;
            correlation = 0;
            List<int> pairs = MovingPairs();
            if (_pictures.Count < 2 || pairs.Count < MinPairs)
                return false;
            long first = _camera[0].TimeUs - _pictures[_pictures.Count - 1].TimeUs, last = _camera[_camera.Count - 1].TimeUs - _pictures[0].TimeUs;
            for (long offset = first; offset <= last; offset += StepUs)
            {
                double score = Correlate(pairs, offset);
                if (score <= correlation)
                    continue;
                correlation = score;
                offsetUs = offset;
            }

            return correlation >= minCorrelation;
        }

        private double Correlate(List<int> pairs, long offset)
        {
            double common = 0, drawn = 0, seen = 0;
            int used = 0;
            foreach (int i in pairs)
            {
                int now = PictureAt(_camera[i].TimeUs - offset), before = PictureAt(_camera[i - 1].TimeUs - offset);
                if (now < 0 || before < 0)
                    continue;
                used++;
                short[] a = _camera[i].Cells, b = _camera[i - 1].Cells, c = _pictures[now].Cells, d = _pictures[before].Cells;
                int pairCommon = 0, pairDrawn = 0, pairSeen = 0;
                for (int cell = 0; cell < Cells; cell++)
                {
                    int change = (a[cell] - b[cell]) >> 2, expected = (c[cell] - d[cell]) >> 2;
                    pairCommon += change * expected >> 4;
                    pairDrawn += expected * expected >> 4;
                    pairSeen += change * change >> 4;
                }

                common += pairCommon;
                drawn += pairDrawn;
                seen += pairSeen;
            }

            return used < MinPairs || 3 * used < pairs.Count || common <= 0 ? 0 : common / Math.Sqrt(drawn * seen + 1);
        }

        /// <summary>The last picture drawn until then, or -1 before the first and long after the last.</summary>
        private int PictureAt(long timeUs)
        {
            if (timeUs < _pictures[0].TimeUs || timeUs > _pictures[_pictures.Count - 1].TimeUs + 100_000)
                return -1;
            int low = 0, high = _pictures.Count - 1;
            while (low < high)
            {
                int middle = (low + high + 1) / 2;
                if (_pictures[middle].TimeUs <= timeUs)
                    low = middle;
                else
                    high = middle - 1;
            }

            return low;
        }

        /// <summary>Frames that differ from the one before, evenly chosen when they are many.</summary>
        private List<int> MovingPairs()
        {
            var moving = new List<int>();
            for (int i = 1; i < _camera.Count; i++)
            {
                if (Energy(_camera[i - 1].Cells, _camera[i].Cells) > MinEnergy)
                    moving.Add(i);
            }

            if (moving.Count <= MaxPairs)
                return moving;
            var chosen = new List<int>();
            for (int i = 0; i < MaxPairs; i++)
                chosen.Add(moving[(int)((long)i * moving.Count / MaxPairs)]);
            return chosen;
        }

        private static double Energy(short[] a, short[] b)
        {
            double sum = 0;
            for (int i = 0; i < Cells; i++)
                sum += (a[i] - b[i]) * (double)(a[i] - b[i]);
            return sum / Cells;
        }

        private short[] Sum(Image image, int[] looks)
        {
            fixed (uint* pixels = _pixels)
            fixed (int* order = _order)
            fixed (short* cells = _cells)
            {
                for (int i = 0; i < looks.Length; i++)
                {
                    pixels[i] = 0;
                    if (looks[i] >= 0)
                        PixelRow.ToBgra(image, looks[i] / image.Width, looks[i] % image.Width, looks[i] % image.Width + 1, pixels + i);
                }

                ScreenGrid.SumCells(pixels, order, cells);
            }

            // Four cells in one; their sum is kept in units that fit: the mean.
            var coarse = new short[Cells];
            for (int i = 0; i < Cells; i++)
            {
                int at = i / Columns * 2 * ScreenGrid.Columns + i % Columns * 2;
                coarse[i] = (short)((_cells[at] + _cells[at + 1] + _cells[at + ScreenGrid.Columns] + _cells[at + ScreenGrid.Columns + 1]) / 4);
            }

            return coarse;
        }

        private readonly struct Look
        {
            public readonly long TimeUs;
            public readonly short[] Cells;

            public Look(long timeUs, short[] cells)
            {
                TimeUs = timeUs;
                Cells = cells;
            }
        }
    }
}
