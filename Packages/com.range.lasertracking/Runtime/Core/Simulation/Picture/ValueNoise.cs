using System;

namespace LaserTracking.Simulation
{
    /// <summary>Smooth random texture over the plane, 0…1, the same for every session: surfaces do not change with the seed.</summary>
    internal static class ValueNoise
    {
        public static float At(double x, double y, int layer)
        {
            double fx = Math.Floor(x), fy = Math.Floor(y);
            double tx = x - fx, ty = y - fy;
            tx = tx * tx * (3 - 2 * tx);
            ty = ty * ty * (3 - 2 * ty);
            int ix = (int)fx, iy = (int)fy;
            double top = Corner(ix, iy, layer) * (1 - tx) + Corner(ix + 1, iy, layer) * tx;
            double bottom = Corner(ix, iy + 1, layer) * (1 - tx) + Corner(ix + 1, iy + 1, layer) * tx;
            return (float)(top * (1 - ty) + bottom * ty);
        }

        private static double Corner(int x, int y, int layer)
        {
            uint cell = unchecked((uint)x * 0x8DA6B343u ^ (uint)y * 0xD8163841u);
            return CounterRandom.Pixel(cell, (uint)layer * 0xCB1AB31Fu) * (1.0 / 4294967296.0);
        }
    }
}
