using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>One of nine parts of the screen and what is known about the calibration there.</summary>
    public sealed class ScreenRegion
    {
        public const int Across = 3, Down = 3, Count = Across * Down;

        private static readonly string[] Names = { "top left", "top middle", "top right", "middle left", "middle", "middle right", "bottom left", "bottom middle", "bottom right" };

        internal ScreenRegion(int index) => Name = Names[index];

        /// <summary>Of all parts, row by row.</summary>
        public static System.Collections.Generic.IReadOnlyList<string> AllNames => Names;

        /// <summary>For people: "top left".</summary>
        public string Name { get; }

        /// <summary>Points of both boards that were projected there.</summary>
        public int Projected { get; internal set; }

        public int Measured { get; internal set; }

        public int Covered { get; internal set; }

        public int OutOfPicture { get; internal set; }

        public int Unclear { get; internal set; }

        /// <summary>Measured points that do not lie on the screen's plane, or not on the screen at all.</summary>
        public int LeftOut { get; internal set; }

        /// <summary>Of its held-out points; none: nothing is proven there.</summary>
        public PointErrors HeldOutPx { get; internal set; }

        /// <summary>The same on the screen, mm.</summary>
        public PointErrors HeldOutMm { get; internal set; }

        /// <summary>Median blur of its points, px.</summary>
        public double BlurPx { get; internal set; }

        /// <summary>Standard deviation of the calibration itself in its middle, mm, as far as the fit's own noise goes.</summary>
        public double SigmaMm { get; internal set; }

        /// <summary>The part that holds a place, given as shares of the picture.</summary>
        public static int IndexOf(Vector2D place)
        {
            int column = place.X < 1 / 3.0 ? 0 : place.X < 2 / 3.0 ? 1 : 2, row = place.Y < 1 / 3.0 ? 0 : place.Y < 2 / 3.0 ? 1 : 2;
            return row * Across + column;
        }
    }
}
