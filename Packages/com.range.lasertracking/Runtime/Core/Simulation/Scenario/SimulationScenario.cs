using System.Collections.Generic;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// Everything that a simulated session depends on besides the scene: two cameras, projector, room, shooters and their shots.
    /// Equal scenarios give equal bytes. Ranges stand in each Visit method and are checked when a range is built or a file is read.
    /// </summary>
    public sealed class SimulationScenario
    {
        /// <summary>For people.</summary>
        public string Name { get; set; } = "simulation";

        /// <summary>Key of every random choice; 0…2³¹−1.</summary>
        public int Seed { get; set; } = 1;

        /// <summary>Length in seconds.</summary>
        public double DurationS { get; set; } = 10;

        public ColorCameraSettings ColorCamera { get; } = new ColorCameraSettings();

        public InfraredCameraSettings InfraredCamera { get; } = new InfraredCameraSettings();

        public DepthCameraSettings DepthCamera { get; } = new DepthCameraSettings();

        public ProjectorSettings Projector { get; } = new ProjectorSettings();

        public RoomSettings Room { get; } = new RoomSettings();

        /// <summary>Shooter number 1 is the first. Shots name them by number.</summary>
        public List<ShooterSettings> Shooters { get; } = new List<ShooterSettings>();

        /// <summary>Shots given one by one.</summary>
        public List<ShotSettings> Shots { get; } = new List<ShotSettings>();

        /// <summary>Shots drawn at random in addition; none by default.</summary>
        public ShotGeneratorSettings Generator { get; } = new ShotGeneratorSettings();

        /// <summary>Bumps of camera 0.</summary>
        public List<NudgeSettings> Nudges { get; } = new List<NudgeSettings>();

        /// <exception cref="System.ArgumentException">A value is out of its range; the message names it.</exception>
        public void Validate() => Visit(new ScenarioChecker());

        internal void Visit(ScenarioVisitor v)
        {
            Name = v.Text("name", Name);
            Seed = v.Integer("seed", Seed, 0, int.MaxValue);
            DurationS = v.Number("duration_s", DurationS, 0.1, 36000);
            v.Group("color_camera", ColorCamera.Visit);
            v.Group("infrared_camera", InfraredCamera.Visit);
            v.Group("depth_camera", DepthCamera.Visit);
            v.Group("projector", Projector.Visit);
            v.Group("room", Room.Visit);
            v.List("nudges", Nudges, () => new NudgeSettings(), (nudge, inner) => nudge.Visit(inner));
            v.List("shooters", Shooters, () => new ShooterSettings(), (shooter, inner) => shooter.Visit(inner));
            v.List("shots", Shots, () => new ShotSettings(), (shot, inner) => VisitShot(shot, inner));
            v.Group("generator", Generator.Visit);
            if (InfraredCamera.Enabled && (ColorCamera.LensK1 != 0 || ColorCamera.LensK2 != 0))
                v.Refuse("infrared_camera", "cannot be simulated with a lens", "set lens_k1 and lens_k2 of color_camera to 0");
        }

        private void VisitShot(ShotSettings shot, ScenarioVisitor v)
        {
            shot.Visit(v);
            if (shot.Shooter > Shooters.Count)
                v.Refuse("shooter", "is " + shot.Shooter, "give the number of a shooter, 1 to " + Shooters.Count);
            if (shot.TimeS >= DurationS)
                v.Refuse("time_s", "lies after the end", "give a time below duration_s");
            foreach (ShotSettings other in Shots)
            {
                if (ReferenceEquals(other, shot))
                    break;
                if (other.Shooter == shot.Shooter && shot.TimeS < other.EndS && other.TimeS < shot.EndS)
                    v.Refuse("time_s", "falls into an earlier shot of the same shooter", "leave the first pulse time to end");
            }
        }
    }
}
