// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Collections.Generic;
using UnityStandIn;

namespace UnityEngine
{
    /// <summary>A destroyed object equals null, converts to false and forgets nothing else, as in Unity.</summary>
    public class Object
    {
        private static int _lastId;
        private readonly int _id = ++_lastId;
        private string _name = "";

        public string name
        {
            get => NameOwner._name;
            set => NameOwner._name = value;
        }

        internal bool IsDestroyed { get; private set; }

        /// <summary>Components share the name of their game object.</summary>
        internal virtual Object NameOwner => this;

        public static implicit operator bool(Object exists) => !(exists is null) && !exists.IsDestroyed;

        public static bool operator ==(Object x, Object y)
        {
            bool xThere = x, yThere = y;
            return xThere == yThere && (!xThere || ReferenceEquals(x, y));
        }

        public static bool operator !=(Object x, Object y) => !(x == y);

        /// <summary>At the end of the frame.</summary>
        public static void Destroy(Object obj)
        {
            if (obj != null)
                World.DestroyLater(obj);
        }

        public static void DestroyImmediate(Object obj)
        {
            if (obj != null)
                obj.DestroyNow();
        }

        public override bool Equals(object other) => other is Object o ? this == o : other is null && IsDestroyed;

        public override int GetHashCode() => _id;

        public override string ToString() => name + " (" + GetType().FullName + ")";

        internal virtual void DestroyNow() => IsDestroyed = true;
    }
}
