using System;
using LaserTracking.Geometry;

namespace LaserTracking.Session
{
    /// <summary>A lane for each shooter with the shots in time and the intervals between them where there is room.</summary>
    internal static class Timeline
    {
        private const double Left = 120;
        private const double Right = 980;
        private const double LaneHeight = 54;
        private const double RoomForInterval = 30;
        private const double RoomForNumber = 15;
        private const double BlindHeight = 18;

        public static void Draw(HtmlWriter html, ReportData data)
        {
            double start = data.Shots[0].TimeS, end = data.Shots[data.Shots.Length - 1].TimeS;
            double margin = Math.Max(0.25, 0.03 * (end - start));
            start = start < 3 * (end - start) + 2 ? Math.Min(0, start) : start - margin;
            end += margin;
            double height = data.Shooters.Count * LaneHeight + 34;
            html.Raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Timeline\"><svg class=\"timeline\" viewBox=\"0 0 1000 ")
                .Number(height, 0).Raw("\" role=\"group\" aria-label=\"Shots in time\">\n");
            DrawAxis(html, start, end, height);
            for (int lane = 0; lane < data.Shooters.Count; lane++)
                DrawLane(html, data, lane, start, end);
            DrawBlind(html, data, start, end, height - 26);
            DrawHealth(html, data, start, end);
            html.Raw("</svg></div>\n");
        }

        /// <summary>A band at the foot, as dark as the screen was blind.</summary>
        private static void DrawBlind(HtmlWriter html, ReportData data, double start, double end, double bottom)
        {
            BlindTimeline blind = data.Session.Blind;
            html.Raw("<g class=\"blind\">");
            for (int i = 0; i < blind.Count; i++)
            {
                double share = blind.MeanShare(i), from = (blind.BeginUs(i) - data.Session.StartTimeUs) * 1e-6, to = from + blind.StepUs * 1e-6;
                from = Math.Max(from, start);
                to = Math.Min(to, end);
                if (share < 0.005 || from >= to)
                    continue;
                double height = Math.Max(1, share * BlindHeight);
                html.Raw("<rect x=\"").Number(At(from, start, end), 1).Raw("\" y=\"").Number(bottom - height, 1).Raw("\" width=\"")
                    .Number(At(to, start, end) - At(from, start, end), 1).Raw("\" height=\"").Number(height, 1).Raw("\"><title>")
                    .Number(share * 100, 0).Raw(" % of the screen blind</title></rect>");
            }

            html.Raw("</g>\n");
        }

        private static void DrawHealth(HtmlWriter html, ReportData data, double start, double end)
        {
            html.Raw("<g class=\"health\">");
            foreach (HealthEvent health in data.Session.Health)
            {
                double time = (health.TimeUs - data.Session.StartTimeUs) * 1e-6;
                if (health.Kind != HealthKind.Advice && time >= start && time <= end)
                    html.Raw("<path d=\"M").Number(At(time, start, end), 1).Raw(" 2l4 7h-8z\"><title>").Text(health.Text).Raw("</title></path>");
            }

            html.Raw("</g>\n");
        }

        private static double At(double timeS, double start, double end) => Left + (timeS - start) / (end - start) * (Right - Left);

        private static void DrawAxis(HtmlWriter html, double start, double end, double height)
        {
            double[] steps = { 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 3600, 7200, 14400 };
            double step = steps[steps.Length - 1];
            for (int i = steps.Length - 1; i >= 0 && (end - start) / steps[i] <= 14; i--)
                step = steps[i];
            while ((end - start) / step > 14)
                step *= 2;
            html.Raw("<g class=\"axis\">");
            for (long i = (long)Math.Ceiling(start / step); i * step <= end; i++)
            {
                double x = At(i * step, start, end);
                html.Raw("<path d=\"M").Number(x, 1).Raw(" 4V").Number(height - 22, 1).Raw("\"/><text x=\"").Number(x, 1).Raw("\" y=\"")
                    .Number(height - 7, 1).Raw("\">").Number(i * step, 1).Raw("</text>");
            }

            html.Raw("<text class=\"unit\" x=\"").Number(Left - 14, 0).Raw("\" y=\"").Number(height - 7, 1).Raw("\">seconds</text></g>\n");
        }

        private static void DrawLane(HtmlWriter html, ReportData data, int lane, double start, double end)
        {
            ReportTotals shooter = data.Shooters[lane];
            double y = 30 + lane * LaneHeight;
            html.Raw("<g class=\"lane ").Raw(ReportData.ColorClass(shooter.Number)).Raw("\"><text class=\"who\" x=\"").Number(Left - 14, 0).Raw("\" y=\"")
                .Number(y + 5, 1).Raw("\">").Text(shooter.Name.Length > 16 ? shooter.Name.Substring(0, 15) + "…" : shooter.Name)
                .Raw("</text><path class=\"line\" d=\"M").Number(Left, 0).Raw(" ").Number(y, 1).Raw("H").Number(Right, 0).Raw("\"/>");
            double before = double.NegativeInfinity, numbered = double.NegativeInfinity;
            foreach (ReportShot shot in data.Shots)
            {
                if (shot.ShooterIndex != lane)
                    continue;
                double x = At(shot.TimeS, start, end);
                if (x - before >= RoomForInterval && !double.IsNaN(shot.IntervalS))
                    html.Raw("<text class=\"split\" x=\"").Number((x + before) / 2, 1).Raw("\" y=\"").Number(y + 18, 1).Raw("\">").Column(shot.IntervalS, 2).Raw("</text>");
                html.Raw("<a class=\"hole ").Raw(ReportData.ColorClass(shooter.Number)).Raw(data.MarkClass(shot))
                    .Raw("\" href=\"#shot-").Integer(shot.Id).Raw("\" data-shot=\"").Integer(shot.Id).Raw("\">");
                ShotText.Title(html, data, shot);
                ShotText.Mark(html, shot, new Vector2D(x, y), 4.5);
                if (x - numbered >= RoomForNumber)
                {
                    html.Raw("<text x=\"").Number(x, 1).Raw("\" y=\"").Number(y - 11, 1).Raw("\">").Integer(shot.Id).Raw("</text>");
                    numbered = x;
                }

                html.Raw("</a>");
                before = x;
            }

            html.Raw("</g>\n");
        }
    }
}
