using System;
using LaserTracking.Geometry;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The brightest that the camera should see of the projected picture, from the pictures that the projector was given: geometry
    /// from the calibration; delay and colours learned on the run. A detector that is given one takes what exceeds it for light from
    /// elsewhere, wherever and however long it shines, as long as <see cref="State"/> is Trusted. One thread at a time; no allocation
    /// once warm.
    /// </summary>
    public sealed unsafe class ExpectedView
    {
        /// <summary>Each frame learns from one look in so many.</summary>
        private const int LearnTurns = 3;

        /// <summary>Memory is asked for a look so many before it.</summary>
        private const int LooksAhead = 12;

        /// <summary>Neighbours this far from a look must be nearly as bright, or the look teaches nothing.</summary>
        private const int EvenPx = 2;
        private const int LeastEvenLevels = 24, MostEvenLevels = 100;

        /// <summary>Share of the looks that shall teach: where there are fewer, less even ones have to do.</summary>
        private const double UsefulShare = 0.2;
        private const int QuiteEvenLevels = 4;
        private const double Follow = 0.15;
        private const int TilesPerDot = 4;

        /// <summary>Levels above the expected view up to which a candidate is part of the projected picture.</summary>
        internal const int MinUnexplained = 8;

        private const double MaxErrorShare = 0.15;

        /// <summary>Rendered pixels to one of the searched picture: what is allowed for blur is counted in rendered ones.</summary>
        private const double MostDetail = 1.5;

        private readonly RenderedFrameHistory _history;
        private readonly RangeCalibration _calibration;
        private readonly PredictionSettings _settings;
        private readonly KernelRunner _kernels;
        private readonly DelayMeter _delay;
        private readonly ColorTransfer _transfer = new ColorTransfer();
        private readonly TransferMap _map = new TransferMap();
        private readonly UnexplainedTiles _unexplained = new UnexplainedTiles();
        private readonly short[] _cells = new short[ScreenGrid.CellCount];
        private readonly byte[] _tone = new byte[ExpectationKernel.ToneBytes];
        private readonly int[] _shown = new int[RenderedFrameHistory.Capacity];
        private ScreenGrid? _grid;
        private uint[] _screen = Array.Empty<uint>();
        private uint[] _scratch = Array.Empty<uint>();
        private uint[] _row = Array.Empty<uint>();
        private byte[] _columns = Array.Empty<byte>();
        private byte[] _reference = Array.Empty<byte>();
        private uint[] _picture = Array.Empty<uint>();
        private int _width;
        private int _height;
        private int _factor;
        private int _renderedWidth;
        private int _renderedHeight;
        private int _shownCount;
        private int _dotCount;
        private int _evenLevels = LeastEvenLevels;
        private long _learned;
        private bool _useVectors = true;

        /// <param name="history">What the projector was given; somebody keeps adding to it.</param>
        /// <param name="calibration">Where the screen lies in the camera's picture.</param>
        /// <param name="settings">Defaults when absent. Copied.</param>
        /// <param name="kernels">What runs the heavy kernels; this thread when absent.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public ExpectedView(RenderedFrameHistory history, RangeCalibration calibration, PredictionSettings? settings = null, KernelRunner? kernels = null)
        {
            _kernels = kernels ?? KernelRunner.Plain;
            _history = history;
            _calibration = calibration;
            _settings = settings?.Clone() ?? new PredictionSettings();
            _settings.Validate();
            _delay = new DelayMeter(_settings);
        }

        public PredictionState State { get; private set; }

        /// <summary>From drawing a picture to the middle of the exposure that shows it, µs; null: not known.</summary>
        public long? DelayUs => _delay.IsKnown ? _delay.DelayUs : (long?)null;

        /// <summary>Share of the screen, of late, that was brighter than expected.</summary>
        public double UnexplainedShare { get; private set; } = 1;

        /// <summary>Temporal noise of the working picture, levels; 0: not known. Set when the picture's treatment changes.</summary>
        internal double Noise
        {
            get => _transfer.Noise;
            set => _transfer.Noise = value;
        }

        /// <summary>Levels by which light must exceed the expected view, in the frame looked at last.</summary>
        internal int MinExcess { get; private set; }

        /// <summary>The most by which a pixel of each tile exceeds the expected view, levels.</summary>
        internal TileGrid Tiles { get; } = new TileGrid();

        /// <summary>Levels above which light exceeds the expected view, for the working pixels' largest channels.</summary>
        internal byte[] Reference => _reference;

        /// <summary>A picture of the working size, filled where <see cref="CopyExpected"/> was asked to.</summary>
        internal uint[] Picture => _picture;

        public void Reset()
        {
            _grid = null;
            State = PredictionState.Off;
        }

        /// <summary>Looks at the working picture of a frame. True: the expected view can be relied on for this frame.</summary>
        internal bool Update(in FrameView view, int factor, int imageWidth, int imageHeight, long timeUs, double noise, bool useVectors)
        {
            lock (_history.Gate)
            {
                if (_history.Count == 0 || imageWidth != _calibration.ImageWidth || imageHeight != _calibration.ImageHeight)
                {
                    State = PredictionState.Off;
                    return false;
                }

                if (Fit(view, factor) && LimitPictures())
                {
                    State = PredictionState.Searching;
                    return false;
                }

                _useVectors = useVectors;
                fixed (int* looks = _grid!.CameraLooks)
                fixed (short* cells = _cells)
                    ScreenGrid.SumCells(view.Now, looks, cells);
                _delay.Update(_history, timeUs, _cells, _grid.IsHidden);
                if (!_delay.IsKnown || !FindShown(timeUs))
                {
                    State = PredictionState.Searching;
                    return false;
                }

                Learn(view);
                if (!_transfer.IsLearned)
                {
                    State = PredictionState.Learning;
                    return false;
                }

                MinExcess = Math.Min(255, Math.Max(_settings.MinExcess, (int)(_settings.MinExcessSigmas * (Noise > 0 ? Noise : noise))));
                Expect(view);
                Judge();
                return State == PredictionState.Trusted;
            }
        }

        /// <summary>Writes what is expected at most into a part of <see cref="Picture"/>.</summary>
        internal void CopyExpected(int left, int top, int right, int bottom)
        {
            int[] blocks = _grid!.Blocks;
            for (int y = Math.Max(0, top); y <= Math.Min(_height - 1, bottom); y++)
            {
                for (int x = Math.Max(0, left); x <= Math.Min(_width - 1, right); x++)
                    _picture[y * _width + x] = _screen[blocks[y / 2 * _grid.BlockColumns + x / 2]];
            }
        }

        /// <summary>Nothing in the tile is brighter than expected.</summary>
        internal bool ExplainsTile(int tile) => Tiles.Onset(tile) < MinUnexplained;

        /// <summary>Those of some tiles that are not explained, moved to the front.</summary>
        internal Span<int> Unexplained(Span<int> tiles) => Tiles.Reaching(MinUnexplained, tiles);

        /// <summary>The candidate's seed is no brighter than expected.</summary>
        internal bool Explains(in FrameView view, in Candidate candidate, out int excess)
        {
            int at = candidate.SeedY * _width + candidate.SeedX;
            excess = FrameView.Level(view.Now[at], DetectionPlane.Largest) - _reference[at];
            return excess < MinUnexplained;
        }

        /// <summary>How often of late, 0…1, the surroundings of a working pixel were brighter than expected without a dot.</summary>
        internal double UnexplainedAround(int x, int y) => _unexplained.ShareAround(Tiles, x, y);

        /// <summary>Ends a frame that was looked at: the tiles of its dots are not held against the expected view.</summary>
        internal void EndFrame(int dotCount, DotMemory memory)
        {
            _dotCount = dotCount;
            if (State != PredictionState.Trusted && State != PredictionState.Doubtful)
                return;
            memory.Exempt(Tiles);
            _unexplained.Learn(Tiles, MinExcess);
        }

        /// <summary>Share of the screen on which the expected view leaves too little room for light to exceed it.</summary>
        internal double BlindShare()
        {
            int blind = 0, count = 0;
            uint limit = (uint)(255 - MinExcess);
            for (int i = 0; i < _screen.Length - 1; i += 7)
            {
                uint pixel = _screen[i];
                count++;
                if ((pixel & 255) > limit && (pixel >> 8 & 255) > limit && (pixel >> 16 & 255) > limit)
                    blind++;
            }

            return count == 0 ? 0 : blind / (double)count;
        }

        /// <summary>Returns whether a size has changed.</summary>
        private bool Fit(in FrameView view, int factor)
        {
            bool isSame = _grid != null && view.Width == _width && view.Height == _height && factor == _factor;
            if (isSame && _history.Width == _renderedWidth && _history.Height == _renderedHeight)
                return false;
            _width = view.Width;
            _height = view.Height;
            _factor = factor;
            _renderedWidth = _history.Width;
            _renderedHeight = _history.Height;
            _grid = new ScreenGrid(_calibration.Screen, _width, _height, factor, _renderedWidth, _renderedHeight);
            int pixels = _renderedWidth * _renderedHeight;
            _screen = new uint[pixels + 1];
            _scratch = new uint[ExpectationBands.ScratchLength(_renderedWidth) * _kernels.BandCount];
            _row = new uint[2 * _grid.BlockColumns * _kernels.BandCount];
            _reference = new byte[_width * _height];
            _picture = new uint[_width * _height];
            _columns = new byte[_width * _kernels.BandCount];
            Tiles.Resize(_width, _height);
            _unexplained.Resize(Tiles.Columns * Tiles.Rows);
            _map.Resize(_renderedWidth, _renderedHeight);
            _delay.Reset();
            _transfer.Reset();
            UnexplainedShare = 1;
            return true;
        }

        /// <summary>Has the pictures reduced to what the camera can see of them; true when they start anew for it.</summary>
        private bool LimitPictures()
        {
            ReadOnlySpan<Vector2D> corners = _calibration.Screen.CornersPx;
            double seen = Math.Max((corners[1] - corners[0]).Length, (corners[2] - corners[3]).Length) / _factor;
            _history.LimitWidth((int)(MostDetail * seen));
            return _history.Count == 0;
        }

        /// <summary>Lists the pictures that this exposure may have seen; false when one of them is not there.</summary>
        private bool FindShown(long timeUs)
        {
            long slack = _settings.ExposureUs / 2 + Math.Max(_settings.DelaySlackUs, Math.Min(40_000, _delay.UncertaintyUs));
            long begin = timeUs - _delay.DelayUs - slack, end = timeUs - _delay.DelayUs + slack;
            _shownCount = 0;
            bool isWhole = _history.EndUs(0) >= timeUs - _delay.DelayUs;
            for (int age = 0; age < _history.Count; age++)
            {
                if (_history.At(age).TimeUs < end && _history.EndUs(age) > begin)
                    _shown[_shownCount++] = age;
            }

            return isWhole && _shownCount > 0 && _history.At(_history.Count - 1).TimeUs <= begin;
        }

        private void Learn(in FrameView view)
        {
            _transfer.BeginFrame();
            int turn = (int)(_learned++ % LearnTurns), useful = 0;
            for (int look = turn; look < ScreenGrid.LookCount; look += LearnTurns)
            {
                int at = _grid!.RenderedLooks[look], camera = _grid.CameraLooks[look];
                AnnounceLook(look + LooksAhead * LearnTurns);
                if (camera < 0 || !TryMean(at, out int blue, out int green, out int red, out bool isQuiteEven))
                    continue;
                useful++;
                uint seen = view.Now[camera];
                int cell = look / ScreenGrid.LooksPerCell;
                _transfer.Learn(cell, 0, blue, (int)(seen & 255), isQuiteEven);
                _transfer.Learn(cell, 1, green, (int)(seen >> 8 & 255), isQuiteEven);
                _transfer.Learn(cell, 2, red, (int)(seen >> 16 & 255), isQuiteEven);
            }

            _transfer.EndFrame();
            _evenLevels = useful * LearnTurns < UsefulShare * ScreenGrid.LookCount ? Math.Min(MostEvenLevels, _evenLevels + 4) : Math.Max(LeastEvenLevels, _evenLevels - 1);
        }

        /// <summary>Looks lie too far apart for a processor to foresee.</summary>
        private void AnnounceLook(int look)
        {
#if NET8_0_OR_GREATER
            for (int i = 0; i < _shownCount && look < ScreenGrid.LookCount; i++)
                ExpectationKernel.Announce(_history.At(_shown[i]).Pixels + _grid!.RenderedLooks[look], EvenPx, _renderedWidth);
#endif
        }

        /// <summary>What was shown there on average; false where it was not even over the pictures and the neighbours.</summary>
        private bool TryMean(int at, out int blue, out int green, out int red, out bool isQuiteEven)
        {
            blue = green = red = 0;
            isQuiteEven = true;
            int x = at % _renderedWidth, y = at / _renderedWidth;
            if (x < EvenPx || y < EvenPx || x >= _renderedWidth - EvenPx || y >= _renderedHeight - EvenPx)
                return false;
            uint first = _history.At(_shown[0]).Pixels[at];
            for (int i = 0; i < _shownCount; i++)
            {
                uint* center = _history.At(_shown[i]).Pixels + at;
                int apart = ExpectationKernel.Apart(first, center, EvenPx, _renderedWidth, _useVectors);
                if (apart > _evenLevels)
                    return false;
                isQuiteEven &= apart <= QuiteEvenLevels;
                blue += (int)(*center & 255);
                green += (int)(*center >> 8 & 255);
                red += (int)(*center >> 16 & 255);
            }

            blue /= _shownCount;
            green /= _shownCount;
            red /= _shownCount;
            return true;
        }

        /// <summary>Relied on as long as next to nothing but dots exceeds the expected view.</summary>
        private void Judge()
        {
            int tiles = Tiles.Columns * Tiles.Rows, above = -TilesPerDot * _dotCount;
            for (int tile = 0; tile < tiles; tile++)
                above += Tiles.Onset(tile) >= MinExcess ? 1 : 0;
            double share = Math.Max(0, above) / (double)tiles;
            UnexplainedShare += Follow * (share - UnexplainedShare);
            double limit = (State == PredictionState.Trusted ? 1 : 0.5) * _settings.MaxUnexplainedShare;
            bool isSound = UnexplainedShare <= limit && share <= 4 * _settings.MaxUnexplainedShare && _transfer.ErrorShare <= MaxErrorShare;
            State = isSound ? PredictionState.Trusted : PredictionState.Doubtful;
        }

        private void Expect(in FrameView view)
        {
            _map.Update(_transfer, _settings.LevelSlack, _useVectors);
            fixed (byte* tone = _tone)
            fixed (uint* screen = _screen, scratch = _scratch, gain = _map.Gain, offset = _map.Offset)
            {
                _transfer.FillTone(tone, _settings.GainSlack);
                uint** pictures = stackalloc uint*[RenderedFrameHistory.Capacity];
                for (int i = 0; i < _shownCount; i++)
                    pictures[i] = _history.At(_shown[i]).Pixels;
                var work = new ExpectationBands
                {
                    Width = _renderedWidth,
                    Height = _renderedHeight,
                    UseVectors = _useVectors,
                    BandCount = _kernels.BandCount,
                    PictureCount = _shownCount,
                    Pictures = pictures,
                    Screen = screen,
                    Tone = tone,
                    Gain = gain,
                    Offset = offset,
                    Scratch = scratch,
                };
                _kernels.Run(&work, work.BandCount);

                // Beside the screen anything may be.
                screen[_screen.Length - 1] = 0xFFFFFFFFu;
                Compare(view, screen);
            }
        }

        private void Compare(in FrameView view, uint* screen)
        {
            fixed (int* blocks = _grid!.Blocks)
            fixed (uint* row = _row)
            fixed (byte* reference = _reference, columns = _columns, onsets = Tiles.Onsets)
            {
                var work = new ComparisonBands
                {
                    Width = _width,
                    Height = _height,
                    BlockColumns = _grid.BlockColumns,
                    UseVectors = _useVectors,
                    BandCount = _kernels.BandCount,
                    Now = view.Now,
                    Screen = screen,
                    Blocks = blocks,
                    Reference = reference,
                    Onsets = onsets,
                    Row = row,
                    Columns = columns,
                };
                _kernels.Run(&work, work.BandCount);
            }
        }
    }
}
