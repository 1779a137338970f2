// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.UIElements
{
    /// <summary>Has a tree of elements while it is enabled and has panel settings.</summary>
    public sealed class UIDocument : MonoBehaviour
    {
        [SerializeField]
        private PanelSettings m_PanelSettings;

        [SerializeField]
        private float m_SortingOrder;

        // Of a document built in code: none. The names are those that scene files spell.
        [SerializeField]
        private UIDocument m_ParentUI = null;

        [SerializeField]
        private Object sourceAsset = null;

        private VisualElement _root;

        private UIDocument()
        {
        }

        public PanelSettings panelSettings
        {
            get => m_PanelSettings;
            set => m_PanelSettings = value;
        }

        public float sortingOrder
        {
            get => m_SortingOrder;
            set => m_SortingOrder = value;
        }

        public VisualElement rootVisualElement => _root;

        private void OnEnable() => _root = m_ParentUI != null || sourceAsset != null || m_PanelSettings == null ? null : new VisualElement();

        private void OnDisable() => _root = null;
    }
}
