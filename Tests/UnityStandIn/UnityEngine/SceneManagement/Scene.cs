// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine.SceneManagement
{
    /// <summary>The one scene there is.</summary>
    public struct Scene
    {
        public string name
        {
            get => World.SceneName;
            set => World.SceneName = value;
        }

        /// <summary>In order of creation: nothing reorders them here.</summary>
        public GameObject[] GetRootGameObjects() => World.Roots();
    }
}
