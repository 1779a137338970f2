using LaserTracking.Patterns;

namespace LaserTracking.Simulation
{
    /// <summary>The projector that draws the scene on the screen.</summary>
    public sealed class ProjectorSettings
    {
        /// <summary>Pixels of the drawn picture.</summary>
        public int Width { get; set; } = 1280;

        public int Height { get; set; } = 720;

        /// <summary>Light of a white picture; 1 = 2 W/m² on the screen (about 1000 lm on 2 m²).</summary>
        public double Brightness { get; set; } = 1;

        /// <summary>Light of a black picture as a share of white.</summary>
        public double BlackLevel { get; set; } = 0.002;

        /// <summary>Pictures drawn and shown per second.</summary>
        public double RefreshHz { get; set; } = 60;

        /// <summary>From drawing a picture to showing it, ms.</summary>
        public double DelayMs { get; set; } = 35;

        /// <summary>Linear light = (value / 255)^gamma.</summary>
        public double Gamma { get; set; } = 2.2;

        /// <summary>What lies behind the targets.</summary>
        public ProjectedContent Content { get; set; }

        /// <summary>How fast the shapes of moving content move, widths of the picture a second; the texture scrolls a third as fast.</summary>
        public double ContentSpeed { get; set; } = 0.94;

        /// <summary>How long each picture of the calibration is shown, ms.</summary>
        public double PatternHoldMs { get; set; } = 1000;

        internal void Visit(ScenarioVisitor v)
        {
            Width = v.Integer("width", Width, 16, 4096);
            Height = v.Integer("height", Height, 16, 4096);
            Brightness = v.Number("brightness", Brightness, 0, 100);
            BlackLevel = v.Number("black_level", BlackLevel, 0, 1);
            RefreshHz = v.Number("refresh_hz", RefreshHz, 1, 1000);
            DelayMs = v.Number("delay_ms", DelayMs, 0, 1000);
            Gamma = v.Number("gamma", Gamma, 1, 4);
            Content = v.Choice("content", Content);
            ContentSpeed = v.Number("content_speed", ContentSpeed, 0, 10);
            PatternHoldMs = v.Number("pattern_hold_ms", PatternHoldMs, 10, 60000);
            if (Content == ProjectedContent.Calibration && !ScreenPattern.CanDraw(Width, Height))
                v.Refuse("content", "does not fit the picture", "give a width of 160 or more and a height of 6/16 to 14/16 of it");
        }
    }
}
