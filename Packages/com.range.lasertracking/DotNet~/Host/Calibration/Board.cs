using LaserTracking.Geometry;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Calibration
{
    /// <summary>A flat board of squares: inner corners and the side of a square.</summary>
    internal readonly record struct Board(BoardSize Size, double SquareMm)
    {
        /// <summary>All corners in the order of the finder: row by row, columns fastest; the first one is the origin.</summary>
        public Vector2D[] CornersMm()
        {
            var corners = new Vector2D[Size.Count];
            for (int i = 0; i < corners.Length; i++)
                corners[i] = new Vector2D(i % Size.Columns, i / Size.Columns) * SquareMm;
            return corners;
        }
    }
}
