using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Scoring;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// A range that exists only as numbers: two cameras' frames, the exact calibration and the truth. Equal scenarios and scenes give
    /// equal bytes whatever the order or the threads in which sources are read; every source may run on a thread of its own.
    /// </summary>
    public sealed class SimulatedRange
    {
        private readonly SimulationScenario _scenario;
        private readonly List<PlannedShot> _plan;
        private readonly ShooterMotion[] _motions;
        private readonly ColorCameraGeometry _colorGeometry;
        private readonly LightSampler _light;
        private readonly LaserOptics _optics;
        private readonly FrameTiming _depthTiming;
        private readonly PictureAssets _assets;
        private readonly DepthCameraGeometry? _depthGeometry;
        private readonly ColorCameraGeometry? _infraredGeometry;

        /// <param name="scenario">Must not be changed afterwards.</param>
        /// <param name="scene">What the projector shows.</param>
        /// <exception cref="ArgumentException">A setting is out of its range.</exception>
        /// <exception cref="InputException">A shot names a target that the scene does not have.</exception>
        public SimulatedRange(SimulationScenario scenario, SceneModel scene)
        {
            scenario.Validate();
            _scenario = scenario;
            Scene = scene;
            var view = new SceneView(scene);
            _plan = ShotPlanner.Plan(scenario, view);
            _motions = new ShooterMotion[scenario.Shooters.Count];
            for (int i = 0; i < _motions.Length; i++)
                _motions[i] = BuildMotion(view, i);

            ColorCameraSettings color = scenario.ColorCamera;
            _colorGeometry = new ColorCameraGeometry(color, scene.ScreenSizeM);
            var colorTiming = new FrameTiming(color.StartUs, color.FramesPerSecond, scenario.DurationS, color.DroppedShare,
                color.ClockOffsetUs, 0, scenario.Seed, RandomStream.ColorDrop);
            DepthCameraSettings depth = scenario.DepthCamera;
            _depthTiming = new FrameTiming(depth.StartUs, depth.FramesPerSecond, depth.Enabled ? scenario.DurationS : 0, depth.DroppedShare,
                depth.ClockOffsetUs, depth.ClockDriftPpm, scenario.Seed, RandomStream.DepthDrop);
            _light = new LightSampler(scenario, _colorGeometry, _motions, colorTiming);
            _optics = new LaserOptics(scenario, _colorGeometry, _motions);
            _depthGeometry = depth.Enabled ? new DepthCameraGeometry(depth, scenario.Room, scene.ScreenSizeM) : null;
            if (scenario.InfraredCamera.Enabled)
            {
                _infraredGeometry = InfraredPainter.Geometry(scenario, _colorGeometry, scene.ScreenSizeM);
                InfraredMapping = InfraredMapping.OfPlane(new Homography((_colorGeometry.ScreenToImage * _infraredGeometry.ScreenToImage.Inverse).ToArray()));
            }

            Calibration = new RangeCalibration(_colorGeometry.Screen, color.Width, color.Height, _depthGeometry?.HandCamera);
            Truth = TruthBuilder.Build(scenario, view, _plan, _motions, _light, _optics, _depthTiming);
            _assets = new PictureAssets(view, scenario.Projector, scenario.Seed);
        }

        public SceneModel Scene { get; }

        public SimulationScenario Scenario => _scenario;

        /// <summary>Exact, as at the beginning (bumps of camera 0 are not in it).</summary>
        public RangeCalibration Calibration { get; }

        public SimulationTruth Truth { get; }

        /// <summary>Exact, from infrared to colour pixels; null without an infrared camera.</summary>
        public InfraredMapping? InfraredMapping { get; }

        /// <summary>Camera 0, exact, with its true focal length.</summary>
        public LensCamera ColorCamera => _colorGeometry.Camera;

        /// <summary>Exact, from camera 1's space to camera 0's, both mm: what a device with both cameras knows from its factory; null without camera 1.</summary>
        public Pose? DepthToColorMm => _depthGeometry == null ? (Pose?)null : _colorGeometry.ToScreenMm.Inverse * _depthGeometry.HandCamera.PoseInScreenMm;

        /// <summary>A new stream of camera 0's frames, with infrared where the scenario has it, from the beginning.</summary>
        public IFrameSource CreateColorSource() => new SimulatedColorSource(_scenario, _light,
            new CameraScene(_scenario, _colorGeometry, _assets, _light), new LaserPainter(_scenario, _plan, _light, _optics),
            new SensorModel(_scenario.ColorCamera),
            _infraredGeometry == null ? null : new InfraredPainter(_scenario, _colorGeometry, _infraredGeometry, _plan, _light));

        /// <summary>A new stream of camera 1's frames from the beginning.</summary>
        /// <exception cref="InvalidOperationException">The scenario has no camera 1.</exception>
        public IFrameSource CreateDepthSource()
        {
            if (_depthGeometry == null)
                throw new InvalidOperationException("this scenario has no depth camera");
            return new SimulatedDepthSource(_scenario, _depthGeometry, _motions, _depthTiming);
        }

        /// <summary>
        /// A new stream of the pictures that the projector was given, from the beginning; each carries the time at which it was drawn
        /// on camera 0's clock. Shown <see cref="ProjectorSettings.DelayMs"/> later.
        /// </summary>
        public IFrameSource CreatePictureSource() => new SimulatedPictureSource(_scenario, _assets, Truth);

        /// <summary>Draws the picture that the projector was given at a true time (BGRA), for reports and as the known rendered frame.</summary>
        public void DrawPicture(double trueUs, Image picture)
        {
            using var drawn = new ProjectorPicture(_assets);
            drawn.Draw(trueUs / 1e6);
            picture.CopyFrom(drawn.Image);
        }

        private ShooterMotion BuildMotion(SceneView view, int index)
        {
            ShooterSettings settings = _scenario.Shooters[index];
            Vector2D screen = view.Scene.ScreenSizeM;
            var shots = new List<PlannedShot>();
            foreach (PlannedShot shot in _plan)
            {
                if (shot.Shooter == index)
                    shots.Add(shot);
            }

            var feet = new Vector3D(screen.X / 2 + settings.OffsetXM, screen.Y + _scenario.Room.FloorBelowScreenM, -settings.DistanceM);
            // Seen on average half a picture after it was shown.
            double delayS = _scenario.Projector.DelayMs / 1000 + 0.5 / _scenario.Projector.RefreshHz;
            var aim = new AimPath(view, shots, new Tremor(settings.Tremor, _scenario.Seed, index), settings.DistanceM - 0.7, delayS,
                new Vector2D(feet.X, screen.Y + 0.25));
            double tiltX = Boresight(index, 0, settings), tiltY = Boresight(index, 1, settings);
            Rotation3D boresight = Rotation3D.AboutAxis(new Vector3D(1, 0, 0), tiltX) * Rotation3D.AboutAxis(new Vector3D(0, 1, 0), tiltY);
            return new ShooterMotion(settings, aim, feet, boresight);
        }

        private double Boresight(int shooter, int axis, ShooterSettings settings) =>
            CounterRandom.Gaussian(_scenario.Seed, RandomStream.Boresight, shooter, axis) * settings.BoresightErrorMrad / 1000;
    }
}
