// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using System.Collections.Generic;
using UnityStandIn;

namespace UnityEngine
{
    public class Component : Object
    {
        public GameObject gameObject { get; private set; }

        public Transform transform => gameObject.transform;

        internal override Object NameOwner => gameObject;

        public T GetComponent<T>() => gameObject.GetComponent<T>();

        public Component GetComponent(Type type) => gameObject.GetComponent(type);

        public T[] GetComponents<T>() => gameObject.GetComponents<T>();

        public bool TryGetComponent<T>(out T component) => gameObject.TryGetComponent(out component);

        public T GetComponentInParent<T>() => gameObject.GetComponentInParent<T>();

        public T GetComponentInChildren<T>() => gameObject.GetComponentInChildren<T>();

        public T[] GetComponentsInChildren<T>() => gameObject.GetComponentsInChildren<T>();

        public T[] GetComponentsInChildren<T>(bool includeInactive) => gameObject.GetComponentsInChildren<T>(includeInactive);

        internal void AttachTo(GameObject owner) => gameObject = owner;

        /// <summary>Brings life-cycle state in line with active and enabled flags.</summary>
        internal virtual void Refresh()
        {
        }

        /// <summary>The last message before the object is gone.</summary>
        internal virtual void SayGoodbye()
        {
        }

        internal override void DestroyNow()
        {
            if (IsDestroyed)
                return;
            gameObject.Detach(this);
            SayGoodbye();
            World.Remove(this);
            base.DestroyNow();
        }
    }
}
