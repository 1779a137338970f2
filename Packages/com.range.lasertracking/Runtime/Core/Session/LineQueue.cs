using System;
using System.IO;

namespace LaserTracking.Session
{
    /// <summary>
    /// Finished lines waiting for their turn: by time, then kind, then order of arrival. Bytes lie in one arena in order of arrival,
    /// the index beside it is kept sorted; events come almost in order, so a new one moves few others. No allocation once warm.
    /// </summary>
    internal sealed class LineQueue
    {
        private readonly int _maximumBytes;
        private Entry[] _entries = new Entry[256];
        private byte[] _arena;
        private byte[] _spare;
        private int _used;

        /// <param name="maximumBytes">Room for lines that may be refused.</param>
        public LineQueue(int maximumBytes)
        {
            _maximumBytes = maximumBytes;
            _arena = new byte[Math.Min(maximumBytes, 1 << 16)];
            _spare = new byte[_arena.Length];
        }

        public int Count { get; private set; }

        /// <summary>Adds a line. One that may be refused is when the room is full; others always find room.</summary>
        public bool TryAdd(long timeUs, int kind, ReadOnlySpan<byte> line, bool mayRefuse)
        {
            if (mayRefuse && HeldBytes + line.Length > _maximumBytes)
                return false;
            if (_used + line.Length > _arena.Length)
                Compact(line.Length);
            if (Count == _entries.Length)
                Array.Resize(ref _entries, 2 * Count);
            int at = Count;
            while (at > 0 && IsAfter(_entries[at - 1], timeUs, kind))
                at--;
            Array.Copy(_entries, at, _entries, at + 1, Count - at);
            _entries[at] = new Entry(timeUs, kind, _used, line.Length);
            Count++;
            line.CopyTo(new Span<byte>(_arena, _used, line.Length));
            _used += line.Length;
            HeldBytes += line.Length;
            return true;
        }

        /// <summary>Writes every line with a time before this one, in order. Returns the number of lines.</summary>
        public int WriteBefore(long timeUs, Stream stream)
        {
            int lines = 0;
            while (lines < Count && _entries[lines].TimeUs < timeUs)
                Write(_entries[lines++], stream);
            Remove(lines);
            return lines;
        }

        /// <summary>Writes all lines, in order.</summary>
        public void WriteAll(Stream stream)
        {
            for (int i = 0; i < Count; i++)
                Write(_entries[i], stream);
            Remove(Count);
        }

        private int HeldBytes { get; set; }

        private static bool IsAfter(in Entry entry, long timeUs, int kind) =>
            entry.TimeUs > timeUs || entry.TimeUs == timeUs && entry.Kind > kind;

        private void Write(in Entry entry, Stream stream)
        {
            stream.Write(_arena, entry.Offset, entry.Length);
            HeldBytes -= entry.Length;
        }

        private void Remove(int lines)
        {
            if (lines == 0)
                return;
            Count -= lines;
            Array.Copy(_entries, lines, _entries, 0, Count);
            if (Count == 0)
                _used = 0;
        }

        /// <summary>Drops the bytes of lines that were written; doubles the room when more than half of it is still held.</summary>
        private void Compact(int needed)
        {
            int size = _spare.Length;
            while (size < 2 * (HeldBytes + needed))
                size *= 2;
            if (size > _spare.Length)
                _spare = new byte[size];
            int used = 0;
            for (int i = 0; i < Count; i++)
            {
                Entry entry = _entries[i];
                Buffer.BlockCopy(_arena, entry.Offset, _spare, used, entry.Length);
                _entries[i] = new Entry(entry.TimeUs, entry.Kind, used, entry.Length);
                used += entry.Length;
            }

            byte[] old = _arena;
            _arena = _spare;
            _spare = old.Length == size ? old : new byte[size];
            _used = used;
        }

        private readonly struct Entry
        {
            public readonly long TimeUs;
            public readonly int Kind;
            public readonly int Offset;
            public readonly int Length;

            public Entry(long timeUs, int kind, int offset, int length)
            {
                TimeUs = timeUs;
                Kind = kind;
                Offset = offset;
                Length = length;
            }
        }
    }
}
