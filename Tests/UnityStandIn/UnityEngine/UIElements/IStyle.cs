// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.UIElements
{
    public interface IStyle
    {
        StyleColor backgroundColor { get; set; }

        StyleBackground backgroundImage { get; set; }

        StyleLength bottom { get; set; }

        StyleColor color { get; set; }

        StyleEnum<DisplayStyle> display { get; set; }

        StyleEnum<FlexDirection> flexDirection { get; set; }

        StyleFloat flexGrow { get; set; }

        StyleEnum<Wrap> flexWrap { get; set; }

        StyleLength fontSize { get; set; }

        StyleLength height { get; set; }

        StyleLength left { get; set; }

        StyleLength marginBottom { get; set; }

        StyleLength marginLeft { get; set; }

        StyleLength marginRight { get; set; }

        StyleLength marginTop { get; set; }

        StyleLength paddingBottom { get; set; }

        StyleLength paddingLeft { get; set; }

        StyleLength paddingRight { get; set; }

        StyleLength paddingTop { get; set; }

        StyleEnum<Position> position { get; set; }

        StyleLength right { get; set; }

        StyleLength top { get; set; }

        StyleEnum<TextAnchor> unityTextAlign { get; set; }

        StyleEnum<WhiteSpace> whiteSpace { get; set; }

        StyleLength width { get; set; }
    }
}
