using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>Somebody who stands between camera 0 and the screen: a body with rounded shoulders and a head on it.</summary>
    public sealed class ObstacleSettings
    {
        /// <summary>Top of the head as camera 0 sees it against the screen, m; the body reaches down from there.</summary>
        public Vector2D TopM { get; set; }

        /// <summary>Width of the shoulders against the screen, m.</summary>
        public double WidthM { get; set; } = 0.5;

        /// <summary>Share of the light that clothes and skin throw back, of a white screen's.</summary>
        public double Reflectance { get; set; } = 0.3;

        /// <summary>The projected picture lies this far aside on them, m: camera and projector see them from different places.</summary>
        public Vector2D ParallaxM { get; set; } = new Vector2D(0.25, 0.1);

        internal void Visit(ScenarioVisitor v)
        {
            TopM = v.Point("top_m", TopM, 100) ?? default;
            WidthM = v.Number("width_m", WidthM, 0.01, 20);
            Reflectance = v.Number("reflectance", Reflectance, 0, 1);
            ParallaxM = v.Point("parallax_m", ParallaxM, 10) ?? default;
        }

        /// <summary>Whether a point of the screen is hidden behind them.</summary>
        internal bool Hides(Vector2D screenM)
        {
            double x = screenM.X - TopM.X, y = screenM.Y - TopM.Y, half = WidthM / 2, head = 0.28 * WidthM, neck = 2.5 * head;
            double headX = x / head, headY = (y - 1.25 * head) / (1.25 * head);
            if (headX * headX + headY * headY < 1)
                return true;
            double shoulder = System.Math.Max(0, neck + half - y) / half;
            return y > neck && System.Math.Abs(x) < half * System.Math.Sqrt(System.Math.Max(0, 1 - shoulder * shoulder));
        }
    }
}
