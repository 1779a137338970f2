// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using System.Reflection;
using UnityStandIn;

namespace UnityEngine
{
    public class ScriptableObject : Object
    {
        public static ScriptableObject CreateInstance(Type type)
        {
            var created = (ScriptableObject)Activator.CreateInstance(type, nonPublic: true);
            created.Send("Awake");
            created.Send("OnEnable");
            return created;
        }

        public static T CreateInstance<T>() where T : ScriptableObject => (T)CreateInstance(typeof(T));

        internal override void DestroyNow()
        {
            if (IsDestroyed)
                return;
            Send("OnDisable");
            Send("OnDestroy");
            base.DestroyNow();
        }

        private void Send(string message)
        {
            MethodInfo method = MessageMethods.Find(GetType(), message);
            if (method != null)
                method.Invoke(this, null);
        }
    }
}
