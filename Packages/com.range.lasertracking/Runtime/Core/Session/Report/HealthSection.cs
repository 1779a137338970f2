using LaserTracking.Detection;

namespace LaserTracking.Session
{
    /// <summary>What the operator should know: frames, problems, and why candidates were not shots.</summary>
    internal static class HealthSection
    {
        private const int MostRows = 50;

        public static void Draw(HtmlWriter html, ReportData data)
        {
            SessionRecorder session = data.Session;
            if (!session.IsEnded)
                html.Raw("<p class=\"warning\">The session was interrupted: what was recorded until then is shown.</p>\n");
            html.Raw("<dl class=\"facts\">");
            Fact(html, "Frames").Integer(session.Summary.Frames).Raw("</dd></div>");
            Fact(html, "Without a usable picture").Integer(session.Summary.Dropped).Raw("</dd></div>");
            if (session.Frames.Count > 0)
            {
                Fact(html, "Screen blind on average").Number(session.Frames.MeanBlindShare * 100, 1).Raw(" %</dd></div>");
                Fact(html, "Worst frame").Number(session.Frames.LargestBlindShare * 100, 1).Raw(" % blind</dd></div>");
            }

            if (data.Options.ShowProcessingTimes && session.Frames.TimedCount > 0)
            {
                Fact(html, "Time a frame, median").Number(session.Frames.MedianMs, 2).Raw(" ms</dd></div>");
                Fact(html, "95 % of frames within").Number(session.Frames.P95Ms, 2).Raw(" ms</dd></div>");
            }

            html.Raw("</dl>\n");
            DrawProblems(html, data);
            DrawRejected(html, session);
        }

        private static HtmlWriter Fact(HtmlWriter html, string name) => html.Raw("<div><dt>").Raw(name).Raw("</dt><dd>");

        private static void DrawProblems(HtmlWriter html, ReportData data)
        {
            SessionRecorder session = data.Session;
            foreach (HealthEvent health in session.Health)
            {
                if (health.Kind == HealthKind.Advice)
                    html.Raw("<p><b>What is caught here:</b> ").Text(health.Text).Raw(".</p>\n");
            }

            int problems = session.HealthCount - session.CountOf(HealthKind.Advice);
            if (problems == 0)
            {
                html.Raw("<p class=\"good\">No problems were noticed.</p>\n");
                return;
            }

            html.Raw("<h3>Problems</h3>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Problems\"><table>\n<thead><tr><th scope=\"col\" class=\"n\">Time, s</th>")
                .Raw("<th scope=\"col\" class=\"n\">Frame</th><th scope=\"col\">Kind</th><th scope=\"col\">What</th></tr></thead>\n<tbody>\n");
            int rows = 0;
            foreach (HealthEvent health in session.Health)
            {
                if (health.Kind == HealthKind.Advice)
                    continue;
                if (rows++ == MostRows)
                    break;
                html.Raw("<tr><td class=\"n\">").Column((health.TimeUs - session.StartTimeUs) * 1e-6, 2).Raw("</td><td class=\"n\">").Integer(health.FrameIndex)
                    .Raw("</td><td>").Raw(ShotText.Plain(EventWords.Of(health.Kind))).Raw("</td><td>").Text(health.Text).Raw("</td></tr>\n");
            }

            html.Raw("</tbody></table></div>\n");
            if (problems > MostRows)
                html.Raw("<p>and ").Integer(problems - MostRows).Raw(" more: events.jsonl has them.</p>\n");
        }

        private static void DrawRejected(HtmlWriter html, SessionRecorder session)
        {
            html.Raw("<h3>Light that was not a shot</h3>\n");
            if (session.RejectedCount == 0)
            {
                html.Raw("<p>Nothing else looked like a laser.</p>\n");
                return;
            }

            html.Raw("<p>").Integer(session.RejectedCount).Raw(session.RejectedCount == 1 ? " candidate was" : " candidates were")
                .Raw(" looked at and refused.</p>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Refused candidates\">")
                .Raw("<table class=\"narrow\">\n<thead><tr><th scope=\"col\">Why</th><th scope=\"col\" class=\"n\">How often</th></tr></thead>\n<tbody>\n");
            for (int reason = 0; reason < 256; reason++)
            {
                int count = session.CountOf((RejectionReason)reason);
                if (count > 0)
                    html.Raw("<tr><td>").Raw(Plain((RejectionReason)reason)).Raw("</td><td class=\"n\">").Integer(count).Raw("</td></tr>\n");
            }

            html.Raw("</tbody></table></div>\n");
        }

        private static string Plain(RejectionReason reason)
        {
            switch (reason)
            {
                case RejectionReason.OutsideScreen: return "outside the screen";
                case RejectionReason.TooSmall: return "smaller than a laser dot";
                case RejectionReason.TooLarge: return "larger than a laser dot";
                case RejectionReason.NotCompact: return "frayed, not a compact spot";
                case RejectionReason.TooElongated: return "too long and thin for a moving dot";
                case RejectionReason.TooFaint: return "hardly brighter than the moment before";
                case RejectionReason.NotNew: return "was there before already";
                case RejectionReason.NotIsolated: return "its surroundings lit up as well";
                case RejectionReason.MovingSurroundings: return "part of something that moves";
                case RejectionReason.WrongColor: return "no laser's colour";
                case RejectionReason.LowConfidence: return "confidence below the limit";
                case RejectionReason.NotConfirmed: return "doubtful, and it did not vanish like a shot";
                case RejectionReason.Duplicate: return "belongs to a shot already counted";
                case RejectionReason.Rendered: return "part of the projected picture";
                default: return ShotText.Plain(EventWords.Of(reason));
            }
        }
    }
}
