// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Collections.Generic;
using UnityStandIn;

namespace UnityEngine.UIElements
{
    /// <summary>A tree of elements with their inline styles; nothing is laid out or drawn.</summary>
    public class VisualElement : Focusable
    {
        private readonly List<VisualElement> _children = new List<VisualElement>();
        private VisualElement _parent;

        public VisualElement()
        {
        }

        public string name { get; set; } = "";

        public bool visible { get; set; } = true;

        public PickingMode pickingMode { get; set; }

        public IStyle style { get; } = new InlineStyle();

        public int childCount => _children.Count;

        public VisualElement this[int key] => _children[key];

        public void Add(VisualElement child)
        {
            child.RemoveFromHierarchy();
            child._parent = this;
            _children.Add(child);
        }

        public void Clear()
        {
            foreach (VisualElement child in _children)
                child._parent = null;
            _children.Clear();
        }

        public void RemoveFromHierarchy()
        {
            if (_parent != null)
                _parent._children.Remove(this);
            _parent = null;
        }
    }
}
