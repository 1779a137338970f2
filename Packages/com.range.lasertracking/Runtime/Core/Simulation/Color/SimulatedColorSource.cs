using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Simulation
{
    /// <summary>Camera 0 of a simulated range: renders each frame when it is read. Frames depend on the scenario only.</summary>
    internal sealed unsafe class SimulatedColorSource : IFrameSource
    {
        private readonly SimulationScenario _scenario;
        private readonly LightSampler _light;
        private readonly CameraScene _scene;
        private readonly LaserPainter _lasers;
        private readonly SensorModel _sensor;
        private readonly InfraredPainter? _infrared;
        private readonly byte[] _rows;
        private readonly JpegEncoder? _encoder;
        private readonly JpegDecoder? _decoder;
        private readonly Image _raw = new Image();
        private int _next;

        public SimulatedColorSource(SimulationScenario scenario, LightSampler light, CameraScene scene, LaserPainter lasers, SensorModel sensor, InfraredPainter? infrared)
        {
            _scenario = scenario;
            _light = light;
            _scene = scene;
            _lasers = lasers;
            _sensor = sensor;
            _infrared = infrared;
            ColorCameraSettings camera = scenario.ColorCamera;
            _rows = new byte[camera.Width * 8];
            if (camera.JpegQuality > 0)
            {
                _encoder = new JpegEncoder(camera.JpegQuality);
                _decoder = new JpegDecoder();
            }

            Info = new FrameSourceInfo(scenario.Name + " (simulation, seed " + scenario.Seed + ")", camera.Width, camera.Height,
                camera.FramesPerSecond, (long)(scenario.DurationS * 1e6));
        }

        public FrameSourceInfo Info { get; }

        public IReadOnlyList<FrameProblem> Problems => Array.Empty<FrameProblem>();

        public bool TryRead(Frame frame)
        {
            if (_next >= _light.Timing.Count)
                return false;
            int index = _next++;
            ColorCameraSettings camera = _scenario.ColorCamera;
            frame.Begin(index, _light.Timing.ClockUs(index));
            Image image = _encoder == null ? frame.Color : _raw;
            image.Reset(camera.Format, camera.Width, camera.Height, frame.TimeUs);
            _scene.Prepare(index);
            _lasers.Paint(index, _scene);
            _infrared?.Paint(index, frame.Infrared, frame.TimeUs);
            uint key = (uint)CounterRandom.Hash(_scenario.Seed, RandomStream.ColorNoise, _light.Timing.Exposure(index));
            fixed (ushort* signals = _scene.Signals, flickering = _scene.Flickering)
            fixed (byte* rows = _rows)
                Develop(image, index, key, signals, flickering, rows);
            if (_encoder != null && !_decoder!.TryDecode(_encoder.Encode(image), frame.Color, frame.TimeUs, out string problem))
                throw new InvalidOperationException("a JPEG of our own making cannot be read: " + problem);
            return true;
        }

        public void Dispose()
        {
            _scene.Dispose();
            _raw.Dispose();
        }

        private void Develop(Image image, int frame, uint key, ushort* signals, ushort* flickering, byte* rows)
        {
            int width = image.Width, stride = image.Stride;
            byte* second = rows + width * 4;
            for (int y = 0; y < image.Height; y++)
            {
                byte* row = image.Pixels + (long)y * stride;
                switch (image.Format)
                {
                    case PixelFormat.Bgra32:
                        DevelopRow(y, width, frame, key, signals, flickering, row);
                        break;
                    case PixelFormat.Yuy2:
                        DevelopRow(y, width, frame, key, signals, flickering, rows);
                        ColorPacking.Yuy2(rows, width, row);
                        break;
                    default:
                        DevelopRow(y, width, frame, key, signals, flickering, rows);
                        DevelopRow(y + 1, width, frame, key, signals, flickering, second);
                        ColorPacking.Nv12(rows, second, width, row, row + stride, image.Pixels + (long)(image.Height + y / 2) * stride);
                        y++;
                        break;
                }
            }
        }

        private void DevelopRow(int y, int width, int frame, uint key, ushort* signals, ushort* flickering, byte* bgra)
        {
            int offset = y * width;
            ushort* ambient = flickering == null ? null : flickering + offset * 4;
            int strength = flickering == null ? 0 : (int)Math.Round(4096 * AmbientStrength(_light.ExposureBeginUs(frame, y)));
            _sensor.DevelopRow(signals + offset * 4, ambient, strength, width, (uint)offset, key, bgra);
        }

        // Mean of 1 + depth sin(2π f t) over the exposure.
        private double AmbientStrength(double beginUs)
        {
            RoomSettings room = _scenario.Room;
            double w = 2 * Math.PI * room.FlickerHz * 1e-6, length = _scenario.ColorCamera.ExposureUs;
            return 1 + room.FlickerDepth * (Math.Cos(w * beginUs) - Math.Cos(w * (beginUs + length))) / (w * length);
        }
    }
}
