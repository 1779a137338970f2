// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.UIElements
{
    /// <summary>Kept as its file has it; nothing is drawn.</summary>
    public class PanelSettings : ScriptableObject
    {
        [SerializeField]
        private Object themeUss = null;

        [SerializeField]
        private Object m_TargetTexture = null;

        [SerializeField]
        private int m_ScaleMode = 0;

        [SerializeField]
        private float m_Scale = 1;

        [SerializeField]
        private float m_SortingOrder = 0;

        [SerializeField]
        private int m_TargetDisplay = 0;

        private PanelSettings()
        {
        }

        public float scale
        {
            get => m_Scale;
            set => m_Scale = value;
        }

        public int targetDisplay
        {
            get => m_TargetDisplay;
            set => m_TargetDisplay = value;
        }

        public float sortingOrder
        {
            get => m_SortingOrder;
            set => m_SortingOrder = value;
        }

        internal bool IsPlain => themeUss == null && m_TargetTexture == null && m_ScaleMode == 0;
    }
}
