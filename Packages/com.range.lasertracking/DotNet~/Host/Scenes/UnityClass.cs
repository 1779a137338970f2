using System.Collections.Generic;

namespace LaserTracking.Host.Scenes
{
    /// <summary>Unity's class numbers that the reader tells apart.</summary>
    internal static class UnityClass
    {
        public const int GameObject = 1;
        public const int Transform = 4;
        public const int MeshCollider = 64;
        public const int BoxCollider = 65;
        public const int MonoBehaviour = 114;
        public const int SphereCollider = 135;
        public const int CapsuleCollider = 136;
        public const int PrefabInstance = 1001;
        public const int SceneRoots = 1660057539;

        /// <summary>What only settles, shows, lights or sounds: a ray does not meet it and it moves nothing.</summary>
        private static readonly HashSet<int> Harmless = new()
        {
            20, 23, 29, 33, 81, 82, 96, 102, 104, 108, 120, 127, 157, 196, 198, 199, 205, 212, 215, 218, 220, 850595691,
        };

        public static bool IsHarmless(int classId) => Harmless.Contains(classId);

        public static bool IsCollider(int classId) => classId is MeshCollider or BoxCollider or SphereCollider or CapsuleCollider;

        public static bool IsRead(int classId) =>
            classId is GameObject or Transform or MonoBehaviour or SceneRoots || IsCollider(classId);
    }
}
