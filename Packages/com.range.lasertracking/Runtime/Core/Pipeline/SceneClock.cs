using System;

namespace LaserTracking.Pipeline
{
    /// <summary>
    /// Tells the scene's time from the time of the game engine and the times of camera 0's frames. Live, the frames lead: the scene
    /// follows the camera's clock, however its quartz drifts. Played, the engine leads, and the scene waits for a machine that cannot
    /// keep up. Never runs backwards. One thread; no allocation.
    /// </summary>
    public sealed class SceneClock
    {
        /// <summary>How far the scene may run ahead of a recording that is still being worked at, seconds.</summary>
        public const double MostAheadS = 0.25;

        /// <summary>The frame that came least late within so long tells how the clocks stand, seconds.</summary>
        private const double WindowS = 4;

        /// <summary>Correction per second of time.</summary>
        private const double SlewPerS = 0.01;

        private readonly bool _isLive;
        private readonly double _latencyS;
        private double _timeS;
        private double _engineS;
        private double _windowEndS;
        private double _leastLateS = double.NegativeInfinity;
        private double _toCorrectS;

        /// <param name="isLive">Frames come when they come; else they are due when the scene's time has reached them.</param>
        /// <param name="latencyS">From the light to the frame, seconds.</param>
        public SceneClock(bool isLive, double latencyS)
        {
            _isLive = isLive;
            _latencyS = latencyS;
        }

        public bool HasBegun { get; private set; }

        /// <summary>Seconds to add to the engine's time for the scene's clock.</summary>
        public double OffsetS => _timeS - _engineS;

        /// <summary>What the camera sees now reaches the computer later: a frame of this scene time or earlier is due.</summary>
        public double TimeS => _timeS;

        /// <summary>The first frame is there.</summary>
        /// <param name="engineTimeS">Now.</param>
        /// <param name="frameTimeS">The frame's time on the scene's clock.</param>
        public void Begin(double engineTimeS, double frameTimeS)
        {
            HasBegun = true;
            _engineS = engineTimeS;
            // What is shown now is what the first frame saw and as much more as that frame took to get here.
            _timeS = frameTimeS + _latencyS;
            _windowEndS = engineTimeS + WindowS;
        }

        /// <summary>Engine time has passed.</summary>
        /// <param name="engineTimeS">Now; not before the last call.</param>
        /// <param name="newestFrameS">Scene time of the newest frame that was read.</param>
        /// <param name="isWorking">That frame, or one after it, is being read or worked at; false: it waits for its time.</param>
        public void Advance(double engineTimeS, double newestFrameS, bool isWorking)
        {
            double passedS = Math.Max(0, engineTimeS - _engineS);
            _engineS = engineTimeS;
            _timeS += passedS;
            if (_isLive)
                FollowCamera(engineTimeS, passedS, newestFrameS + _latencyS);
            else if (isWorking)
                _timeS = Math.Max(_timeS - passedS, Math.Min(_timeS, newestFrameS + _latencyS + MostAheadS));
        }

        private void FollowCamera(double engineTimeS, double passedS, double seenS)
        {
            // No frame comes from the future: a clock that lies behind one was set by a frame that had come late.
            _timeS = Math.Max(_timeS, seenS);
            _leastLateS = Math.Max(_leastLateS, seenS - _timeS);
            double step = Math.Max(-SlewPerS * passedS, _toCorrectS);
            _timeS += step;
            _toCorrectS -= step;
            _leastLateS -= step;
            if (engineTimeS < _windowEndS)
                return;
            _toCorrectS = _leastLateS;
            _leastLateS = double.NegativeInfinity;
            _windowEndS = engineTimeS + WindowS;
        }
    }
}
