using System;
using System.Text;

namespace LaserTracking.Session
{
    /// <summary>
    /// Makes one self-contained page of a session: no network, no other files, for screen and paper. The page is well-formed XML as
    /// well as HTML. The same session and options give the same text.
    /// </summary>
    public static class ReportBuilder
    {
        /// <summary>The whole page; write it as UTF-8.</summary>
        public static string Build(SessionRecorder session, ReportOptions options)
        {
            var html = new HtmlWriter();
            var data = new ReportData(session, options);
            html.Raw("<!DOCTYPE html>\n<html lang=\"en\" data-scheme=\"auto\">\n<head>\n<meta charset=\"utf-8\"/>\n")
                .Raw("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n")
                .Raw("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\"/>\n")
                .Raw("<title>").Text(options.Title).Raw("</title>\n<style>\n").Raw(ReportStyle.Css).Raw("</style>\n</head>\n<body>\n");
            DrawHeader(html, data);
            html.Raw("<main>\n");
            DrawScreen(html, data);
            if (data.Shots.Length > 0)
            {
                Section(html, "Shooters and timeline");
                ReportTables.Shooters(html, data);
                html.Raw("<h3>Shots in time</h3>\n");
                Timeline.Draw(html, data);
                html.Raw("<p class=\"caption\">Numbers below a lane are the seconds between its shots. Bars at the foot: share of the screen in which a dot could not be seen; marks at the top: see the health of the recording.</p>\n</section>\n");
                Section(html, "Shots");
                html.Raw("<p class=\"hint\">Point at a row or a hole to see both; click to keep it. Arrows in “Split” mark a change of target.</p>\n");
                ReportTables.Shots(html, data);
                if (session.ShotCount > data.Shots.Length)
                    html.Raw("<p class=\"warning\">Only the first ").Integer(data.Shots.Length).Raw(" of ").Integer(session.ShotCount)
                        .Raw(" shots are shown; events.jsonl has them all.</p>\n");
                html.Raw("</section>\n");
            }

            if (data.Targets.Count > 0)
            {
                Section(html, "Targets");
                ReportTables.Targets(html, data);
                new TargetCards(html, data).Draw();
                html.Raw("</section>\n");
            }

            Section(html, "Health of the recording");
            HealthSection.Draw(html, data);
            html.Raw("</section>\n");
            DrawRules(html, data);
            html.Raw("</main>\n<footer><p>Written by Range ").Text(session.Header?.Version).Raw(".</p></footer>\n<script>\n")
                .Raw(ReportScript.JavaScript).Raw("</script>\n</body>\n</html>\n");
            return html.ToString();
        }

        /// <summary>The page as the bytes of a file: UTF-8 without byte order mark.</summary>
        public static byte[] BuildUtf8(SessionRecorder session, ReportOptions options) =>
            new UTF8Encoding(false).GetBytes(Build(session, options));

        private static void Section(HtmlWriter html, string name) => html.Raw("<section>\n<h2>").Raw(name).Raw("</h2>\n");

        private static void DrawHeader(HtmlWriter html, ReportData data)
        {
            SessionHeader? header = data.Session.Header;
            html.Raw("<header>\n<h1>").Text(data.Options.Title).Raw("</h1>\n<p class=\"meta\">");
            if (header != null)
            {
                html.Raw("From ");
                for (int i = 0; i < header.Inputs.Count; i++)
                    html.Raw(i == 0 ? "<b>" : " and <b>").Text(FileName(header.Inputs[i].Path)).Raw("</b>");
                html.Raw(header.Inputs.Count == 0 ? "no input · detector <b>" : " · detector <b>").Text(header.Detector).Raw("</b>");
                html.Raw(" · calibration <b>").Text(header.Calibration == null ? "none" : FileName(header.Calibration)).Raw("</b>");
                if (header.Seed is long seed)
                    html.Raw(" · seed <b>").Integer(seed).Raw("</b>");
            }

            if (data.Options.Scene != null)
                html.Raw(" · scene <b>").Text(data.Options.Scene.Name).Raw("</b>");
            html.Raw("</p>\n<dl class=\"tiles\">");
            Tile(html, "Duration").Column(data.Session.IsEnded ? data.Session.Summary.SecondsMedia : double.NaN, 1).Raw(" <small>s</small></dd></div>");
            Tile(html, "Shots").Integer(data.Session.ShotCount).Raw("</dd></div>");
            if (data.IsScored)
                DrawResultTiles(html, data.All);
            html.Raw("</dl>\n</header>\n");
        }

