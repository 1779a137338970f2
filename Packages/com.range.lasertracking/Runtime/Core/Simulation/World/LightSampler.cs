using System;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// Which part of a pulse a colour frame sees and where the dot was meanwhile. Truth and picture both come from here, so that
    /// they agree. Immutable, no allocation.
    /// </summary>
    internal sealed class LightSampler
    {
        private readonly ColorCameraSettings _camera;
        private readonly ColorCameraGeometry _geometry;
        private readonly ShooterMotion[] _motions;
        private readonly (double TimeUs, Vector2D ShiftPx)[] _nudges;

        public LightSampler(SimulationScenario scenario, ColorCameraGeometry geometry, ShooterMotion[] motions, FrameTiming timing)
        {
            _camera = scenario.ColorCamera;
            _geometry = geometry;
            _motions = motions;
            Timing = timing;
            _nudges = new (double, Vector2D)[scenario.Nudges.Count];
            for (int i = 0; i < _nudges.Length; i++)
                _nudges[i] = (scenario.Nudges[i].TimeS * 1e6, scenario.Nudges[i].ShiftPx);
        }

        public FrameTiming Timing { get; }

        /// <summary>How far the whole picture is displaced in a frame.</summary>
        public Vector2D ShiftPx(int frame)
        {
            Vector2D shift = default;
            foreach ((double timeUs, Vector2D shiftPx) in _nudges)
            {
                if (timeUs <= Timing.MidUs(frame))
                    shift += shiftPx;
            }

            return shift;
        }

        /// <summary>Factor on all light of a frame: what automatic exposure made of it.</summary>
        public double ExposureFactor(int frame)
        {
            double factor = 1;
            foreach (ExposureStepSettings step in _camera.ExposureSteps)
                factor *= step.At(Timing.MidUs(frame) * 1e-6);
            return factor;
        }

        /// <summary>True time at which a row's exposure begins; row may be a fraction.</summary>
        public double ExposureBeginUs(int frame, double row) =>
            Timing.MidUs(frame) - _camera.ExposureUs / 2 + (row - (_camera.Height - 1) / 2.0) * _camera.RollingShutterRowUs;

        public Vector2D ImagePx(PlannedShot shot, double timeS, Vector2D shiftPx) =>
            _geometry.Screen.ToImagePx(_motions[shot.Shooter].DotM(timeS)) + shiftPx;

        /// <summary>The part of the pulse that falls into the exposure of the row where the dot is; true µs.</summary>
        public bool TryGetLight(PlannedShot shot, int frame, Vector2D shiftPx, out double beginUs, out double endUs)
        {
            double slackUs = _camera.Height * _camera.RollingShutterRowUs;
            double mid = Timing.MidUs(frame);
            beginUs = Math.Max(shot.StartS * 1e6, mid - _camera.ExposureUs / 2 - slackUs);
            endUs = Math.Min(shot.EndS * 1e6, mid + _camera.ExposureUs / 2 + slackUs);
            if (beginUs >= endUs)
                return false;
            if (slackUs > 0)
            {
                double row = ImagePx(shot, (beginUs + endUs) / 2e6, shiftPx).Y;
                double rowBegin = ExposureBeginUs(frame, Math.Max(0, Math.Min(_camera.Height - 1, row)));
                beginUs = Math.Max(shot.StartS * 1e6, rowBegin);
                endUs = Math.Min(shot.EndS * 1e6, rowBegin + _camera.ExposureUs);
            }

            return endUs - beginUs > 1e-3;
        }

        /// <summary>Into how many moments the light is cut so that they lie less than half a pixel apart.</summary>
        public int SampleCount(PlannedShot shot, Vector2D shiftPx, double beginUs, double endUs)
        {
            const int probes = 8;
            double length = 0;
            Vector2D last = ImagePx(shot, beginUs / 1e6, shiftPx);
            for (int i = 1; i <= probes; i++)
            {
                Vector2D p = ImagePx(shot, (beginUs + (endUs - beginUs) * i / probes) / 1e6, shiftPx);
                length += (p - last).Length;
                last = p;
            }

            return (int)Math.Max(3, Math.Min(128, Math.Ceiling(length / 0.4) + 1));
        }

        public static double SampleTimeS(double beginUs, double endUs, int sample, int count) =>
            (beginUs + (endUs - beginUs) * (sample + 0.5) / count) / 1e6;
    }
}
