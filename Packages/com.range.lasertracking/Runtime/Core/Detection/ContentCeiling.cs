using System;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The brightest that the projected picture gets here, in its strongest channel: what the projector can show, a moving picture can
    /// do anywhere at any time; what exceeds it is light from elsewhere. Learned from the remembered brightness, in which dots leave
    /// no trace. Says nothing where projected white itself is near full brightness.
    /// </summary>
    internal sealed class ContentCeiling
    {
        /// <summary>Every fourth pixel of every fourth row of a picture 640 wide is looked at; as many of a larger one.</summary>
        private const int Step = 4;

        /// <summary>One sample in this many may be brighter: less than two hundred pixels of a picture 640 wide, a dot or two.</summary>
        private const int Rarity = 1200;

        /// <summary>Frames in which the ceiling falls by a level: scenes change, but a dark minute does not mean a weak projector.</summary>
        private const int FramesPerLevel = 16;

        private readonly LevelHistogram _histogram;
        private int _frames;

        /// <summary>May exceed what the camera can show: a longer exposure that is taken back leaves it where it was.</summary>
        private double _level;

        public ContentCeiling(KernelRunner kernels) => _histogram = new LevelHistogram(kernels);

        /// <summary>0…255, by the envelope of the largest channel.</summary>
        public int Level => (int)Math.Min(255, Math.Round(_level));

        public void Reset()
        {
            _frames = 0;
            _level = 0;
        }

        /// <summary>The exposure has changed by this factor.</summary>
        public void Scale(double gain) => _level *= gain;

        public void Update(in FrameView view)
        {
            int count = _histogram.Count(view, false, Math.Max(Step, Step * view.Width / 640)), level = 255;
            ReadOnlySpan<int> histogram = _histogram.Counts;
            for (int above = histogram[255]; level > 0 && above * Rarity <= count; above += histogram[level])
                level--;
            _frames++;
            if (_frames == 1)
                _level = level;
            else if (level > Level)
                _level += (level - Level + 3) / 4;
            else if (level < _level && _frames % FramesPerLevel == 0)
                _level--;
        }
    }
}
