// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEngine;
using UnityStandIn;

namespace UnityEditor
{
    public class SerializedProperty
    {
        private readonly Object _owner;
        private readonly string _field;

        internal SerializedProperty(Object owner, string field)
        {
            _owner = owner;
            _field = field;
        }

        public Object objectReferenceValue
        {
            get => (Object)SerializedFields.Find(_owner.GetType(), _field).GetValue(_owner);
            set => SerializedFields.Set(_owner, _field, value);
        }
    }
}
