using System;
using LaserTracking.Session;

namespace LaserTracking.Health
{
    /// <summary>Whether the camera sends the same picture again and again: a real one is never without noise.</summary>
    internal sealed class FrozenCheck
    {
        private const int LeastFrames = 8;
        private readonly double _limitUs;
        private long _sinceUs;
        private int _frames;
        private bool _isFrozen;

        public FrozenCheck(PictureMonitorSettings settings) => _limitUs = settings.FrozenS * 1e6;

        public void Update(SampleGrid grid, HealthWriter health)
        {
            if (!grid.IsUnchanged || IsPlain(grid.Green))
            {
                if (_isFrozen)
                    health.Say(HealthKind.PictureFrozen, (health.TimeUs - _sinceUs) * 1e-6, FormattableString.Invariant($"the picture moves again after {(health.TimeUs - _sinceUs) * 1e-6:F1} s; shots fired meanwhile are lost"));
                _isFrozen = false;
                _frames = 0;
                _sinceUs = health.TimeUs;
                return;
            }

            _frames++;
            if (_isFrozen || _frames < LeastFrames || health.TimeUs - _sinceUs < _limitUs)
                return;
            _isFrozen = true;
            health.Say(HealthKind.PictureFrozen, (health.TimeUs - _sinceUs) * 1e-6, FormattableString.Invariant($"no pixel has changed for {(health.TimeUs - _sinceUs) * 1e-6:F1} s: the camera hangs, unplug it and plug it in again"));
        }

        /// <summary>All black or all white says nothing about the camera.</summary>
        private static bool IsPlain(byte[] samples)
        {
            foreach (byte sample in samples)
            {
                if (sample != samples[0])
                    return false;
            }

            return true;
        }
    }
}
