using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>What really happened in a simulated session. Immutable; any thread.</summary>
    public sealed class SimulationTruth
    {
        private readonly SimulationScenario _scenario;
        private readonly ShooterMotion[] _motions;
        private readonly LightSampler _light;
        private readonly FrameTiming _depthTiming;
        private readonly TrueShot[] _shots;
        private readonly TrueDot[] _dots;
        private readonly int[] _firstDot;

        internal SimulationTruth(SimulationScenario scenario, ShooterMotion[] motions, LightSampler light, FrameTiming depthTiming,
            TrueShot[] shots, TrueDot[] dots)
        {
            _scenario = scenario;
            _motions = motions;
            _light = light;
            _depthTiming = depthTiming;
            _shots = shots;
            _dots = dots;
            _firstDot = new int[ColorFrameCount + 1];
            int dot = 0;
            for (int frame = 0; frame <= ColorFrameCount; frame++)
            {
                _firstDot[frame] = dot;
                while (dot < dots.Length && dots[dot].Frame == frame)
                    dot++;
            }
        }

        /// <summary>All pulses, in order of time.</summary>
        public IReadOnlyList<TrueShot> Shots => _shots;

        /// <summary>Colour frames delivered.</summary>
        public int ColorFrameCount => _light.Timing.Count;

        /// <summary>Depth frames delivered.</summary>
        public int DepthFrameCount => _depthTiming.Count;

        /// <summary>The light in a colour frame, in order of shots.</summary>
        public ReadOnlySpan<TrueDot> DotsOf(int colorFrame) =>
            new ReadOnlySpan<TrueDot>(_dots, _firstDot[colorFrame], _firstDot[colorFrame + 1] - _firstDot[colorFrame]);

        /// <summary>True mid-exposure of a colour frame, µs since the beginning; its own clock says <see cref="ColorClockUs"/>.</summary>
        public double ColorFrameTimeUs(int colorFrame) => _light.Timing.MidUs(colorFrame);

        public double DepthFrameTimeUs(int depthFrame) => _depthTiming.MidUs(depthFrame);

        /// <summary>What camera 0's clock says at a true time.</summary>
        public long ColorClockUs(double trueUs) => _light.Timing.ToClockUs(trueUs);

        /// <summary>What camera 1's clock says at a true time.</summary>
        public long DepthClockUs(double trueUs) => _depthTiming.ToClockUs(trueUs);

        /// <summary>How far bumps have displaced camera 0's picture in a frame; the calibration is that of the beginning.</summary>
        public Vector2D ShiftPx(int colorFrame) => _light.ShiftPx(colorFrame);

        /// <summary>The weapon hand of a shooter (from 1) at a true time in µs.</summary>
        public TrueHand HandAt(int shooter, double trueUs) => _motions[shooter - 1].Hand(trueUs / 1e6);

        /// <summary>The palm of a shooter's other hand, on the weapon or hanging; screen space, metres.</summary>
        public Vector3D SupportPalmAt(int shooter, double trueUs) => _motions[shooter - 1].Body(trueUs / 1e6).SupportPalmM;

        internal static int PictureShown(ProjectorSettings projector, double trueUs) =>
            (int)Math.Floor((trueUs / 1e6 - projector.DelayMs / 1000) * projector.RefreshHz + 1e-9);
    }
}
