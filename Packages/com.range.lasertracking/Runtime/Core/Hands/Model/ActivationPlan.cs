using System;
using System.Collections.Generic;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// Places activations in one block of memory: first fit, largest use of what is free again. A tensor lives from the operator that
    /// writes it to the last one that reads it.
    /// </summary>
    internal sealed class ActivationPlan
    {
        // A cache line, so that every activation begins at one.
        private const int Granule = 16;

        private readonly List<(long Offset, long Length, int LastUse)> _live = new List<(long, long, int)>();

        /// <summary>Floats needed for all placed so far.</summary>
        public long Length { get; private set; }

        /// <summary>Offset in floats. Called in the order of <paramref name="firstUse"/>.</summary>
        /// <param name="count">Floats.</param>
        /// <param name="firstUse">Operator that writes it.</param>
        /// <param name="lastUse">Last operator that reads it, or int.MaxValue.</param>
        public long Place(int count, int firstUse, int lastUse)
        {
            _live.RemoveAll(block => block.LastUse < firstUse);
            long length = (count + Granule - 1) / Granule * Granule, offset = 0;
            int index = 0;
            for (; index < _live.Count && _live[index].Offset - offset < length; index++)
                offset = _live[index].Offset + _live[index].Length;
            _live.Insert(index, (offset, length, lastUse));
            Length = Math.Max(Length, offset + length);
            return offset;
        }
    }
}
