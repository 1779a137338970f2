using LaserTracking.Detection;

namespace LaserTracking.Session
{
    /// <summary>The report's tables: shots, shooters, targets.</summary>
    internal static class ReportTables
    {
        public static void Shots(HtmlWriter html, ReportData data)
        {
            html.Raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"All shots\"><table class=\"shots\">\n<thead><tr>")
                .Raw("<th scope=\"col\" class=\"n\">Shot</th><th scope=\"col\" class=\"n\">Time, s</th>")
                .Raw("<th scope=\"col\" class=\"n\" title=\"Time since the same shooter's shot before; an arrow marks a change of target\">Split, s</th>")
                .Raw("<th scope=\"col\">Shooter</th>")
                .Raw(!data.IsScored ? "" : "<th scope=\"col\">Target</th><th scope=\"col\">Zone</th><th scope=\"col\" class=\"n\">Points</th><th scope=\"col\" class=\"n\">Score</th>" +
                    "<th scope=\"col\" class=\"n\" title=\"Probability that the true point lies in this zone\">Zone sure</th>")
                .Raw("<th scope=\"col\">Laser</th><th scope=\"col\" class=\"n\" title=\"The detector's confidence\">Confidence</th>")
                .Raw("<th scope=\"col\" class=\"n\" title=\"One standard deviation of the place, ")
                .Raw(data.HasScreen ? "on the screen\">± mm" : "in the camera's picture\">± px").Raw("</th></tr></thead>\n<tbody>\n");
            foreach (ReportShot shot in data.Shots)
                Row(html, data, shot);
            html.Raw("</tbody></table></div>\n");
        }

        public static void Shooters(HtmlWriter html, ReportData data)
        {
            html.Raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Shooters\"><table>\n<thead><tr><th scope=\"col\">Shooter</th>")
                .Raw("<th scope=\"col\" class=\"n\">Shots</th>")
                .Raw(!data.IsScored ? "" : "<th scope=\"col\" class=\"n\">Hits</th><th scope=\"col\" class=\"n\">Misses</th><th scope=\"col\" class=\"n\">No-shoots</th>" +
                    "<th scope=\"col\" class=\"n\">Points</th><th scope=\"col\" class=\"n\">Score</th>")
                .Raw("<th scope=\"col\" class=\"n\">First shot, s</th><th scope=\"col\" class=\"n\">Mean split, s</th>")
                .Raw("<th scope=\"col\" class=\"n\">Best split, s</th><th scope=\"col\" class=\"n\">Mean transition, s</th></tr></thead>\n<tbody>\n");
            foreach (ReportTotals shooter in data.Shooters)
            {
                html.Raw("<tr><th scope=\"row\">");
                ShotText.Shooter(html, shooter);
                html.Raw("</th>");
                html.Raw("<td class=\"n\">").Integer(shooter.Shots).Raw("</td>");
                if (data.IsScored)
                    Sums(html, shooter);
                Seconds(html, shooter.FirstS);
                Seconds(html, shooter.MeanSplitS);
                Seconds(html, shooter.BestSplitS);
                Seconds(html, shooter.MeanTransitionS);
                html.Raw("</tr>\n");
            }

