// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using System.Collections.Generic;
using System.Reflection;
using UnityStandIn;

namespace UnityEngine
{
    public sealed class GameObject : Object
    {
        private readonly List<Component> _components = new List<Component>();

        public GameObject()
            : this("New Game Object")
        {
        }

        public GameObject(string name)
        {
            this.name = name;
            transform = (Transform)Attach(typeof(Transform));
            World.Add(this);
        }

        public GameObject(string name, params Type[] components)
            : this(name)
        {
            foreach (Type type in components)
                AddComponent(type);
        }

        public Transform transform { get; }

        /// <summary>0…31.</summary>
        public int layer { get; set; }

        public string tag { get; set; } = "Untagged";

        public bool activeSelf { get; private set; } = true;

        public bool activeInHierarchy =>
            !IsDestroyed && activeSelf && (transform.parent == null || transform.parent.gameObject.activeInHierarchy);

        public SceneManagement.Scene scene => default;

        internal IReadOnlyList<Component> Components => _components;

        /// <summary>With the collider that Unity gives it. Planes and cylinders are not modelled.</summary>
        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            var created = new GameObject(type.ToString());
            created.AddComponent<MeshFilter>().sharedMesh = type == PrimitiveType.Quad ? Mesh.Quad : null;
            created.AddComponent<MeshRenderer>();
            switch (type)
            {
                case PrimitiveType.Cube: created.AddComponent<BoxCollider>(); break;
                case PrimitiveType.Sphere: created.AddComponent<SphereCollider>(); break;
                case PrimitiveType.Capsule: created.AddComponent<CapsuleCollider>().height = 2; break;
                case PrimitiveType.Quad: created.AddComponent<MeshCollider>().sharedMesh = Mesh.Quad; break;
                default: throw new NotSupportedException("the stand-in has no primitive " + type);
            }

            return created;
        }

        public void SetActive(bool value)
        {
            if (activeSelf == value)
                return;
            activeSelf = value;
            RefreshAll();
        }

        public T AddComponent<T>() where T : Component => (T)AddComponent(typeof(T));

        /// <summary>What RequireComponent names comes first; a second one of a DisallowMultipleComponent type is refused.</summary>
        public Component AddComponent(Type componentType)
        {
            foreach (RequireComponent required in componentType.GetCustomAttributes<RequireComponent>(true))
            {
                if (GetComponent(required.m_Type0) == null)
                    AddComponent(required.m_Type0);
            }

            if (componentType.IsDefined(typeof(DisallowMultipleComponent), false) && GetComponent(componentType) != null)
            {
                Debug.LogError("The component " + componentType.Name + " can't be added because " + name + " already contains the same component");
                return null;
            }

            Component added = Attach(componentType);
            added.Refresh();
            return added;
        }

        public Component GetComponent(Type type) => _components.Find(type.IsInstanceOfType);

        public T GetComponent<T>() => TryGetComponent(out T found) ? found : default;

        public bool TryGetComponent<T>(out T component)
        {
            foreach (Component candidate in _components)
            {
                if (candidate is T wanted)
                {
                    component = wanted;
                    return true;
                }
            }

            component = default;
            return false;
        }

        public T[] GetComponents<T>()
        {
            var found = new List<T>();
            CollectHere(found);
            return found.ToArray();
        }

        /// <summary>On this object or above, on active objects only.</summary>
        public T GetComponentInParent<T>()
        {
            for (Transform at = transform; at != null; at = at.parent)
            {
                if (at.gameObject.activeInHierarchy && at.TryGetComponent(out T found))
                    return found;
            }

            return default;
        }

        public T GetComponentInChildren<T>()
        {
            T[] found = GetComponentsInChildren<T>();
            return found.Length > 0 ? found[0] : default;
        }

        /// <summary>On this object and below, depth first, on active objects only.</summary>
        public T[] GetComponentsInChildren<T>() => GetComponentsInChildren<T>(false);

        public T[] GetComponentsInChildren<T>(bool includeInactive)
        {
            var found = new List<T>();
            CollectBelow(found, includeInactive);
            return found.ToArray();
        }

        internal void Detach(Component component) => _components.Remove(component);

        internal void RefreshAll()
        {
            foreach (Component component in _components.ToArray())
                component.Refresh();
            foreach (Transform child in transform.Children.ToArray())
                child.gameObject.RefreshAll();
        }

        internal override void DestroyNow()
        {
            if (IsDestroyed)
                return;
            SetActive(false);
            foreach (Transform child in transform.Children.ToArray())
                child.gameObject.DestroyNow();
            transform.Unhook();
            for (int i = _components.Count - 1; i >= 0; i--)
                _components[i].DestroyNow();
            World.Remove(this);
            base.DestroyNow();
        }

        private Component Attach(Type type)
        {
            var component = (Component)Activator.CreateInstance(type, nonPublic: true);
            component.AttachTo(this);
            _components.Add(component);
            World.Add(component);
            return component;
        }

        private void CollectHere<T>(List<T> found)
        {
            foreach (Component component in _components)
            {
                if (component is T wanted)
                    found.Add(wanted);
            }
        }

        private void CollectBelow<T>(List<T> found, bool includeInactive)
        {
            if (!includeInactive && !activeInHierarchy)
                return;
            CollectHere(found);
            foreach (Transform child in transform.Children)
                child.gameObject.CollectBelow(found, includeInactive);
        }
    }
}
