using System;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>Fails in every frame, and is alone on its object.</summary>
    [DisallowMultipleComponent]
    [RequireComponent(typeof(BoxCollider))]
    internal sealed class ThrowingBehaviour : MonoBehaviour
    {
        private void Update() => throw new InvalidOperationException("as asked");
    }
}
