using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Both cameras of a range that exists only as numbers: simulated trainees fire at the targets of the scene that plays it, so
    /// that a range can be tried without a camera. Brings its own calibration.
    /// </summary>
    [CreateAssetMenu(fileName = "Simulation", menuName = "Laser Tracking/Simulation Source")]
    public sealed class SimulationSource : FrameSourceAsset
    {
        [SerializeField]
        [Tooltip("Who fires when at which target (JSON); it names targets of the scene that it is played in.")]
        private TextAsset? _scenario;

        private SimulatedRange? _range;

        public override RangeCalibration? Calibration => _range?.Calibration;

        public override long? SceneTimeZeroUs => _range?.Truth.ColorClockUs(0);

        public override long HandClockOffsetUs => _range == null ? 0 : _range.Truth.ColorClockUs(0) - _range.Truth.DepthClockUs(0);

        // Rendering costs more than detecting: frames come from threads of their own, so that Unity's thread only detects.
        public override IFrameSource CreateSource(LaserRange range)
        {
            if (_scenario == null)
                throw new InputException("simulation source " + name, "has no scenario", "drag a scenario (a JSON text asset) in");
            _range = new SimulatedRange(SimulationScenarioFile.Parse(_scenario.text, "scenario " + _scenario.name), SceneModelBuilder.Build(range));
            return new PrefetchingFrameSource(_range.CreateColorSource());
        }

        public override IFrameSource? CreateHandSource() =>
            _range != null && _range.Scenario.DepthCamera.Enabled ? new PrefetchingFrameSource(_range.CreateDepthSource()) : null;
    }
}
