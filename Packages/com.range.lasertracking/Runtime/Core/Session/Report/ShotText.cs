using LaserTracking.Geometry;

namespace LaserTracking.Session
{
    /// <summary>What every drawing of a shot shares: its mark and the line that says what it is.</summary>
    internal static class ShotText
    {
        /// <summary>A title element: "Shot 7 · 13.73 s · Shooter 2 · Popper 3, zone A · 5 points".</summary>
        public static void Title(HtmlWriter html, ReportData data, ReportShot shot)
        {
            html.Raw("<title>Shot ").Integer(shot.Id).Raw(" · ").Column(shot.TimeS, 2).Raw(" s · ").Text(data.ShooterName(shot)).Raw(" · ");
            if (shot.Event.HasHit)
            {
                if (shot.IsMistake)
                    html.Raw("no-shoot hit: ");
                html.Text(shot.Event.Hit.Target).Raw(", zone ").Text(shot.Event.Hit.Zone).Raw(" · ").Column(shot.Event.Hit.Points, 0).Raw(" points");
            }
            else
            {
                html.Raw(data.IsScored ? "miss" : "not scored");
            }

            html.Raw("</title>");
        }

        /// <summary>Filled for a hit, open for a miss, a cross on top for a hit on a no-shoot: told apart without colours.</summary>
        public static void Mark(HtmlWriter html, ReportShot shot, Vector2D at, double radius)
        {
            html.Raw("<g transform=\"translate(").Number(at.X, 1).Raw(" ").Number(at.Y, 1).Raw(")\"><circle class=\"halo\" r=\"").Number(radius + 1.5, 1)
                .Raw("\"/><circle class=\"dot\" r=\"").Number(radius, 1).Raw("\"/>");
            if (shot.IsMistake)
                html.Raw("<path class=\"cross\" d=\"M-8 -8L8 8M-8 8L8 -8\"/>");
            html.Raw("</g>");
        }

        /// <summary>Text beside a shooter's colour.</summary>
        public static void Shooter(HtmlWriter html, ReportTotals shooter) =>
            html.Raw("<span class=\"swatch ").Raw(ReportData.ColorClass(shooter.Number)).Raw("\"></span>").Text(shooter.Name);

        /// <summary>Words of events.jsonl for people: "not_isolated" becomes "not isolated".</summary>
        public static string Plain(string word) => word.Replace('_', ' ');
    }
}
