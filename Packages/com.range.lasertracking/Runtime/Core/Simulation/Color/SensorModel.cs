using System;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// The sensor as tables: noise and tone for every linear signal. Signals are integers, <see cref="FullScale"/> = saturation;
    /// scenes may reach four times that. Immutable.
    /// </summary>
    internal sealed unsafe class SensorModel
    {
        public const int FullScale = 16384;

        /// <summary>Largest signal a scene holds.</summary>
        public const int Largest = 65535;

        private const int Margin = 16384;
        private const double ToeEnd = 0.01;

        private readonly byte[] _tone = new byte[Largest + 1 + 2 * Margin];
        private readonly ushort[] _noise = new ushort[(Largest + 1) / 16];
        private readonly short[] _gaussian = CounterRandom.GaussianTable();

        public SensorModel(ColorCameraSettings settings)
        {
            double electrons = settings.FullWellElectrons / settings.Gain;
            for (int i = 0; i < _noise.Length; i++)
            {
                double signal = (i * 16 + 8) / (double)FullScale * electrons;
                double sigma = Math.Sqrt(signal + settings.ReadNoiseElectrons * settings.ReadNoiseElectrons) / electrons * FullScale;
                // 4095 keeps the largest noise inside the tone table's margins.
                _noise[i] = (ushort)Math.Round(Math.Min(4095, sigma) * 16);
            }

            for (int i = 0; i < _tone.Length; i++)
                _tone[i] = (byte)Math.Round(255 * Curve((i - Margin) / (double)FullScale, settings.Gamma));
        }

        /// <summary>Display value 0…1 of a linear signal.</summary>
        public static double Curve(double linear, double gamma)
        {
            if (linear <= 0)
                return 0;
            if (linear >= 1)
                return 1;
            return linear < ToeEnd ? linear * Math.Pow(ToeEnd, 1 / gamma - 1) : Math.Pow(linear, 1 / gamma);
        }

        /// <summary>
        /// One row of signals (blue, green, red, unused) to BGRA bytes. Noise depends on the pixel's index and the frame's key only.
        /// Light that flickers comes in the same layout, or as null; its strength in this row, and the exposure's factor: 4096 = 1.
        /// </summary>
        public void DevelopRow(ushort* signal, ushort* ambient, int ambientQ12, int exposureQ12, int count, uint firstIndex, uint key, byte* bgra)
        {
            fixed (byte* toneBase = _tone)
            fixed (ushort* noise = _noise)
            fixed (short* gaussian = _gaussian)
            {
                byte* tone = toneBase + Margin;
                for (int x = 0; x < count; x++, signal += 4, bgra += 4)
                {
                    uint random = CounterRandom.Pixel(firstIndex + (uint)x, key);
                    int b = signal[0], g = signal[1], r = signal[2];
                    if (ambient != null)
                    {
                        b = Math.Min(Largest, b + (ambient[4 * x] * ambientQ12 >> 12));
                        g = Math.Min(Largest, g + (ambient[4 * x + 1] * ambientQ12 >> 12));
                        r = Math.Min(Largest, r + (ambient[4 * x + 2] * ambientQ12 >> 12));
                    }

                    if (exposureQ12 != 4096)
                    {
                        b = (int)Math.Min(Largest, (long)b * exposureQ12 >> 12);
                        g = (int)Math.Min(Largest, (long)g * exposureQ12 >> 12);
                        r = (int)Math.Min(Largest, (long)r * exposureQ12 >> 12);
                    }

                    b += gaussian[random >> 22] * noise[b >> 4] + 2048 >> 12;
                    g += gaussian[random >> 12 & 1023] * noise[g >> 4] + 2048 >> 12;
                    r += gaussian[random >> 2 & 1023] * noise[r >> 4] + 2048 >> 12;
                    *(uint*)bgra = tone[b] | (uint)tone[g] << 8 | (uint)tone[r] << 16 | 0xFF000000u;
                }
            }
        }
    }
}
