using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Health
{
    /// <summary>
    /// Lists of brightness across the edges of the screen, from a little inside to well outside, each summed along a piece of the edge;
    /// as slopes. Everything brighter than the surroundings by more than a little counts as that little: whatever is projected, the edge
    /// of its light looks the same, and what moves inside it does not show. One bin is a pixel of a picture 640 wide.
    /// </summary>
    internal sealed unsafe class EdgeProfiles
    {
        public const int Probes = 40;

        /// <summary>Largest displacement looked for, bins.</summary>
        public const int Reach = 16;

        private const int Inside = Reach + 3, Outside = Reach + 7, Length = Inside + Outside, Lines = 16;

        private const int LeastUsable = 16;

        /// <summary>Levels above the surroundings that count at most.</summary>
        private const int Ceiling = 24;

        /// <summary>Where the surroundings are read, bins outside the edge.</summary>
        private const int NearEdge = 3, FarEdge = 6;

        /// <summary>Mean square slope of a list worth matching.</summary>
        private const long LeastSlope = 900;

        private readonly int[] _sums = new int[Length];
        private readonly int[] _ceilings = new int[Probes];
        private readonly bool[] _isInPicture = new bool[Probes];
        private readonly Vector2D[] _along = new Vector2D[Probes];

        public EdgeProfiles()
        {
            for (int i = 0; i < Probes; i++)
            {
                Slopes[i] = new int[Length];
                Reference[i] = new int[Length];
            }
        }

        /// <summary>Slopes by probe, outwards.</summary>
        public int[][] Slopes { get; } = new int[Probes][];

        /// <summary>Those to compare with.</summary>
        public int[][] Reference { get; } = new int[Probes][];

        /// <summary>Where a probe crosses the edge, px.</summary>
        public Vector2D[] Places { get; } = new Vector2D[Probes];

        /// <summary>Unit vector of a probe, outwards.</summary>
        public Vector2D[] Normals { get; } = new Vector2D[Probes];

        /// <summary>Pixels of the picture in a bin.</summary>
        public int BinPx { get; private set; } = 1;

        /// <summary>Lays the probes across a convex outline at equal distances; false when too few of them lie in the picture.</summary>
        public bool TryLay(Vector2D[] outlinePx, int width, int height)
        {
            BinPx = Math.Max(1, width / 640);
            double perimeter = 0;
            Vector2D middle = default;
            for (int i = 0; i < outlinePx.Length; i++)
            {
                perimeter += (outlinePx[(i + 1) % outlinePx.Length] - outlinePx[i]).Length;
                middle += outlinePx[i] * (1.0 / outlinePx.Length);
            }

            int usable = 0;
            double half = Lines / 2.0 * BinPx;
            for (int i = 0; i < Probes; i++)
            {
                double at = perimeter * (i + 0.5) / Probes;
                Vector2D before = Walk(outlinePx, at - half + perimeter), after = Walk(outlinePx, at + half);
                Places[i] = Walk(outlinePx, at);
                _along[i] = (after - before) * (1 / Math.Max(1e-9, (after - before).Length));
                var normal = new Vector2D(_along[i].Y, -_along[i].X);
                Normals[i] = Vector2D.Dot(normal, Places[i] - middle) < 0 ? normal * -1 : normal;

                // Around a corner there is no single edge.
                bool isStraight = ((before + after) * 0.5 - Places[i]).Length < BinPx;
                _isInPicture[i] = isStraight && IsInside(Places[i], i, -Inside, width, height) && IsInside(Places[i], i, Outside, width, height);
                usable += _isInPicture[i] ? 1 : 0;
            }

            return usable >= LeastUsable;
        }

        private static Vector2D Walk(Vector2D[] outline, double distance)
        {
            for (int i = 0; ; i = (i + 1) % outline.Length)
            {
                Vector2D way = outline[(i + 1) % outline.Length] - outline[i];
                double length = way.Length;
                if (distance < length || !(length >= 0))
                    return outline[i] + way * (distance / length);
                distance -= length;
            }
        }

        /// <summary>Reads one probe; false when it leaves the picture.</summary>
        /// <param name="image">The picture.</param>
        /// <param name="probe">Which.</param>
        /// <param name="isReference">What is there now is what to compare with from now on.</param>
        /// <param name="offset">How far from its place it is read, bins.</param>
        public bool TryFill(Image image, int probe, bool isReference, Vector2D offset)
        {
            Vector2D place = Places[probe] + offset * BinPx;
            if (!_isInPicture[probe] || !IsInside(place, probe, -Inside, image.Width, image.Height) || !IsInside(place, probe, Outside, image.Width, image.Height))
                return false;
            if (isReference)
                _ceilings[probe] = Surroundings(image, probe) + Ceiling;
            int step = image.Format == PixelFormat.Bgra32 ? 4 : image.Format == PixelFormat.Yuy2 ? 2 : 1;
            byte* first = image.Pixels + (step == 4 ? 1 : 0);
            Vector2D right = _along[probe] * BinPx, out1 = Normals[probe] * BinPx;
            int ceiling = _ceilings[probe];
            for (int i = 0; i < Length; i++)
            {
                Vector2D p = place + out1 * (i - Inside) - right * ((Lines - 1) / 2.0);
                int sum = 0;
                for (int line = 0; line < Lines; line++, p += right)
                    sum += Math.Min(ceiling, (int)first[(long)(p.Y + 0.5) * image.Stride + (long)(p.X + 0.5) * step]);
                _sums[i] = sum;
            }

            int[] slopes = isReference ? Reference[probe] : Slopes[probe];
            for (int i = 1; i < Length - 1; i++)
                slopes[i] = _sums[i + 1] - _sums[i - 1];
            return true;
        }

        /// <summary>The probe's reference shows an edge.</summary>
        public bool IsWorth(int probe) => _isInPicture[probe] && SlopeMatch.IsWorth(Reference[probe], Reach, LeastSlope);

        /// <summary>Displacement outwards of a probe filled now against its reference, bins.</summary>
        public bool TryMatch(int probe, out double shift) => SlopeMatch.TryFind(Slopes[probe], Reference[probe], Reach, LeastSlope, out shift);

        private int Surroundings(Image image, int probe)
        {
            int step = image.Format == PixelFormat.Bgra32 ? 4 : image.Format == PixelFormat.Yuy2 ? 2 : 1, sum = 0, count = 0;
            byte* first = image.Pixels + (step == 4 ? 1 : 0);
            Vector2D right = _along[probe] * BinPx;
            for (int bin = NearEdge; bin <= FarEdge; bin++)
            {
                Vector2D p = Places[probe] + Normals[probe] * (bin * BinPx) - right * ((Lines - 1) / 2.0);
                for (int line = 0; line < Lines; line++, p += right, count++)
                    sum += first[(long)(p.Y + 0.5) * image.Stride + (long)(p.X + 0.5) * step];
            }

            return sum / count;
        }

        private bool IsInside(Vector2D place, int probe, int bin, int width, int height)
        {
            double half = Lines / 2.0 * BinPx;
            Vector2D p = place + Normals[probe] * (bin * BinPx), a = p + _along[probe] * half, b = p - _along[probe] * half;
            return Math.Min(a.X, b.X) >= 0 && Math.Min(a.Y, b.Y) >= 0 && Math.Max(a.X, b.X) <= width - 1 && Math.Max(a.Y, b.Y) <= height - 1;
        }
    }
}
