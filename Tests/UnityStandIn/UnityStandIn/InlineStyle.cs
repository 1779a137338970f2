// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityEngine;
using UnityEngine.UIElements;

namespace UnityStandIn
{
    /// <summary>Keeps what was set.</summary>
    internal sealed class InlineStyle : IStyle
    {
        public StyleColor backgroundColor { get; set; }

        public StyleBackground backgroundImage { get; set; }

        public StyleLength bottom { get; set; }

        public StyleColor color { get; set; }

        public StyleEnum<DisplayStyle> display { get; set; }

        public StyleEnum<FlexDirection> flexDirection { get; set; }

        public StyleFloat flexGrow { get; set; }

        public StyleEnum<Wrap> flexWrap { get; set; }

        public StyleLength fontSize { get; set; }

        public StyleLength height { get; set; }

        public StyleLength left { get; set; }

        public StyleLength marginBottom { get; set; }

        public StyleLength marginLeft { get; set; }

        public StyleLength marginRight { get; set; }

        public StyleLength marginTop { get; set; }

        public StyleLength paddingBottom { get; set; }

        public StyleLength paddingLeft { get; set; }

        public StyleLength paddingRight { get; set; }

        public StyleLength paddingTop { get; set; }

        public StyleEnum<Position> position { get; set; }

        public StyleLength right { get; set; }

        public StyleLength top { get; set; }

        public StyleEnum<TextAnchor> unityTextAlign { get; set; }

        public StyleEnum<WhiteSpace> whiteSpace { get; set; }

        public StyleLength width { get; set; }
    }
}
