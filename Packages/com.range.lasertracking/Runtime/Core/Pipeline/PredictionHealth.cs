using LaserTracking.Detection;

namespace LaserTracking.Pipeline
{
    /// <summary>Says when the rendered pictures begin to be relied on, and after a second of not being, why.</summary>
    internal sealed class PredictionHealth
    {
        private const long SettledUs = 1_000_000;
        private bool _wasTrusted;
        private long _sinceUs;
        private PredictionState _state;
        private PredictionState _reported;

        /// <summary>One line for people, or null when there is nothing new.</summary>
        public string? Check(Detections detections)
        {
            if (detections.Prediction != _state)
                _sinceUs = detections.TimeUs;
            _state = detections.Prediction;
            bool isTrusted = _state == PredictionState.Trusted, hasSettled = isTrusted || detections.TimeUs - _sinceUs >= SettledUs;
            if (_state == PredictionState.Off || !hasSettled || _state == _reported)
                return null;
            _reported = _state;
            _wasTrusted |= isTrusted;
            return TextOf(_state, _wasTrusted);
        }

        private static string TextOf(PredictionState state, bool wasTrusted)
        {
            switch (state)
            {
                case PredictionState.Trusted: return "the rendered pictures are found in the camera's: shots count wherever they move";
                case PredictionState.Learning: return "the rendered pictures are found in the camera's, their colours not yet; what moves counts as unknown";
                case PredictionState.Doubtful: return "the screen is brighter than the rendered pictures explain; what moves counts as unknown; check calibration and exposure, and who stands before the screen";
                default:
                    return wasTrusted ? "the rendered pictures are not found in the camera's any more; what moves counts as unknown"
                        : "the rendered pictures are not found in the camera's yet: nothing moves, or they are others; what moves counts as unknown";
            }
        }
    }
}
