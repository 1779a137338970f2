using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Looks at one place of the colour picture at full resolution: is there a spot of light, where exactly, of which hue? Hue is
    /// taken from each channel's rise over the surroundings through its own headroom, over the spot and its rim: a clipped core is
    /// white whatever the laser, its rim is not. Independent of the raw format.
    /// </summary>
    internal sealed unsafe class ColorProbe
    {
        /// <summary>Headroom of a channel below which its silence says nothing, levels.</summary>
        private const int MinHeadroom = 16;

        /// <summary>Share of the headroom from which light is no part of the texture around it, however rough that is.</summary>
        private const double PlainRise = 0.5;

        private readonly DualDetectorSettings _settings;
        private readonly SpotWindow _window = new SpotWindow();
        private readonly uint[] _pixels = new uint[(2 * SpotWindow.MaxRadius + 1) * (2 * SpotWindow.MaxRadius + 1)];
        private readonly int[] _background = new int[3];

        public ColorProbe(DualDetectorSettings settings) => _settings = settings;

        /// <summary>The spot that <see cref="Look"/> measured last; valid unless it said None before measuring.</summary>
        public Spot Spot { get; private set; }

        /// <summary>By how much green exceeds both others, through the colourfulness: 1 pure green, 0 white or yellow, below 0 others.</summary>
        public double GreenShare { get; private set; }

        /// <summary>Height of the light's strongest channel through the headroom, 0…1.</summary>
        public double RelativeRise { get; private set; }

        /// <summary>Brightest channel value.</summary>
        public int Peak { get; private set; }

        /// <summary>Why there is no spot when the answer is None, with value and limit.</summary>
        public RejectedCandidate Failure { get; private set; }

        /// <param name="image">Any colour format.</param>
        /// <param name="around">Where, px.</param>
        /// <param name="reachPx">Distance up to which the spot's brightest pixel may lie.</param>
        public LightHue Look(Image image, Vector2D around, double reachPx)
        {
            double scale = Math.Max(0.25, image.Width / 1920.0);
            int radius = (int)Math.Ceiling(reachPx + 20 * scale);
            if (!_window.Place((int)Math.Round(around.X), (int)Math.Round(around.Y), radius, image.Width, image.Height))
                return Fail(RejectionReason.OutsideScreen, around, 0, 0);
            double sigma = Read(image);
            int peak = _window.Brightest(around, reachPx);
            if (peak < 0)
                return Fail(RejectionReason.OutsideScreen, around, 0, 0);
            Spot spot = _window.Measure(peak);
            Spot = spot;
            Strongest(_pixels[peak], out int rise, out double relative);
            RelativeRise = relative;
            double least = relative >= PlainRise ? _settings.MinColorRise : Math.Max(_settings.MinColorRise, _settings.MinColorSigmas * sigma);
            if (rise < least)
                return Fail(RejectionReason.TooFaint, spot.PositionPx, rise, least);
            if (spot.IsCut || spot.Area > _settings.MaxColorAreaPx * scale * scale)
                return Fail(RejectionReason.TooLarge, spot.PositionPx, spot.Area, _settings.MaxColorAreaPx * scale * scale);
            if (spot.Elongation > _settings.MaxElongation)
                return Fail(RejectionReason.TooElongated, spot.PositionPx, spot.Elongation, _settings.MaxElongation);
            if (spot.RingShare > _settings.MaxRingShare)
                return Fail(RejectionReason.NotIsolated, spot.PositionPx, spot.RingShare, _settings.MaxRingShare);
            return Hue(spot);
        }

        private LightHue Fail(RejectionReason reason, Vector2D at, double value, double limit)
        {
            Failure = new RejectedCandidate { PositionPx = at, Reason = reason, Value = value, Limit = limit };
            return LightHue.None;
        }

        /// <summary>Fills the window with each pixel's rise summed over the channels; returns the noisiest channel's spread.</summary>
        private double Read(Image image)
        {
            int width = _window.Width, count = width * _window.Height;
            fixed (uint* pixels = _pixels)
            {
                for (int y = 0; y < _window.Height; y++)
                    PixelRow.ToBgra(image, _window.Top + y, _window.Left, _window.Left + width, pixels + y * width);
            }

            int[] light = _window.Light;
            double noisiest = 0;
            for (int channel = 0; channel < 3; channel++)
            {
                _background[channel] = _window.Background(_pixels, channel, out double sigma);
                noisiest = Math.Max(noisiest, sigma);
            }

            int background = _background[0] + _background[1] + _background[2];
            for (int i = 0; i < count; i++)
            {
                uint p = _pixels[i];
                light[i] = (int)((p & 255) + (p >> 8 & 255) + (p >> 16 & 255)) - background;
            }

            return noisiest;
        }

        private void Strongest(uint pixel, out int rise, out double relative)
        {
            rise = 0;
            relative = 0;
            Peak = 0;
            for (int channel = 0; channel < 3; channel++)
            {
                int value = (int)(pixel >> (8 * channel) & 255), over = value - _background[channel];
                Peak = Math.Max(Peak, value);
                rise = Math.Max(rise, over);
                relative = Math.Max(relative, over / (255.0 - _background[channel] + 8));
            }
        }

        private LightHue Hue(in Spot spot)
        {
            int margin = 1 + (int)Math.Ceiling(0.3 * Math.Max(spot.Right - spot.Left, spot.Bottom - spot.Top));
            double bright = 0, colorful = 0, green = 0, magenta = 0;
            for (int y = Math.Max(0, spot.Top - margin); y <= Math.Min(_window.Height - 1, spot.Bottom + margin); y++)
            {
                for (int x = Math.Max(0, spot.Left - margin); x <= Math.Min(_window.Width - 1, spot.Right + margin); x++)
                {
                    uint p = _pixels[y * _window.Width + x];
                    double b = Rise(p, 0), g = Rise(p, 1), r = Rise(p, 2);
                    double largest = Math.Max(b, Math.Max(g, r));

                    // What is hardly brighter than the surroundings has their noise for a colour.
                    if (largest < 0.15 * RelativeRise)
                        continue;
                    bright += largest;
                    colorful += largest - Math.Min(b, Math.Min(g, r));
                    green += g - Math.Max(b, r);
                    magenta += Math.Min(b, r) - g;
                }
            }

            GreenShare = colorful > 0 ? green / colorful : 0;
            if (255 - Math.Max(_background[0], Math.Max(_background[1], _background[2])) < MinHeadroom)
                return LightHue.Unknown;
            if (colorful < _settings.MinColorfulness * bright)
                return LightHue.White;
            if (GreenShare >= _settings.MinGreenShare)
                return LightHue.Green;
            return magenta >= _settings.MinGreenShare * colorful ? LightHue.Magenta : LightHue.Other;
        }

        private double Rise(uint pixel, int channel)
        {
            int over = (int)(pixel >> (8 * channel) & 255) - _background[channel];
            return over <= 0 ? 0 : over / (255.0 - _background[channel] + 8);
        }
    }
}
