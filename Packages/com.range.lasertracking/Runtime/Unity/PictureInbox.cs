using LaserTracking.Detection;
using LaserTracking.Imaging;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Rendered pictures on their way from Unity's thread to the detector's, which puts them in the history: Unity's thread waits for no
    /// more than the exchange of two of them. Where the detector does not keep up, the oldest are given up. One for each opening of a range:
    /// its pictures' memory goes when nobody knows it any more, as a camera that hangs keeps the detector's thread.
    /// </summary>
    internal sealed class PictureInbox
    {
        private const int Slots = 8;

        private readonly object _lock = new object();
        private readonly Image[] _waiting = new Image[Slots];
        private Image _written = new Image();
        private Image _read = new Image();
        private int _first;
        private int _count;

        public PictureInbox()
        {
            for (int i = 0; i < Slots; i++)
                _waiting[i] = new Image();
        }

        /// <summary>Belongs to the detector's thread.</summary>
        public RenderedFrameHistory History { get; } = new RenderedFrameHistory();

        /// <summary>Takes a picture; on Unity's thread.</summary>
        /// <param name="pixels">Rows from the bottom; copied.</param>
        /// <param name="width">Pixels.</param>
        /// <param name="height">Pixels.</param>
        /// <param name="drawnUs">On camera 0's clock.</param>
        public void Add(Color32[] pixels, int width, int height, long drawnUs)
        {
            pixels.CopyTo(_written, width, height, true, drawnUs);
            lock (_lock)
            {
                if (_count == Slots)
                    Leave();
                int free = (_first + _count++) % Slots;
                (_waiting[free], _written) = (_written, _waiting[free]);
            }
        }

        /// <summary>Puts what waits in the history; on the detector's thread.</summary>
        public void Deliver()
        {
            while (TryTake())
                History.Add(_read, _read.TimeUs);
        }

        private bool TryTake()
        {
            lock (_lock)
            {
                if (_count == 0)
                    return false;
                (_waiting[_first], _read) = (_read, _waiting[_first]);
                Leave();
                return true;
            }
        }

        private void Leave()
        {
            _first = (_first + 1) % Slots;
            _count--;
        }
    }
}
