using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Simulation
{
    /// <summary>Camera 0, which looks at the screen. Defaults: 720p at 30 frames/s, one refresh of a 60 Hz projector exposed.</summary>
    public sealed class ColorCameraSettings
    {
        /// <summary>Pixels; even.</summary>
        public int Width { get; set; } = 1280;

        /// <summary>Pixels; even.</summary>
        public int Height { get; set; } = 720;

        public double FramesPerSecond { get; set; } = 30;

        /// <summary>How long each row gathers light, µs; no longer than the frame period.</summary>
        public double ExposureUs { get; set; } = 16670;

        /// <summary>Mid-exposure of the first frame, µs after the beginning.</summary>
        public double StartUs { get; set; } = 16667;

        /// <summary>Factor on the signal; at 1 and 16.67 ms, projected white of brightness 1 reaches 55 % of saturation.</summary>
        public double Gain { get; set; } = 1;

        /// <summary>Value = linear^(1/gamma), with a straight toe below 1 %.</summary>
        public double Gamma { get; set; } = 2.2;

        /// <summary>Standard deviation of the lens's point spread, px.</summary>
        public double BlurPx { get; set; } = 0.8;

        /// <summary>Electrons at saturation with gain 1: sets the shot noise.</summary>
        public double FullWellElectrons { get; set; } = 9000;

        public double ReadNoiseElectrons { get; set; } = 4;

        /// <summary>Share of the light lost in the corners.</summary>
        public double Vignetting { get; set; } = 0.15;

        /// <summary>Delay from one row to the next, µs; 0 = global shutter. Frame times are those of the middle row.</summary>
        public double RollingShutterRowUs { get; set; }

        /// <summary>Bgra32, Nv12 or Yuy2.</summary>
        public PixelFormat Format { get; set; } = PixelFormat.Bgra32;

        /// <summary>Pictures pass through JPEG of this quality (1…100), as from most webcams; 0 = they do not. Nv12 or Yuy2 only.</summary>
        public int JpegQuality { get; set; }

        /// <summary>The device's clock minus true time, µs.</summary>
        public double ClockOffsetUs { get; set; }

        /// <summary>Share of frames that never arrive.</summary>
        public double DroppedShare { get; set; }

        /// <summary>Optical centre in screen space, m (z negative); null: right of the middle, above, in proportion to the screen.</summary>
        public Vector3D? PositionM { get; set; }

        /// <summary>Point of the screen that the optical axis meets, m; null: its middle.</summary>
        public Vector2D? LookAtM { get; set; }

        /// <summary>Turn about the optical axis, degrees.</summary>
        public double RollDeg { get; set; } = 1.2;

        /// <summary>Horizontal field of view, degrees; 0: as much as shows the whole screen with a small margin.</summary>
        public double FieldOfViewDeg { get; set; }

        /// <summary>Radial distortion of the lens after Brown, in units of the focal length; below zero bulges outwards. 0: none.</summary>
        public double LensK1 { get; set; }

        public double LensK2 { get; set; }

        /// <summary>What automatic exposure does; none by default.</summary>
        public List<ExposureStepSettings> ExposureSteps { get; } = new List<ExposureStepSettings>();

        internal void Visit(ScenarioVisitor v)
        {
            Width = v.Integer("width", Width, 16, 4096);
            Height = v.Integer("height", Height, 16, 4096);
            FramesPerSecond = v.Number("frames_per_second", FramesPerSecond, 1, 1000);
            ExposureUs = v.Number("exposure_us", ExposureUs, 10, 1e6);
            StartUs = v.Number("start_us", StartUs, 0, 1e6);
            Gain = v.Number("gain", Gain, 0.01, 100);
            Gamma = v.Number("gamma", Gamma, 1, 4);
            BlurPx = v.Number("blur_px", BlurPx, 0, 6);
            FullWellElectrons = v.Number("full_well_electrons", FullWellElectrons, 100, 1e13);
            ReadNoiseElectrons = v.Number("read_noise_electrons", ReadNoiseElectrons, 0, 500);
            Vignetting = v.Number("vignetting", Vignetting, 0, 0.9);
            RollingShutterRowUs = v.Number("rolling_shutter_row_us", RollingShutterRowUs, 0, 100);
            Format = v.Choice("format", Format);
            JpegQuality = v.Integer("jpeg_quality", JpegQuality, 0, 100);
            ClockOffsetUs = v.Number("clock_offset_us", ClockOffsetUs, -1e12, 1e12);
            DroppedShare = v.Number("dropped_share", DroppedShare, 0, 0.95);
            PositionM = v.Point("position_m", PositionM, 100);
            LookAtM = v.Point("look_at_m", LookAtM, 100);
            RollDeg = v.Number("roll_deg", RollDeg, -180, 180);
            FieldOfViewDeg = v.Number("field_of_view_deg", FieldOfViewDeg, 0, 150);
            LensK1 = v.Number("lens_k1", LensK1, -1, 1);
            LensK2 = v.Number("lens_k2", LensK2, -1, 1);
            v.List("exposure_steps", ExposureSteps, () => new ExposureStepSettings(), (step, inner) => step.Visit(inner));
            if (Width % 2 != 0)
                v.Refuse("width", "is odd", "give an even number");
            if (Height % 2 != 0)
                v.Refuse("height", "is odd", "give an even number");
            if (ExposureUs > 1e6 / FramesPerSecond)
                v.Refuse("exposure_us", "is longer than a frame", "give at most 1000000 / frames_per_second");
            if (Format != PixelFormat.Bgra32 && Format != PixelFormat.Nv12 && Format != PixelFormat.Yuy2)
                v.Refuse("format", "is no colour format", "give one of bgra32, nv12, yuy2");
            if (JpegQuality > 0 && Format == PixelFormat.Bgra32)
                v.Refuse("jpeg_quality", "needs a YUV format", "set format to nv12 or yuy2");
            if (PositionM is Vector3D position && position.Z > -0.2)
                v.Refuse("position_m", "is not in front of the screen", "give a third number below -0.2");
        }
    }
}
