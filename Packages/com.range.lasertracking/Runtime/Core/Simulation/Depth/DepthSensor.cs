using System;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// The errors of a time-of-flight camera: random noise that grows with the square of the distance, a slow systematic wave, holes
    /// at random and where near meets far. Immutable, no allocation.
    /// </summary>
    internal sealed unsafe class DepthSensor
    {
        private const int Step = 8;

        private readonly short[] _gaussian = CounterRandom.GaussianTable();
        private readonly float[] _sigma, _bias;
        private readonly float _near, _far;
        private readonly uint _holeBelow, _edgeBelow;

        public DepthSensor(DepthCameraSettings settings, DepthCameraGeometry geometry)
        {
            _near = (float)geometry.NearMm;
            _far = (float)geometry.FarMm;
            _sigma = new float[(int)_far / Step + 2];
            _bias = new float[_sigma.Length];
            for (int i = 0; i < _sigma.Length; i++)
            {
                double z = (i + 0.5) * Step;
                _sigma[i] = (float)(SigmaMm(settings, geometry, z) / 256);
                _bias[i] = (float)(settings.SystematicMm * Math.Sin(2 * Math.PI * z / 700));
            }

            _holeBelow = (uint)(settings.RandomHoleShare * 2048);
            _edgeBelow = (uint)(settings.EdgeHoleShare * 2048);
        }

        /// <summary>Standard deviation of the random error at a distance.</summary>
        public static double SigmaMm(DepthCameraSettings settings, DepthCameraGeometry geometry, double depthMm)
        {
            double part = Math.Max(0, Math.Min(1, (depthMm - geometry.NearMm) / (geometry.FarMm - geometry.NearMm)));
            return settings.NoiseNearMm + (settings.NoiseFarMm - settings.NoiseNearMm) * part * part;
        }

        /// <summary>True depth to what the camera says, one row; above the first row there is that row itself.</summary>
        public void MeasureRow(float* depth, float* above, int width, uint firstIndex, uint key, ushort* result)
        {
            fixed (short* gaussian = _gaussian)
            fixed (float* sigma = _sigma, bias = _bias)
            {
                float left = depth[0];
                for (int x = 0; x < width; x++)
                {
                    float z = depth[x], before = left;
                    left = z;
                    result[x] = 0;
                    if (!(z >= _near && z <= _far))
                        continue;
                    uint random = CounterRandom.Pixel(firstIndex + (uint)x, key);
                    float step = 30 + z * 0.02f;
                    bool edge = Math.Abs(z - Math.Abs(before)) > step || Math.Abs(z - Math.Abs(above[x])) > step;
                    if ((random & 2047) < (edge ? _edgeBelow : _holeBelow))
                        continue;
                    int i = (int)z / Step;
                    result[x] = (ushort)(z + sigma[i] * gaussian[random >> 22] + bias[i] + 0.5f);
                }
            }
        }
    }
}
