using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// What a detector found in one frame. Fixed room, owned by the pipeline and used again for every frame; what does not fit is
    /// counted, never lost silently.
    /// </summary>
    public sealed class Detections
    {
        private readonly Dot[] _dots;
        private readonly RejectedCandidate[] _rejected;
        private int _dotCount;
        private int _rejectedCount;

        public Detections(int dotCapacity = 64, int rejectedCapacity = 256)
        {
            _dots = new Dot[dotCapacity];
            _rejected = new RejectedCandidate[rejectedCapacity];
        }

        public int FrameIndex { get; private set; }

        /// <summary>Mid-exposure of the frame, microseconds on the device's clock.</summary>
        public long TimeUs { get; private set; }

        public ReadOnlySpan<Dot> Dots => new ReadOnlySpan<Dot>(_dots, 0, _dotCount);

        public ReadOnlySpan<RejectedCandidate> Rejected => new ReadOnlySpan<RejectedCandidate>(_rejected, 0, _rejectedCount);

        /// <summary>Dots and rejected candidates that found no room, and spots that there was no time to examine.</summary>
        public int OverflowCount { get; private set; }

        /// <summary>Width of the picture in which they were found, px; 0 when there was none. The scale for distances.</summary>
        public int ImageWidthPx { get; set; }

        /// <summary>Height of the picture, px; 0 when there was none or nobody told: then all rows count as exposed at once.</summary>
        public int ImageHeightPx { get; set; }

        /// <summary>Share of the searched area, 0…1, in which a dot of ordinary strength could not be seen in this frame.</summary>
        public double BlindShare { get; set; }

        /// <summary>The part of it that is too bright: no room is left above the background.</summary>
        public double SaturatedShare { get; set; }
        /// <summary>How far the detector could rely on the rendered pictures in this frame.</summary>
        public PredictionState Prediction { get; set; }

        /// <summary>From drawing a picture to the middle of the exposure that shows it, µs; null: not known.</summary>
        public long? PredictedDelayUs { get; set; }

        public void Begin(int frameIndex, long timeUs)
        {
            FrameIndex = frameIndex;
            TimeUs = timeUs;
            _dotCount = _rejectedCount = OverflowCount = 0;
            BlindShare = SaturatedShare = 0;
            ImageWidthPx = 0;
            ImageHeightPx = 0;
            Prediction = PredictionState.Off;
            PredictedDelayUs = null;
        }

        public void Add(in Dot dot)
        {
            if (_dotCount < _dots.Length)
                _dots[_dotCount++] = dot;
            else
                OverflowCount++;
        }

        /// <summary>Says that this many spots were left unexamined.</summary>
        public void Skip(int count) => OverflowCount += count;

        /// <summary>Notes a candidate that is no dot; the same spot with the same reason (seen in two planes, say) only once.</summary>
        public void Reject(in RejectedCandidate candidate)
        {
            for (int i = 0; i < _rejectedCount; i++)
            {
                if (_rejected[i].Reason == candidate.Reason && _rejected[i].PositionPx.Equals(candidate.PositionPx))
                    return;
            }

            if (_rejectedCount < _rejected.Length)
                _rejected[_rejectedCount++] = candidate;
            else
                OverflowCount++;
        }
    }
}
