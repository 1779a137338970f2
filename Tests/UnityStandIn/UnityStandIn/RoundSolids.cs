// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>Where a ray enters solids around the origin. Never from within.</summary>
    internal static class RoundSolids
    {
        public static bool TryEnterSphere(Vector3 from, Vector3 along, double radius, out double distance)
        {
            double b = (double)from.x * along.x + (double)from.y * along.y + (double)from.z * along.z;
            double c = (double)from.x * from.x + (double)from.y * from.y + (double)from.z * from.z - radius * radius;
            double root = b * b - c;
            distance = root < 0 ? 0 : -b - Math.Sqrt(root);
            return root >= 0 && c > 0 && distance >= 0;
        }

        /// <param name="from">Origin of the ray.</param>
        /// <param name="along">Unit direction.</param>
        /// <param name="axis">0 = x, 1 = y, 2 = z.</param>
        /// <param name="half">Half the length of the cylinder between the caps.</param>
        /// <param name="radius">Of cylinder and caps.</param>
        /// <param name="distance">To the entry.</param>
        public static bool TryEnterCapsule(Vector3 from, Vector3 along, int axis, double half, double radius, out double distance)
        {
            distance = double.PositiveInfinity;
            int u = (axis + 1) % 3, v = (axis + 2) % 3;
            double onAxis = Math.Max(-half, Math.Min(half, from[axis]));
            double up = from[axis] - onAxis;
            if ((double)from[u] * from[u] + (double)from[v] * from[v] + up * up <= radius * radius)
                return false;

            double a = (double)along[u] * along[u] + (double)along[v] * along[v];
            double b = (double)from[u] * along[u] + (double)from[v] * along[v];
            double c = (double)from[u] * from[u] + (double)from[v] * from[v] - radius * radius;
            double root = b * b - a * c;
            if (a > 0 && root >= 0)
            {
                double t = (-b - Math.Sqrt(root)) / a;
                if (t >= 0 && Math.Abs(from[axis] + along[axis] * t) <= half)
                    distance = t;
            }

            for (int side = -1; side <= 1; side += 2)
            {
                Vector3 shifted = from;
                shifted[axis] -= (float)(side * half);
                if (TryEnterSphere(shifted, along, radius, out double t))
                    distance = Math.Min(distance, t);
            }

            return !double.IsInfinity(distance);
        }
    }
}
