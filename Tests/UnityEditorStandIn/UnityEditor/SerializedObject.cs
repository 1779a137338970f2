// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using System;
using UnityStandIn;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    public class SerializedObject : IDisposable
    {
        private readonly Object _object;

        public SerializedObject(Object obj)
        {
            _object = obj;
        }

        public bool ApplyModifiedPropertiesWithoutUndo() => true;

        public void Dispose()
        {
        }

        /// <summary>Null when there is no such field, as in Unity.</summary>
        public SerializedProperty FindProperty(string propertyPath) =>
            SerializedFields.Find(_object.GetType(), propertyPath) == null ? null : new SerializedProperty(_object, propertyPath);
    }
}
