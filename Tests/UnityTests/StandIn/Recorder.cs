using System.Collections.Generic;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>Writes down the messages it gets.</summary>
    internal class Recorder : MonoBehaviour
    {
        public static List<string> Messages { get; } = new List<string>();

        private void Awake() => Note("Awake");

        private void OnEnable() => Note("OnEnable");

        private void Start() => Note("Start");

        private void FixedUpdate() => Note("FixedUpdate");

        private void Update() => Note("Update");

        private void LateUpdate() => Note("LateUpdate");

        private void OnDisable() => Note("OnDisable");

        private void OnDestroy() => Note("OnDestroy");

        private void Note(string message) => Messages.Add(name + " " + message);
    }
}
