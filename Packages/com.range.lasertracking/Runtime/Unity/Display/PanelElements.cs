using UnityEngine;
using UnityEngine.UIElements;

namespace LaserTracking.Unity
{
    /// <summary>Elements as the package's panels use them: built in code, styled inline, so that no style sheet has to be found.</summary>
    internal static class PanelElements
    {
        public static Label Text(VisualElement parent, float sizePx, Color color)
        {
            var label = new Label { pickingMode = PickingMode.Ignore };
            label.style.fontSize = sizePx;
            label.style.color = color;
            label.style.whiteSpace = WhiteSpace.Normal;
            parent.Add(label);
            return label;
        }

        public static VisualElement Box(VisualElement parent, string name, Color background, float paddingPx)
        {
            var box = new VisualElement { name = name, pickingMode = PickingMode.Ignore };
            box.style.backgroundColor = background;
            box.style.paddingLeft = box.style.paddingRight = box.style.paddingTop = box.style.paddingBottom = paddingPx;
            parent.Add(box);
            return box;
        }

        /// <summary>Fills its parent.</summary>
        public static void Fill(VisualElement element)
        {
            element.style.position = Position.Absolute;
            element.style.left = element.style.top = element.style.right = element.style.bottom = 0f;
        }

        public static Length Percent(float share) => new Length(share, LengthUnit.Percent);
    }
}