        private static void DrawResultTiles(HtmlWriter html, ReportTotals all)
        {
            Tile(html, "Hits").Integer(all.Hits);
            if (all.Shots > 0)
                html.Raw(" <small>").Percent((double)all.Hits / all.Shots).Raw("</small>");
            html.Raw("</dd></div>");
            Tile(html, "Misses").Integer(all.Misses).Raw("</dd></div>");
            Tile(html, "No-shoot hits", all.Mistakes > 0).Integer(all.Mistakes).Raw("</dd></div>");
            Tile(html, "Points").Column(all.Points, 0).Raw("</dd></div>");
            Tile(html, "Score").Column(all.Score, 1).Raw("</dd></div>");
        }

        private static HtmlWriter Tile(HtmlWriter html, string name, bool isBad = false) =>
            html.Raw(isBad ? "<div class=\"bad\"><dt>" : "<div><dt>").Raw(name).Raw("</dt><dd>");

        private static void DrawScreen(HtmlWriter html, ReportData data)
        {
            Section(html, data.HasScreen ? "On the screen" : "In the camera's picture");
            if (data.Shots.Length == 0)
                html.Raw("<p class=\"empty\"><b>No shots were fired.</b>The section on health tells what the camera saw instead.</p>\n");
            if (data.Shots.Length == 0 && data.Options.Scene == null && data.Options.BackgroundPng == null)
            {
                html.Raw("</section>\n");
                return;
            }

            new ScreenPicture(html, data).Draw();
            html.Raw("<ul class=\"legend\">");
            foreach (ReportTotals shooter in data.Shooters)
            {
                html.Raw("<li>");
                ShotText.Shooter(html, shooter);
                html.Raw("</li>");
            }

            if (data.IsScored && data.Shots.Length > 0)
            {
                Legend(html, "", "hit");
                Legend(html, " miss", "miss");
            }

            if (data.All.Mistakes > 0)
                Legend(html, " mistake", "no-shoot hit");
            html.Raw("</ul>\n<p class=\"caption\">");
            if (!data.HasScreen)
                html.Raw("There is no screen calibration: places are pixels of the camera, so nothing could be scored. ");
            else if (data.Options.Scene == null)
                html.Raw("There is no scene: only the places of the shots are known. ");
            else
                html.Raw("Targets stand as they did ").Column(data.PictureTimeS, 2).Raw(" s into the scene; dotted lines are the ways of moving ones, dashed outlines where a moving target stood when it was hit. ");
            html.Raw("A tinted ellipse holds the place where the light began with 95 %; it is drawn where it is larger than the mark.</p>\n</section>\n");
        }

        private static void Legend(HtmlWriter html, string kind, string name) => html
            .Raw("<li class=\"s0\"><svg viewBox=\"-10 -10 20 20\" aria-hidden=\"true\"><g class=\"hole").Raw(kind)
            .Raw("\"><circle class=\"halo\" r=\"6\"/><circle class=\"dot\" r=\"4.5\"/>")
            .Raw(kind == " mistake" ? "<path class=\"cross\" d=\"M-8 -8L8 8M-8 8L8 -8\"/>" : "").Raw("</g></svg>").Raw(name).Raw("</li>");

        private static void DrawRules(HtmlWriter html, ReportData data)
        {
            Section(html, "How to read the numbers");
            html.Raw("<ul class=\"how\">\n<li><b>Time</b> is the middle of the exposure of the first frame that shows the shot's light, in seconds from the session's first frame.</li>\n")
                .Raw("<li><b>Split</b> is the time since the same shooter's shot before; with an arrow the target changed: a transition.</li>\n")
                .Raw("<li><b>Target and zone</b> are what the shot met in the scene as it stood when the light left the laser, not when the software noticed.</li>\n<li><b>Score</b>: ")
                .Text(data.Options.ScoringRule).Raw("</li>\n")
                .Raw("<li><b>Zone sure</b> is the probability that the true point lies in the zone that was counted, given the shot's uncertainty; below 80 % it is marked.</li>\n")
                .Raw("<li><b>Mean radius</b> is the hits' mean distance from the middle of their group, <b>extreme spread</b> the distance between the two furthest hits, <b>SD</b> the standard deviation; “Group lies” is the group's middle seen from the middle of the most valuable zone.</li>\n")
                .Raw("</ul>\n");
            if (data.Session.Header is SessionHeader header && header.Inputs.Count > 0)
            {
                html.Raw("<details><summary>Inputs</summary><ul>");
                foreach (SessionInput input in header.Inputs)
                    html.Raw("<li style=\"overflow-wrap:anywhere\">").Text(input.Path).Raw(input.Sha256 == null ? "" : " · SHA-256 ").Text(input.Sha256).Raw("</li>");
                html.Raw("</ul></details>\n");
            }

            html.Raw("</section>\n");
        }

        private static string FileName(string path) => path.Substring(path.LastIndexOfAny(new[] { '/', '\\' }) + 1);
    }
}
