using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// A place where two dark and two light sectors meet alternately, as at a checkerboard's inner corner. Going clockwise in the
    /// picture, the sector from <see cref="EdgeA"/> to <see cref="EdgeB"/> is dark; from a corner to the next along an edge the two
    /// edges change roles.
    /// </summary>
    public readonly struct SaddlePoint
    {
        public SaddlePoint(Vector2D positionPx, Vector2D edgeA, Vector2D edgeB, double contrast, double quality)
        {
            PositionPx = positionPx;
            EdgeA = edgeA;
            EdgeB = edgeB;
            Contrast = contrast;
            Quality = quality;
        }

        /// <summary>Stationary point of the smoothed picture, in pixels; some tenths of a pixel. <see cref="SaddlePointRefiner"/> does better.</summary>
        public Vector2D PositionPx { get; }

        /// <summary>Unit vector along the edge behind which, clockwise, it is dark. The opposite direction is the same edge.</summary>
        public Vector2D EdgeA { get; }

        /// <summary>Unit vector along the other edge, less than half a turn clockwise of <see cref="EdgeA"/>.</summary>
        public Vector2D EdgeB { get; }

        /// <summary>Light sectors minus dark sectors, smoothed, in grey levels of 255.</summary>
        public double Contrast { get; }

        /// <summary>
        /// Share of the brightness pattern around that half a turn leaves as it is: near 1 at a corner of a checkerboard, 1/3 at the
        /// corner of a lone square, 0 at an edge.
        /// </summary>
        public double Quality { get; }
    }
}
