using System;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Asks the detector whether it would have taken a dot that was not there: draws it into the working picture of the last frame,
    /// puts it through the detector's own gate, growing and judging, and takes it away again. Every limit is the detector's. Between
    /// two frames, on the detector's thread.
    /// </summary>
    internal sealed unsafe class DetectorProbe
    {
        private const int Reach = 16;
        private const int Side = 2 * Reach + 1;

        private readonly ShotDetectorSettings _settings;
        private readonly DetectionPlanes _planes;
        private readonly GlobalChangeMeter _change;
        private readonly CandidateJudge _judge;
        private readonly BlobMeasurer _blobs;
        private readonly SeedFinder _finder;
        private readonly int[] _reciprocal;
        private readonly DotMemory _nothing = new DotMemory();
        private readonly uint[] _kept = new uint[Side * Side];
        private readonly float[] _rise = new float[3 * Side * Side];
        private readonly float[] _linear = new float[256];
        private double _gamma;

        public DetectorProbe(ShotDetectorSettings settings, DetectionPlanes planes, GlobalChangeMeter change, CandidateJudge judge, BlobMeasurer blobs,
            SeedFinder finder, int[] reciprocal)
        {
            _settings = settings;
            _planes = planes;
            _change = change;
            _judge = judge;
            _blobs = blobs;
            _finder = finder;
            _reciprocal = reciprocal;
        }

        /// <summary>The working picture is smoothed at present.</summary>
        public bool IsSmooth { get; set; }

        /// <summary>Enough frames have been seen.</summary>
        public bool IsReady => _planes.FrameCount >= 3;

        /// <summary>Size of the full picture is this many times that of the working one.</summary>
        public int Factor => _planes.Factor;

        public double Noise => _judge.Noise;

        /// <summary>Frames that what is not conclusive may last.</summary>
        /// <param name="intervalUs">Between frames.</param>
        public int MaxWaitFrames(double intervalUs) => WaitLimit.FramesAt(intervalUs, _settings.MaxWaitFrames, _settings.MaxWaitUs);

        /// <summary>Brightness of the projected picture's brightest parts, levels.</summary>
        public int ContentLevel => _judge.ContentLevel;

        /// <summary>Display value = linear light^(1/gamma).</summary>
        public void SetGamma(double gamma)
        {
            if (gamma == _gamma)
                return;
            _gamma = gamma;
            for (int level = 0; level < 256; level++)
                _linear[level] = (float)Math.Pow(level / 255.0, gamma);
        }

        /// <summary>The last frame's strongest channel at a place of the full picture.</summary>
        public int LevelAt(Geometry.Vector2D positionPx)
        {
            int x = Math.Max(0, Math.Min(_planes.Width - 1, (int)Math.Round((positionPx.X + 0.5) / Factor - 0.5)));
            int y = Math.Max(0, Math.Min(_planes.Height - 1, (int)Math.Round((positionPx.Y + 0.5) / Factor - 0.5)));
            return FrameView.Level(_planes.Now[y * _planes.Width + x], DetectionPlane.Largest);
        }

        /// <summary>True when the detector would have made a dot of it, and whether one frame suffices; else why not.</summary>
        public bool Takes(in ProbeLight light, out bool isConclusive, out RejectionReason reason)
        {
            int centerX = (int)Math.Round((light.PositionPx.X + 0.5) / Factor - 0.5) - _change.ShiftX;
            int centerY = (int)Math.Round((light.PositionPx.Y + 0.5) / Factor - 0.5) - _change.ShiftY;
            int left = Math.Max(0, centerX - Reach), right = Math.Min(_planes.Width - 1, centerX + Reach);
            int top = Math.Max(0, centerY - Reach), bottom = Math.Min(_planes.Height - 1, centerY + Reach);
            reason = RejectionReason.TooFaint;
            isConclusive = false;
            if (left > right || top > bottom)
                return false;
            fixed (uint* now = _planes.Now, before = _planes.Before)
            fixed (byte* oldMin = _planes.OldSmallest, newMin = _planes.NewSmallest, oldMax = _planes.OldLargest, newMax = _planes.NewLargest)
            fixed (int* reciprocal = _reciprocal)
            {
                FrameView view = FrameView.Of(_planes, _change, now, before, oldMin, newMin, oldMax, newMax, reciprocal);
                for (int y = top; y <= bottom; y++)
                {
                    for (int x = left; x <= right; x++)
                        _kept[(y - top) * Side + x - left] = now[y * view.Width + x];
                }

                Draw(light, view, left, top, right, bottom);
                bool isTaken = IsTaken(view, centerX, centerY, left, top, right, bottom, out isConclusive, ref reason);
                for (int y = top; y <= bottom; y++)
                {
                    for (int x = left; x <= right; x++)
                        now[y * view.Width + x] = _kept[(y - top) * Side + x - left];
                }

                return isTaken;
            }
        }

        private void Draw(in ProbeLight light, in FrameView view, int left, int top, int right, int bottom)
        {
            // Chroma is the mean over two pixels of a row, in NV12 over those of two rows.
            int chromaX = _planes.Format == PixelFormat.Nv12 || _planes.Format == PixelFormat.Yuy2 ? 2 : 1, chromaY = _planes.Format == PixelFormat.Nv12 ? 2 : 1;
            for (int y = top; y <= bottom; y++)
            {
                for (int x = left; x <= right; x++)
                {
                    int i = (y - top) * Side + x - left, x0 = (x + view.ShiftX) * Factor, y0 = (y + view.ShiftY) * Factor;

                    // Several pixels become one by their maximum: the one nearest to the centre.
                    float energy = Energy(light, Nearest(light.PositionPx.X - x0), Nearest(light.PositionPx.Y - y0));
                    Rises(light, i, energy, out float blue, out float green, out float red);
                    if (chromaX > 1 && energy > 1e-4f)
                    {
                        float mean = 0;
                        for (int j = 0; j < chromaX * chromaY; j++)
                            mean += Energy(light, light.PositionPx.X - (x0 / 2 * 2 + j % 2), light.PositionPx.Y - (y0 / chromaY * chromaY + j / 2)) / (chromaX * chromaY);
                        Rises(light, i, mean, out float meanBlue, out float meanGreen, out float meanRed);
                        float luma = Luma(blue, green, red), meanLuma = Luma(meanBlue, meanGreen, meanRed);
                        blue = luma + meanBlue - meanLuma;
                        green = luma + meanGreen - meanLuma;
                        red = luma + meanRed - meanLuma;
                    }

                    _rise[3 * i] = blue;
                    _rise[3 * i + 1] = green;
                    _rise[3 * i + 2] = red;
                }
            }

            for (int y = top; y <= bottom; y++)
            {
                for (int x = left; x <= right; x++)
                {
                    int i = (y - top) * Side + x - left;
                    uint old = _kept[i];
                    view.Now[y * view.Width + x] = PixelRow.Pack(Level(old & 255, i, 0), Level(old >> 8 & 255, i, 1), Level(old >> 16 & 255, i, 2));
                }
            }
        }

        /// <summary>Light at a distance from the centre, through that at the centre.</summary>
        private static float Energy(in ProbeLight light, double dx, double dy)
        {
            double scale2 = light.HaloScale * light.HaloScale, core = 1 - light.HaloShare, halo = 2 * light.HaloShare / scale2;
            double u = (dx * dx + dy * dy) / (light.SigmaPx * light.SigmaPx), fall = scale2 / (scale2 + u);
            return (float)(((u < 40 ? core * Math.Exp(-0.5 * u) : 0) + halo * fall * fall) / (core + halo));
        }

        private void Rises(in ProbeLight light, int i, float energy, out float blue, out float green, out float red)
        {
            blue = Rise(_kept[i] & 255, light.Blue * energy);
            green = Rise(_kept[i] >> 8 & 255, light.Green * energy);
            red = Rise(_kept[i] >> 16 & 255, light.Red * energy);
        }

        private static float Luma(float blue, float green, float red) => 0.114f * blue + 0.587f * green + 0.299f * red;

        /// <summary>Distance of a point to the nearest of the pixel centres 0 … factor - 1.</summary>
        private double Nearest(double at) => Math.Abs(at - Math.Max(0, Math.Min(Factor - 1, Math.Round(at))));

        private float Rise(uint level, float light)
        {
            if (light < 1e-5f)
                return 0;
            double linear = Math.Min(1, _linear[level] + light);
            return (float)(255 * Math.Pow(linear, 1 / _gamma) - level);
        }

        private int Level(uint old, int i, int channel)
        {
            if (!IsSmooth)
                return (int)(old + _rise[3 * i + channel] + 0.5f);
            float sum = 0, weight = 0;
            int x = i % Side, y = i / Side;
            for (int dy = -1; dy <= 1; dy++)
            {
                for (int dx = -1; dx <= 1; dx++)
                {
                    if (x + dx < 0 || y + dy < 0 || x + dx >= Side || y + dy >= Side)
                        continue;
                    float w = (2 - Math.Abs(dx)) * (2 - Math.Abs(dy));
                    sum += w * _rise[3 * (i + dy * Side + dx) + channel];
                    weight += w;
                }
            }

            return (int)(old + sum / weight + 0.5f);
        }

        private bool IsTaken(in FrameView view, int centerX, int centerY, int left, int top, int right, int bottom, out bool isConclusive, ref RejectionReason reason)
        {
            bool isTaken = isConclusive = false;
            for (int p = 0; p < 2; p++)
            {
                var plane = (DetectionPlane)p;
                TileGrid tiles = plane == DetectionPlane.Smallest ? _planes.SmallestTiles : _planes.LargestTiles;
                _blobs.Begin();
                for (int row = top / TileGrid.Size; row <= bottom / TileGrid.Size; row++)
                {
                    for (int column = left / TileGrid.Size; column <= right / TileGrid.Size; column++)
                    {
                        int tile = row * tiles.Columns + column;
                        if (Onset(view, plane, column, row) <= tiles.Gate(tile, ShotDetector.GateFloor))
                            continue;
                        _finder.Fill(view, plane, tiles.Columns, new ReadOnlySpan<int>(&tile, 1));
                        if (!_finder.TryFind(view, plane, column, row, 0, out Candidate candidate) || !IsHere(candidate, centerX, centerY))
                            continue;
                        candidate.Activity = tiles.Activity(tile);
                        candidate.ActivityAround = tiles.ActivityAround(tile);
                        _judge.Judge(view, ref candidate, _nothing, out _);
                        Note(candidate, ref isTaken, ref isConclusive, ref reason);
                    }
                }
            }

            if (!_judge.IsContentKnown || isConclusive)
                return isTaken;
            _blobs.Begin();
            int limit = _judge.ContentLevel + _settings.MinContentExcess;
            for (int row = top / TileGrid.Size; row <= bottom / TileGrid.Size; row++)
            {
                for (int column = left / TileGrid.Size; column <= right / TileGrid.Size; column++)
                {
                    if (Onset(view, DetectionPlane.Largest, column, row) < _settings.MinContentExcess / 2
                        || !_finder.TryFindExcess(view, column, row, limit, out Candidate candidate) || !IsHere(candidate, centerX, centerY))
                        continue;
                    candidate.Activity = _planes.LargestTiles.Activity(row * _planes.LargestTiles.Columns + column);
                    _judge.JudgeAboveContent(view, ref candidate, _nothing, out _);
                    Note(candidate, ref isTaken, ref isConclusive, ref reason);
                }
            }

            return isTaken;
        }

        private static void Note(in Candidate candidate, ref bool isTaken, ref bool isConclusive, ref RejectionReason reason)
        {
            isTaken |= candidate.Reason == RejectionReason.None;
            isConclusive |= candidate.Reason == RejectionReason.None && candidate.IsConclusive;
            if (candidate.Reason != RejectionReason.None)
                reason = candidate.Reason;
        }

        private static bool IsHere(in Candidate candidate, int centerX, int centerY) =>
            Math.Abs(candidate.SeedX - centerX) <= 4 && Math.Abs(candidate.SeedY - centerY) <= 4;

        /// <summary>The tile's largest onset as the envelope kernel counts it.</summary>
        private static int Onset(in FrameView view, DetectionPlane plane, int column, int row)
        {
            int largest = 0;
            for (int y = row * TileGrid.Size; y < Math.Min(view.Height, (row + 1) * TileGrid.Size); y++)
            {
                for (int x = column * TileGrid.Size; x < Math.Min(view.Width, (column + 1) * TileGrid.Size); x++)
                {
                    int i = y * view.Width + x, room = 255 - view.Envelope(i, plane);
                    largest = Math.Max(largest, view.Rise(i, plane) - (room >> EnvelopeKernel.HeadroomShift));
                }
            }

            return largest;
        }
    }
}
