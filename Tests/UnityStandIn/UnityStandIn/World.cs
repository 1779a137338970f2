// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>Everything that exists in the one scene of the stand-in, in order of creation.</summary>
    internal static class World
    {
        private static readonly List<GameObject> GameObjects = new List<GameObject>();
        private static readonly List<Component> Components = new List<Component>();
        private static readonly List<Collider> AllColliders = new List<Collider>();
        private static readonly List<Object> Doomed = new List<Object>();

        /// <summary>Apart, because every ray walks over them.</summary>
        public static IReadOnlyList<Collider> Colliders => AllColliders;

        public static void Add(GameObject created) => GameObjects.Add(created);

        public static void Add(Component created)
        {
            Components.Add(created);
            if (created is Collider collider)
                AllColliders.Add(collider);
        }

        public static void Remove(Component destroyed)
        {
            Components.Remove(destroyed);
            if (destroyed is Collider collider)
                AllColliders.Remove(collider);
        }

        public static void Remove(GameObject destroyed) => GameObjects.Remove(destroyed);

        public static string SceneName { get; set; } = "";

        public static GameObject[] Roots() => GameObjects.Where(existing => existing.transform.parent == null).ToArray();

        /// <summary>A copy: whoever walks over it may create and destroy.</summary>
        public static List<T> All<T>() where T : Component => Components.OfType<T>().ToList();

        public static void DestroyLater(Object doomed) => Doomed.Add(doomed);

        public static void DestroyDoomed()
        {
            Object[] now = Doomed.ToArray();
            Doomed.Clear();
            foreach (Object doomed in now)
            {
                if (doomed != null)
                    doomed.DestroyNow();
            }
        }

        public static void Clear()
        {
            foreach (GameObject existing in GameObjects.ToArray())
            {
                if (existing != null)
                    existing.DestroyNow();
            }

            GameObjects.Clear();
            Components.Clear();
            AllColliders.Clear();
            Doomed.Clear();
        }
    }
}
