using System;

namespace LaserTracking.Geometry
{
    /// <summary>Directions in a picture in words.</summary>
    public static class Compass
    {
        private static readonly string[] Words = { "right", "right and down", "down", "left and down", "left", "left and up", "up", "right and up" };

        /// <summary>The nearest of eight: "right", "right and down", …; y runs down.</summary>
        public static string Of(Vector2D direction) => Words[(int)Math.Round(Math.Atan2(direction.Y, direction.X) / (Math.PI / 4)) + 8 & 7];
    }
}
