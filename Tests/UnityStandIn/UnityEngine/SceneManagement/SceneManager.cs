// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine.SceneManagement
{
    /// <summary>One scene; loading another changes its name only.</summary>
    public class SceneManager
    {
        public static Scene GetActiveScene() => default;

        public static void LoadScene(string sceneName) => World.SceneName = sceneName;
    }
}
