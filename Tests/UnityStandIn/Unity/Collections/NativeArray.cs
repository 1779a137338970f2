// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;

namespace Unity.Collections
{
    /// <summary>Managed here; given out by the graphics card only.</summary>
    public struct NativeArray<T> where T : struct
    {
        private readonly T[] _items;

        internal NativeArray(T[] items)
        {
            _items = items;
        }

        public int Length => _items.Length;

        /// <exception cref="ArgumentException">The lengths differ, as in Unity.</exception>
        public void CopyTo(T[] array)
        {
            if (array.Length != _items.Length)
                throw new ArgumentException("source and destination length must be the same");
            Array.Copy(_items, array, _items.Length);
        }
    }
}
