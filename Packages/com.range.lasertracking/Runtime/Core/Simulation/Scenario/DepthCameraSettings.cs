using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// Camera 1, a depth camera at the screen that looks back at the trainees, or wherever it is put: it sees the wall that the screen
    /// hangs on, too. Defaults: NFOV unbinned of an Azure Kinect with its
    /// published errors (random sd up to 17 mm, systematic below 11 mm).
    /// </summary>
    public sealed class DepthCameraSettings
    {
        /// <summary>Without it there is no depth stream and no camera 1 in the calibration.</summary>
        public bool Enabled { get; set; } = true;

        /// <summary>False: 640×576, range 0.5–3.86 m. True: 320×288 (2×2 binned), range 0.5–5.46 m.</summary>
        public bool Binned { get; set; }

        public double FramesPerSecond { get; set; } = 30;

        /// <summary>Mid-exposure of the first frame, µs after the beginning.</summary>
        public double StartUs { get; set; } = 9000;

        /// <summary>The device's clock minus true time at the beginning, µs.</summary>
        public double ClockOffsetUs { get; set; }

        /// <summary>How much faster the device's clock runs, parts per million.</summary>
        public double ClockDriftPpm { get; set; }

        /// <summary>Share of frames that never arrive.</summary>
        public double DroppedShare { get; set; }

        /// <summary>Random error at 0.5 m, sd in mm.</summary>
        public double NoiseNearMm { get; set; } = 1;

        /// <summary>Random error at the end of the range, sd in mm; grows with the square of the distance in between.</summary>
        public double NoiseFarMm { get; set; } = 17;

        /// <summary>Amplitude of the systematic error, a slow wave over distance, mm.</summary>
        public double SystematicMm { get; set; } = 5;

        /// <summary>Share of pixels without a value for no visible reason.</summary>
        public double RandomHoleShare { get; set; } = 0.004;

        /// <summary>Share of pixels without a value where near and far meet.</summary>
        public double EdgeHoleShare { get; set; } = 0.6;

        /// <summary>Share of a hand's pixels lost per m/s of its speed above 0.5 m/s.</summary>
        public double MotionHoleShare { get; set; } = 0.35;

        /// <summary>Share of frames in which a palm is lost altogether.</summary>
        public double LostPalmShare { get; set; } = 0.01;

        /// <summary>Optical centre in screen space, m; null: in the middle, at the screen's lower edge, 0.25 m before it.</summary>
        public Vector3D? PositionM { get; set; }

        /// <summary>A point on the optical axis in screen space, m; null: 1.3 m over the floor, 1.7 m before the screen.</summary>
        public Vector3D? LookAtM { get; set; }

        internal void Visit(ScenarioVisitor v)
        {
            Enabled = v.Flag("enabled", Enabled);
            Binned = v.Flag("binned", Binned);
            FramesPerSecond = v.Number("frames_per_second", FramesPerSecond, 1, 240);
            StartUs = v.Number("start_us", StartUs, 0, 1e6);
            ClockOffsetUs = v.Number("clock_offset_us", ClockOffsetUs, -1e12, 1e12);
            ClockDriftPpm = v.Number("clock_drift_ppm", ClockDriftPpm, -10000, 10000);
            DroppedShare = v.Number("dropped_share", DroppedShare, 0, 0.95);
            NoiseNearMm = v.Number("noise_near_mm", NoiseNearMm, 0, 200);
            NoiseFarMm = v.Number("noise_far_mm", NoiseFarMm, 0, 200);
            SystematicMm = v.Number("systematic_mm", SystematicMm, 0, 100);
            RandomHoleShare = v.Number("random_hole_share", RandomHoleShare, 0, 1);
            EdgeHoleShare = v.Number("edge_hole_share", EdgeHoleShare, 0, 1);
            MotionHoleShare = v.Number("motion_hole_share", MotionHoleShare, 0, 10);
            LostPalmShare = v.Number("lost_palm_share", LostPalmShare, 0, 1);
            PositionM = v.Point("position_m", PositionM, 100);
            LookAtM = v.Point("look_at_m", LookAtM, 100);
            if (PositionM is Vector3D from && LookAtM is Vector3D to && (to - from).Length < 0.01)
                v.Refuse("look_at_m", "is where the camera stands", "give a point before it");
        }
    }
}
