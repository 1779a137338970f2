namespace LaserTracking.Scoring
{
    /// <summary>Outline of a target's zone in the target's plane.</summary>
    public enum ZoneShape
    {
        /// <summary>Ellipse inscribed in the zone's size.</summary>
        Ellipse = 0,

        /// <summary>Rectangle of the zone's size.</summary>
        Rectangle = 1,

        /// <summary>Simple polygon given by its corners.</summary>
        Polygon = 2,
    }
}
