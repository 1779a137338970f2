// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using System.Reflection;
using UnityStandIn;

namespace UnityEngine
{
    /// <summary>
    /// Messages are found by name, private ones and those of base classes too. An exception in one is logged and goes no further.
    /// </summary>
    public class MonoBehaviour : Behaviour
    {
        private bool _isAwake;
        private bool _isOn;

        public MonoBehaviour()
        {
            var order = GetType().GetCustomAttribute<DefaultExecutionOrder>();
            ExecutionOrder = order == null ? 0 : order.order;
        }

        internal int ExecutionOrder { get; }

        internal bool IsStarted { get; set; }

        /// <summary>Awake once when first active, then OnEnable and OnDisable as the flags change.</summary>
        internal override void Refresh()
        {
            if (IsDestroyed || gameObject == null)
                return;
            if (gameObject.activeInHierarchy && !_isAwake)
            {
                _isAwake = true;
                Send("Awake");
            }

            // Asked again: Awake may have disabled this component or its object.
            if (isActiveAndEnabled && !_isOn)
            {
                _isOn = true;
                Send("OnEnable");
            }
            else if (!isActiveAndEnabled && _isOn)
            {
                _isOn = false;
                Send("OnDisable");
            }
        }

        internal override void SayGoodbye()
        {
            if (_isOn)
            {
                _isOn = false;
                Send("OnDisable");
            }

            if (_isAwake)
                Send("OnDestroy");
        }

        internal void Send(string message)
        {
            MethodInfo method = MessageMethods.Find(GetType(), message);
            if (method == null)
                return;
            try
            {
                method.Invoke(this, null);
            }
            catch (TargetInvocationException problem)
            {
                Debug.LogException(problem.InnerException, this);
            }
        }
    }
}
