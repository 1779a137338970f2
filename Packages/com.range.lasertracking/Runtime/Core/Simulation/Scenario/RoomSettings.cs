using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>Light and walls of the room.</summary>
    public sealed class RoomSettings
    {
        /// <summary>Ambient light on the screen as a share of projected white of brightness 1.</summary>
        public double Ambient { get; set; } = 0.03;

        /// <summary>Relative swing of the ambient light at <see cref="FlickerHz"/>.</summary>
        public double FlickerDepth { get; set; }

        /// <summary>Twice the mains frequency: 100 or 120.</summary>
        public double FlickerHz { get; set; } = 100;

        /// <summary>From the screen's lower edge to the floor, m.</summary>
        public double FloorBelowScreenM { get; set; } = 0.5;

        /// <summary>From the screen to the wall behind the trainees, m.</summary>
        public double BackWallM { get; set; } = 3.2;

        /// <summary>From the floor to the ceiling, m.</summary>
        public double CeilingM { get; set; } = 2.7;

        /// <summary>What a lamp that shines on a part of the wall adds at its brightest, in the unit of <see cref="Ambient"/>.</summary>
        public double Lamp { get; set; }

        /// <summary>Where it shines, in screen space.</summary>
        public Vector2D LampM { get; set; }

        /// <summary>People between camera 0 and the screen, the nearest last; none by default.</summary>
        public List<ObstacleSettings> Obstacles { get; } = new List<ObstacleSettings>();

        internal void Visit(ScenarioVisitor v)
        {
            Ambient = v.Number("ambient", Ambient, 0, 100);
            FlickerDepth = v.Number("flicker_depth", FlickerDepth, 0, 1);
            FlickerHz = v.Number("flicker_hz", FlickerHz, 1, 1000);
            FloorBelowScreenM = v.Number("floor_below_screen_m", FloorBelowScreenM, -2, 5);
            BackWallM = v.Number("back_wall_m", BackWallM, 0.5, 50);
            CeilingM = v.Number("ceiling_m", CeilingM, 1, 50);
            Lamp = v.Number("lamp", Lamp, 0, 100);
            LampM = v.Point("lamp_m", LampM, 100) ?? default;
            v.List("obstacles", Obstacles, () => new ObstacleSettings(), (obstacle, inner) => obstacle.Visit(inner));
        }
    }
}
