// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    /// <summary>Nobody presses a button.</summary>
    public class GUILayout
    {
        public static bool Button(string text, params GUILayoutOption[] options) => false;
    }
}
