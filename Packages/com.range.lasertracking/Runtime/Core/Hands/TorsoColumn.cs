namespace LaserTracking.Hands
{
    /// <summary>A column of space, as wide as a hand: what one surface shows in it, and all torsos of a frame.</summary>
    internal struct TorsoColumn
    {
        /// <summary>Of the surface's cells, weighted by area: sum of weights, of y and of z, and the body's line through them.</summary>
        public double Weight;
        public double Y;
        public double Z;
        public double Line;

        /// <summary>How much of the surface lies within a shoulder's width.</summary>
        public long Around;

        /// <summary>Distance of the surface's body, slope taken off.</summary>
        public float BodyMm;

        /// <summary>The highest that is seen of a person; <see cref="float.MaxValue"/>: nothing.</summary>
        public float Top;

        /// <summary>Of all torsos of the frame: sum of weights, and of z.</summary>
        public double TorsoWeight;
        public double TorsoZ;
    }
}
