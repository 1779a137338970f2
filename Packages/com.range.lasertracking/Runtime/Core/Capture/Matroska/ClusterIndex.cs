using System.Collections.Generic;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>
    /// Places of some clusters, ascending in offset and in time: shortcuts into a long recording, never the truth. At most
    /// <see cref="Capacity"/> entries (64 KiB); when full, every second one is dropped.
    /// </summary>
    internal sealed class ClusterIndex
    {
        public const int Capacity = 4096;

        private readonly List<long> _offsets = new List<long>();
        private readonly List<long> _timesNs = new List<long>();

        public int Count => _offsets.Count;

        public long OffsetOf(int entry) => _offsets[entry];

        /// <summary>Adds an entry where it keeps both orders; any other is ignored.</summary>
        public void Add(long offset, long timeNs)
        {
            int at = _offsets.BinarySearch(offset);
            if (at >= 0)
                return;
            at = ~at;
            if (at > 0 && _timesNs[at - 1] > timeNs || at < Count && _timesNs[at] < timeNs)
                return;
            _offsets.Insert(at, offset);
            _timesNs.Insert(at, timeNs);
            if (Count > Capacity)
                DropEverySecond();
        }

        public void RemoveAt(int entry)
        {
            _offsets.RemoveAt(entry);
            _timesNs.RemoveAt(entry);
        }

        public void Clear()
        {
            _offsets.Clear();
            _timesNs.Clear();
        }

        /// <summary>The last entry that begins before an offset, or -1.</summary>
        public int LastBefore(long offset)
        {
            int at = _offsets.BinarySearch(offset);
            return (at >= 0 ? at : ~at) - 1;
        }

        /// <summary>The last entry whose time is not after the given one, or -1.</summary>
        public int LastNotAfter(long timeNs)
        {
            int low = 0;
            int high = Count;
            while (low < high)
            {
                int middle = (low + high) / 2;
                if (_timesNs[middle] <= timeNs)
                    low = middle + 1;
                else
                    high = middle;
            }

            return low - 1;
        }

        private void DropEverySecond()
        {
            int kept = 0;
            for (int i = 0; i < Count; i += 2)
            {
                _offsets[kept] = _offsets[i];
                _timesNs[kept] = _timesNs[i];
                kept++;
            }

            _offsets.RemoveRange(kept, Count - kept);
            _timesNs.RemoveRange(kept, _timesNs.Count - kept);
        }
    }
}
