using System;
using System.Runtime.CompilerServices;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Hands
{
    /// <summary>
    /// The end of a weapon's bore out of all pixels that show its front part. Cells of the grid are half as wide as a slide, and by half a
    /// slide over an arm's length one line of fire differs from another. Bounded work, no allocation.
    /// </summary>
    internal static unsafe class WeaponTip
    {
        /// <summary>What is looked at about the end as the cells show it: before, behind and beside it.</summary>
        private const double BeforeMm = 30;
        private const double BehindMm = 80;
        private const double BesideMm = 34;

        /// <summary>How much of the weapon counts, from its front: the fist begins 60 to 80 mm behind it.</summary>
        private const double LengthMm = 50;

        /// <summary>Half the depth of the layer that counts as the front face: twice the sensor's noise at 2 m.</summary>
        private const double LayerMm = 9;

        /// <summary>From a slide's visible side to its middle.</summary>
        private const double RadiusMm = 16;

        /// <summary>How far before the end something may hide the rest of a weapon, and how much nearer that is.</summary>
        private const double CoverMm = 80;
        private const double CoverStepMm = 8;
        private const double NearerMm = 60;

        private const double BinMm = 4;
        private const int Bins = (int)((BeforeMm + BehindMm) / BinMm) + 1;

        /// <summary>Pixels at the front that are no stray ones.</summary>
        private const int FrontPixels = 8;
        private const int MinPixels = 6;

        private const int MaxReachPx = 48;

        /// <summary>How far behind the end slide and fist reach, from their visible side to their middle, and pixels that are enough of them.</summary>
        private const double RearMm = 110;
        private const double RearRadiusMm = 20;
        private const int MinRearPixels = 40;

        /// <summary>The last two keep the axis.</summary>
        private const int Passes = 4;

        /// <summary>
        /// A weapon that lies so far off the axis given is not its person's: arms that cross are given to the wrong eyes, 0.4 rad and more off. One
        /// frame measures it to 0.1.
        /// </summary>
        private const double TurnedRad = 0.3;

        /// <summary>Holds back the slope of few pixels: as much spread as 10 mm along the axis give.</summary>
        private const double SlopePriorMm2 = 100;

        /// <summary>Moves the end to the middle of the front; false, with the end as it was, where too little is seen.</summary>
        /// <param name="grid">Of the picture.</param>
        /// <param name="axis">Unit vector along the weapon, to its front, as known: where what is seen clearly lies along another, that is followed.</param>
        /// <param name="endMm">The end as known so far.</param>
        /// <param name="spreadMm">Root mean square distance from the bore of what is seen: 10 to 16 of a weapon, above 20 of a fist.</param>
        public static bool TryRefine(DepthGrid grid, Vector3D axis, ref Vector3D endMm, out double spreadMm)
        {
            spreadMm = double.MaxValue;
            PinholeCamera view = grid.View;
            if (!(grid.Source is Image depth) || !view.TryProject(endMm, out Vector2D px))
                return false;
            int reach = Math.Min(MaxReachPx, (int)Math.Ceiling((BesideMm + BehindMm / 2) / endMm.Z * view.FocalXPx));
            int cx = (int)Math.Round(px.X), cy = (int)Math.Round(px.Y);
            int left = Math.Max(0, cx - reach), right = Math.Min(depth.Width - 1, cx + reach);
            int top = Math.Max(0, cy - reach), bottom = Math.Min(depth.Height - 1, cy + reach);
            double* raysX = stackalloc double[2 * MaxReachPx + 1], raysY = stackalloc double[2 * MaxReachPx + 1];
            for (int x = left; x <= right; x++)
                raysX[x - left] = view.Unproject(x, 0, 1).X;
            for (int y = top; y <= bottom; y++)
                raysY[y - top] = view.Unproject(0, y, 1).Y;
            int* bins = stackalloc int[Bins];
            for (int i = 0; i < Bins; i++)
                bins[i] = 0;
            for (int y = top; y <= bottom; y++)
            {
                var row = (ushort*)(depth.Pixels + (long)y * depth.Stride);
                for (int x = left; x <= right; x++)
                {
                    if (IsOn(raysX[x - left], raysY[y - top], row[x], endMm, axis, out _, out double s))
                        bins[(int)((BeforeMm - s) / BinMm)]++;
                }
            }

            int first = 0, passed = bins[0];
            while (passed < FrontPixels && first < Bins - 1)
                passed += bins[++first];
            double front = BeforeMm - (first + 0.5) * BinMm;
            Vector3D ray = endMm.Normalized, middle = endMm;
            for (int pass = 0; pass < Passes; pass++)
            {
                Vector3D inside = (ray - axis * Vector3D.Dot(ray, axis)).Normalized * RadiusMm;
                Vector3D sum = default, sideSum = default, turning = default;
                double frontSum = 0, squares = 0, alongSum = 0, alongSquares = 0;
                int count = 0, frontCount = 0;
                double moved = Vector3D.Dot(middle - endMm, axis);
                for (int y = top; y <= bottom; y++)
                {
                    var row = (ushort*)(depth.Pixels + (long)y * depth.Stride);
                    for (int x = left; x <= right; x++)
                    {
                        if (!IsOn(raysX[x - left], raysY[y - top], row[x], middle, axis, out Vector3D point, out double s))
                            continue;
                        s += moved;
                        double before = s - front;
                        if (before > LayerMm || before < -LengthMm)
                            continue;
                        bool isFront = before > -LayerMm;
                        sum += isFront ? point : point + inside;
                        count++;
                        Vector3D d = point - middle;
                        double along = Vector3D.Dot(d, axis);
                        squares += d.LengthSquared - along * along;
                        if (isFront)
                        {
                            frontSum += s;
                            frontCount++;
                            continue;
                        }

                        sideSum += d;
                        turning += d * along;
                        alongSum += along;
                        alongSquares += along * along;
                    }
                }

                if (frontCount < MinPixels)
                    return false;
                front = frontSum / frontCount;
                spreadMm = Math.Sqrt(squares / count);
                middle = sum * (1.0 / count);
                int sides = count - frontCount;
                if (pass < Passes - 2 && sides > MinPixels)
                {
                    double length = alongSquares - alongSum * alongSum / sides;
                    Vector3D slope = (turning - sideSum * (alongSum / sides)) * (1 / (length + SlopePriorMm2 * sides));
                    slope -= axis * Vector3D.Dot(slope, axis);
                    if (slope.LengthSquared > TurnedRad * TurnedRad)
                    {
                        Vector3D end = middle + axis * (front - Vector3D.Dot(middle - endMm, axis));
                        axis = (axis + slope).Normalized;
                        front = Vector3D.Dot(end - endMm, axis);
                    }
                }

                middle += axis * (front - Vector3D.Dot(middle - endMm, axis));
            }

            endMm = middle;
            return true;
        }

        /// <summary>
        /// Along which line a weapon lies, from what is seen behind its end whatever line that is: slide and fist. Unit vector to the front, zero
        /// where too little is seen. The grip hangs below the bore, so it tells the bearing, not the height.
        /// </summary>
        public static Vector3D Direction(DepthGrid grid, Vector3D endMm)
        {
            PinholeCamera view = grid.View;
            if (!(grid.Source is Image depth) || !view.TryProject(endMm, out Vector2D px))
                return default;
            int reach = Math.Min(MaxReachPx, (int)Math.Ceiling(RearMm / endMm.Z * view.FocalXPx));
            int cx = (int)Math.Round(px.X), cy = (int)Math.Round(px.Y);
            int left = Math.Max(0, cx - reach), right = Math.Min(depth.Width - 1, cx + reach);
            int top = Math.Max(0, cy - reach), bottom = Math.Min(depth.Height - 1, cy + reach);
            Vector3D sum = default;
            int count = 0;
            for (int y = top; y <= bottom; y++)
            {
                var row = (ushort*)(depth.Pixels + (long)y * depth.Stride);
                for (int x = left; x <= right; x++)
                {
                    if (Math.Abs(row[x] - endMm.Z) > RearMm)
                        continue;
                    Vector3D d = view.Unproject(x, y, row[x]) - endMm;
                    double square = d.LengthSquared;
                    if (square > RearMm * RearMm || square < LengthMm * LengthMm)
                        continue;
                    sum += d;
                    count++;
                }
            }

            if (count < MinRearPixels)
                return default;
            // What is seen is the side towards the camera.
            Vector3D middle = sum * (1.0 / count), ray = endMm.Normalized, axis = middle.Normalized;
            for (int pass = 0; pass < 3; pass++)
                axis = (middle + (ray - axis * Vector3D.Dot(ray, axis)) * RearRadiusMm).Normalized;
            return -axis;
        }

        /// <summary>
        /// Something nearer stands before where a weapon would go on: what is seen ends there because it is hidden, as a forearm behind somebody else's body.
        /// </summary>
        public static bool IsCovered(DepthGrid grid, Vector3D axis, Vector3D endMm)
        {
            PinholeCamera view = grid.View;
            if (!(grid.Source is Image depth))
                return false;
            int covered = 0, looked = 0;
            for (double ahead = CoverStepMm; ahead <= CoverMm; ahead += CoverStepMm)
            {
                Vector3D at = endMm + axis * ahead;
                if (!view.TryProject(at, out Vector2D px))
                    continue;
                int x = (int)Math.Round(px.X), y = (int)Math.Round(px.Y);
                if (x < 0 || y < 0 || x >= depth.Width || y >= depth.Height)
                    continue;
                int z = ((ushort*)(depth.Pixels + (long)y * depth.Stride))[x];
                looked++;
                if (z > 0 && z < at.Z - NearerMm)
                    covered++;
            }

            return 3 * covered > looked;
        }

        /// <param name="rayX">x/z of the pixel's ray.</param>
        /// <param name="rayY">y/z of it.</param>
        /// <param name="z">Its depth, mm.</param>
        /// <param name="end">Of the weapon.</param>
        /// <param name="axis">Of the weapon.</param>
        /// <param name="point">What the pixel shows.</param>
        /// <param name="s">Where that is along the axis, from the end.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static bool IsOn(double rayX, double rayY, int z, Vector3D end, Vector3D axis, out Vector3D point, out double s)
        {
            point = default;
            s = 0;
            if (Math.Abs(z - end.Z) > BehindMm + BesideMm)
                return false;
            point = new Vector3D(rayX * z, rayY * z, z);
            Vector3D d = point - end;
            s = Vector3D.Dot(d, axis);
            return s < BeforeMm && s > -BehindMm && d.LengthSquared - s * s < BesideMm * BesideMm;
        }
    }
}