            html.Raw("</tbody></table></div>\n");
        }

        public static void Targets(HtmlWriter html, ReportData data)
        {
            html.Raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Targets\"><table class=\"narrow\">\n<thead><tr><th scope=\"col\">Target</th>")
                .Raw("<th scope=\"col\" class=\"n\">Hits</th><th scope=\"col\" class=\"n\">Points</th><th scope=\"col\" class=\"n\">Score</th>")
                .Raw("<th scope=\"col\" class=\"n\">First hit, s</th></tr></thead>\n<tbody>\n");
            foreach (ReportTotals target in data.Targets)
            {
                html.Raw(target.Mistakes > 0 ? "<tr class=\"mistake\"><th scope=\"row\">" : "<tr><th scope=\"row\">").Text(target.Name);
                if (target.Mistakes > 0)
                    html.Raw(" <span class=\"badge\">no-shoot hit</span>");
                html.Raw("</th><td class=\"n\">").Integer(target.Shots).Raw("</td><td class=\"n\">").Column(target.Points, 0).Raw("</td><td class=\"n\">")
                    .Column(target.Score, 2).Raw("</td>");
                Seconds(html, target.FirstS);
                html.Raw("</tr>\n");
            }

            html.Raw("</tbody></table></div>\n");
        }

        private static void Row(HtmlWriter html, ReportData data, ReportShot shot)
        {
            ShotEvent e = shot.Event;
            html.Raw("<tr id=\"shot-").Integer(shot.Id).Raw("\" data-shot=\"").Integer(shot.Id)
                .Raw("\" class=\"row").Raw(data.MarkClass(shot)).Raw("\">")
                .Raw("<th scope=\"row\" class=\"n\"><a href=\"#hole-").Integer(shot.Id).Raw("\">").Integer(shot.Id).Raw("</a></th>");
            Seconds(html, shot.TimeS);
            if (double.IsNaN(shot.IntervalS))
                html.Raw("<td class=\"n\">–</td>");
            else
                html.Raw(shot.IsTransition ? "<td class=\"n\" title=\"Transition from another target\">→ " : "<td class=\"n\">").Column(shot.IntervalS, 2).Raw("</td>");
            html.Raw("<td>");
            ShotText.Shooter(html, data.Shooters[shot.ShooterIndex]);
            if (e.Shooter > 0 && e.ShooterProbability < 0.9)
                html.Raw(" <small>").Percent(e.ShooterProbability).Raw("</small>");
            html.Raw("</td>");
            if (e.HasHit)
            {
                html.Raw("<td>").Text(e.Hit.Target);
                if (shot.IsMistake)
                    html.Raw(" <span class=\"badge\">no-shoot hit</span>");
                html.Raw("</td><td>").Text(e.Hit.Zone).Raw("</td><td class=\"n\">").Column(e.Hit.Points, 0).Raw("</td><td class=\"n\">").Column(e.Hit.Score, 2)
                    .Raw(e.Hit.ZoneProbability < 0.8 ? "</td><td class=\"n close\" title=\"Close to a zone's line\">" : "</td><td class=\"n\">")
                    .Percent(e.Hit.ZoneProbability).Raw("</td>");
            }
            else if (data.IsScored)
            {
                html.Raw("<td colspan=\"5\" class=\"none\">miss</td>");
            }

            html.Raw("<td>").Raw(e.Shot.Dot.Color == LaserColor.Unknown ? "–" : EventWords.Of(e.Shot.Dot.Color)).Raw("</td><td class=\"n\">")
                .Percent(e.Shot.Dot.Confidence).Raw("</td><td class=\"n\">");
            if (!data.HasScreen)
                html.Column(e.Shot.Dot.CovariancePx.Sigma, 2);
            else if (e.HasScreenPosition)
                html.Column(e.ScreenCovarianceMm2.Sigma, 1);
            else
                html.Raw("–");
            html.Raw("</td></tr>\n");
        }

        private static void Sums(HtmlWriter html, ReportTotals totals) => html
            .Raw("<td class=\"n\">").Integer(totals.Hits).Raw("</td><td class=\"n\">")
            .Integer(totals.Misses).Raw(totals.Mistakes > 0 ? "</td><td class=\"n bad\">" : "</td><td class=\"n\">").Integer(totals.Mistakes)
            .Raw("</td><td class=\"n\">").Column(totals.Points, 0).Raw("</td><td class=\"n\">").Column(totals.Score, 2).Raw("</td>");

        private static void Seconds(HtmlWriter html, double seconds) => html.Raw("<td class=\"n\">").Column(seconds, 2).Raw("</td>");
    }
}
