using LaserTracking.Capture.Matroska;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// Joins blocks of up to three tracks into captures. A block's sync time is its own plus its track's delay; the earliest one
    /// opens a capture, and what lies less than half a frame period behind it joins. Backwards it is the mirror image. A capture in
    /// whose middle a seek ends counts as the next one.
    /// </summary>
    internal sealed class CaptureAssembler
    {
        private readonly Slot[] _slots;
        private readonly long _windowNs;

        /// <summary>Where the current capture lies: 1 behind the cursors (it was read forwards), -1 before them, 0 there is none.</summary>
        private int _currentSide;
        private bool _isAfterSeek;

        /// <summary>Number of captures before the cursors, or -1 when unknown.</summary>
        private int _passed;

        /// <param name="cursors">One per track in a fixed order; null for a track that the recording does not have.</param>
        /// <param name="delaysNs">Added to the times of each track, not negative.</param>
        /// <param name="framePeriodNs">Nominal time between two captures.</param>
        public CaptureAssembler(BlockCursor?[] cursors, long[] delaysNs, long framePeriodNs)
        {
            _windowNs = framePeriodNs / 2;
            _slots = new Slot[cursors.Length];
            for (int i = 0; i < cursors.Length; i++)
                _slots[i] = new Slot(cursors[i], delaysNs[i]);
        }

        /// <summary>Index of the current capture, or -1 when a seek made it unknown.</summary>
        public int Index { get; private set; } = -1;

        /// <summary>The current capture's block of one track, or false.</summary>
        public bool TryGetBlock(int track, out MatroskaBlock block)
        {
            block = _slots[track].Block;
            return _slots[track].IsInCurrent;
        }

        public void Seek(long timeNs)
        {
            foreach (Slot slot in _slots)
            {
                if (timeNs <= 0)
                    slot.Cursor?.SeekToStart();
                else
                    slot.Cursor?.Seek(timeNs - slot.DelayNs);
                slot.IsInCurrent = false;
            }

            _currentSide = 0;
            _isAfterSeek = timeNs > 0;
            _passed = timeNs <= 0 ? 0 : -1;
        }

        public bool TryNext()
        {
            if (_currentSide < 0)
            {
                StepOverCurrent(forward: true);
                CountPassed(1);
            }

            long start = long.MaxValue;
            foreach (Slot slot in _slots)
            {
                slot.IsInCurrent = slot.TryPeekNext(out long time);
                if (slot.IsInCurrent && time < start)
                    start = time;
            }

            long end = start;
            bool hasAny = false;
            foreach (Slot slot in _slots)
            {
                if (!slot.IsInCurrent)
                    continue;
                long time = slot.SyncTimeNs;
                slot.IsInCurrent = time - start < _windowNs || time == start;
                if (!slot.IsInCurrent)
                    continue;
                hasAny = true;
                if (time > end)
                    end = time;
                slot.Cursor!.MoveNext();
            }

            if (hasAny && _isAfterSeek)
                AddMissedBefore(end);
            return Finish(hasAny, forward: true);
        }

        public bool TryPrevious()
        {
            if (_currentSide > 0)
            {
                StepOverCurrent(forward: false);
                CountPassed(-1);
            }

            bool hasAny = TakeBackwards(out long start);
            if (hasAny && _isAfterSeek && ReachesBehind(start))
            {
                // The seek ended inside this capture: it is the next one. Leave it behind and take the one before.
                _isAfterSeek = false;
                hasAny = TakeBackwards(out _);
            }

            return Finish(hasAny, forward: false);
        }

        private bool TakeBackwards(out long start)
        {
            long end = long.MinValue;
            foreach (Slot slot in _slots)
            {
                slot.IsInCurrent = slot.TryPeekPrevious(out long time);
                if (slot.IsInCurrent && time > end)
                    end = time;
            }

            start = end;
            bool hasAny = false;
            foreach (Slot slot in _slots)
            {
                if (!slot.IsInCurrent)
                    continue;
                long time = slot.SyncTimeNs;
                slot.IsInCurrent = end - time < _windowNs || time == end;
                if (!slot.IsInCurrent)
                    continue;
                hasAny = true;
                if (time < start)
                    start = time;
                slot.Cursor!.MovePrevious();
            }

            return hasAny;
        }

        /// <summary>Fills tracks of the capture whose block lies just before the time that was sought.</summary>
        private void AddMissedBefore(long end)
        {
            foreach (Slot slot in _slots)
            {
                if (slot.IsInCurrent || !slot.TryPeekPrevious(out long time))
                    continue;
                slot.IsInCurrent = end - time < _windowNs;
            }
        }

        private bool ReachesBehind(long start)
        {
            foreach (Slot slot in _slots)
            {
                // TryPeekNext overwrites the slot's block, but only of slots that are not in the capture.
                if (!slot.IsInCurrent && slot.TryPeekNext(out long time) && time - start < _windowNs)
                    return true;
            }

            return false;
        }

        private void StepOverCurrent(bool forward)
        {
            foreach (Slot slot in _slots)
            {
                if (!slot.IsInCurrent)
                    continue;
                if (forward)
                    slot.Cursor!.MoveNext();
                else
                    slot.Cursor!.MovePrevious();
            }
        }

        private bool Finish(bool hasAny, bool forward)
        {
            _isAfterSeek = false;
            _currentSide = !hasAny ? 0 : forward ? 1 : -1;
            if (!hasAny && !forward)
                _passed = 0;
            if (hasAny)
                CountPassed(forward ? 1 : -1);
            Index = hasAny && _passed >= 0 ? forward ? _passed - 1 : _passed : -1;
            return hasAny;
        }

        private void CountPassed(int step)
        {
            if (_passed >= 0)
                _passed += step;
        }

        private sealed class Slot
        {
            public readonly BlockCursor? Cursor;
            public readonly long DelayNs;
            public MatroskaBlock Block;
            public bool IsInCurrent;

            public Slot(BlockCursor? cursor, long delayNs)
            {
                Cursor = cursor;
                DelayNs = delayNs;
            }

            public long SyncTimeNs => Block.TimeNs + DelayNs;

            public bool TryPeekNext(out long syncTimeNs)
            {
                syncTimeNs = 0;
                if (Cursor == null || !Cursor.TryPeekNext(out Block))
                    return false;
                syncTimeNs = SyncTimeNs;
                return true;
            }

            public bool TryPeekPrevious(out long syncTimeNs)
            {
                syncTimeNs = 0;
                if (Cursor == null || !Cursor.TryPeekPrevious(out Block))
                    return false;
                syncTimeNs = SyncTimeNs;
                return true;
            }
        }
    }
}
