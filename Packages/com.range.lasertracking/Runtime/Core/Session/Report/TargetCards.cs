using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Session
{
    /// <summary>One card for every target that was hit: its zones with the holes in its own plane, and the group's measures.</summary>
    internal sealed class TargetCards
    {
        private const double ViewSize = 300;
        private const int MostLabels = 60;
        private readonly HtmlWriter _html;
        private readonly ReportData _data;
        private readonly ScenePerspective? _perspective;
        private double _scale;
        private Vector2D _corner;

        public TargetCards(HtmlWriter html, ReportData data)
        {
            _html = html;
            _data = data;
            _perspective = data.Options.Scene == null ? null : new ScenePerspective(data.Options.Scene);
        }

        public void Draw()
        {
            _html.Raw("<div class=\"cards\">\n");
            foreach (ReportTotals totals in _data.Targets)
            {
                var hits = new List<ReportShot>();
                foreach (ReportShot shot in _data.Shots)
                {
                    if (shot.TargetName == totals.Name && shot.ObjectIndex == totals.Number)
                        hits.Add(shot);
                }

                if (hits.Count > 0)
                    DrawCard(totals, hits);
            }

            _html.Raw("</div>\n");
        }

        private void DrawCard(ReportTotals totals, List<ReportShot> hits)
        {
            TargetDefinition? definition = hits[0].Definition;
            bool mistake = totals.Mistakes > 0;
            _html.Raw(mistake ? "<article class=\"target mistake\"><h3>" : "<article class=\"target\"><h3>").Text(totals.Name);
            if (mistake)
                _html.Raw(" <span class=\"badge\">no-shoot hit</span>");
            _html.Raw("</h3>\n<p class=\"sum\">").Integer(totals.Shots).Raw(totals.Shots == 1 ? " hit" : " hits").Raw(" · ")
                .Column(totals.Points, 0).Raw(" points</p>\n");
            Frame(definition, hits, out double width, out double height);
            _html.Raw("<svg viewBox=\"0 0 ").Number(width, 1).Raw(" ").Number(height, 1).Raw("\" role=\"group\" aria-label=\"Holes in ")
                .Text(totals.Name).Raw("\">\n");
            var labels = new LabelPlacer(width, height);
            if (definition != null)
            {
                TargetDrawing.Draw(_html, definition, 72, Map);
                DrawZoneNames(definition, labels);
            }

            DrawGroup(hits, definition);
            foreach (ReportShot hit in hits)
            {
                Map(hit.Event.Hit.LocalPointM, out Vector2D at);
                labels.Take(at.X, at.Y, 9, 9);
            }

            foreach (ReportShot hit in hits)
                DrawHole(hit, hits.Count <= MostLabels ? labels : null);
            DrawScaleBar(width, height);
            _html.Raw("</svg>\n");
            DrawMeasures(hits, definition);
            _html.Raw("</article>\n");
        }

        /// <summary>Fits the zones and the holes into the view.</summary>
        private void Frame(TargetDefinition? definition, List<ReportShot> hits, out double width, out double height)
        {
            var points = new List<Vector2D>();
            if (definition != null)
            {
                foreach (TargetZone zone in definition.Zones)
                    points.AddRange(TargetDrawing.Outline(zone, 36));
            }

            foreach (ReportShot hit in hits)
            {
                if (hit.Event.Hit.LocalPointM.IsFinite)
                    points.Add(hit.Event.Hit.LocalPointM);
            }

            if (points.Count == 0)
                points.Add(default);
            TargetDrawing.Bounds(points, out Vector2D low, out Vector2D high);
            Vector2D size = high - low;
            double largest = Math.Max(Math.Max(size.X, size.Y), 0.02);
            double pad = 0.06 * largest;
            _scale = ViewSize / (largest + 2 * pad);
            double narrow = Math.Max(size.X, 0.4 * largest), flat = Math.Max(size.Y, 0.4 * largest);
            _corner = new Vector2D((low.X + high.X) / 2 - narrow / 2 - pad, (low.Y + high.Y) / 2 + flat / 2 + pad);
            width = (narrow + 2 * pad) * _scale;
            height = (flat + 2 * pad) * _scale + 22;
        }

        private bool Map(Vector2D localM, out Vector2D view)
        {
            view = new Vector2D((localM.X - _corner.X) * _scale, (_corner.Y - localM.Y) * _scale);
            return view.IsFinite;
        }

        private void DrawZoneNames(TargetDefinition definition, LabelPlacer labels)
        {
            double lastY = double.NegativeInfinity;
            for (int i = definition.Zones.Count - 1; i >= 0; i--)
            {
                TargetZone zone = definition.Zones[i];
                if (!TargetDrawing.TryMap(TargetDrawing.Outline(zone, 36), Map, out List<Vector2D> view))
                    continue;
                TargetDrawing.Bounds(view, out Vector2D low, out Vector2D high);
                double x = (low.X + high.X) / 2, y = low.Y + 13, width = 7.0 * zone.Name.Length;
                if (Math.Abs(y - lastY) < 12 && definition.Kind != TargetKind.RingPaper)
                    y = high.Y - 6;
                if (high.Y - low.Y < 16 || high.X - low.X < width + 4 || Math.Abs(y - lastY) < 12)
                    continue;
                lastY = y;
                labels.Take(x, y - 4, width, 12);
                bool dark = definition.Kind == TargetKind.RingPaper && (2 * i < definition.Zones.Count - 1 || definition.Zones.Count == 1);
                _html.Raw(dark ? "<text class=\"zone light\" x=\"" : "<text class=\"zone\" x=\"").Number(x, 1).Raw("\" y=\"").Number(y, 1)
                    .Raw("\">").Text(zone.Name).Raw("</text>");
            }

            _html.Raw("\n");
        }

        private void DrawGroup(List<ReportShot> hits, TargetDefinition? definition)
        {
            if (hits.Count < 2)
                return;
            GroupStatistics group = GroupStatistics.Of(Points(hits));
            if (!Map(group.Center, out Vector2D at))
                return;
            _html.Raw("<g class=\"group\"><title>Mean radius about the group's centre</title><circle cx=\"").Number(at.X, 1).Raw("\" cy=\"").Number(at.Y, 1)
                .Raw("\" r=\"").Number(group.MeanRadius * _scale, 1).Raw("\"/><path d=\"M").Number(at.X - 6, 1).Raw(" ").Number(at.Y, 1)
                .Raw("h12M").Number(at.X, 1).Raw(" ").Number(at.Y - 6, 1).Raw("v12\"/></g>\n");
        }

        private void DrawHole(ReportShot hit, LabelPlacer? labels)
        {
            if (!Map(hit.Event.Hit.LocalPointM, out Vector2D at))
                return;
            _html.Raw("<a class=\"hole ").Raw(ReportData.ColorClass(_data.Shooters[hit.ShooterIndex].Number)).Raw(hit.IsMistake ? " mistake" : "")
                .Raw("\" href=\"#shot-").Integer(hit.Id).Raw("\" data-shot=\"").Integer(hit.Id).Raw("\">");
            ShotText.Title(_html, _data, hit);
            if (_perspective != null && hit.ObjectIndex >= 0 && hit.Event.HasScreenPosition &&
                _perspective.TryToTargetMm2(_data.Options.Scene!.Objects[hit.ObjectIndex], _data.SceneTimeS(hit), hit.Event.Hit.LocalPointM,
                    hit.Event.ScreenCovarianceMm2, out Covariance2D mm2))
                new UncertaintyEllipse(mm2.Transform(_scale * 1e-3, 0, 0, -_scale * 1e-3)).Draw(_html, at.X, at.Y);
            ShotText.Mark(_html, hit, at, 2.8);
            if (labels != null)
            {
                Vector2D label = labels.Place(at.X, at.Y, 9.0 * (hit.Id < 10 ? 1 : hit.Id < 100 ? 2 : 3), 13, 6);
                _html.Raw("<text x=\"").Number(label.X, 1).Raw("\" y=\"").Number(label.Y + 4.5, 1).Raw("\">").Integer(hit.Id).Raw("</text>");
            }

            _html.Raw("</a>\n");
        }

        private void DrawScaleBar(double width, double height)
        {
            double[] lengthsMm = { 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000 };
            int chosen = 0;
            for (int i = 0; i < lengthsMm.Length; i++)
            {
                if (lengthsMm[i] * 1e-3 * _scale <= 0.4 * width)
                    chosen = i;
            }

            double lengthMm = lengthsMm[chosen];
            _html.Raw("<g class=\"bar\"><path d=\"M8 ").Number(height - 11, 1).Raw("v6h").Number(lengthMm * 1e-3 * _scale, 1).Raw("v-6\"/><text x=\"")
                .Number(14 + lengthMm * 1e-3 * _scale, 1).Raw("\" y=\"").Number(height - 5, 1).Raw("\">");
            if (lengthMm >= 10)
                _html.Number(lengthMm / 10, 0).Raw(" cm");
            else
                _html.Number(lengthMm, 0).Raw(" mm");
            _html.Raw("</text></g>\n");
        }

        private void DrawMeasures(List<ReportShot> hits, TargetDefinition? definition)
        {
            GroupStatistics group = GroupStatistics.Of(Points(hits));
            Vector2D aim = definition == null ? default : TargetDrawing.Middle(TargetDrawing.AimZone(definition));
            Vector2D off = (group.Center - aim) * 1000;
            _html.Raw("<dl>");
            if (hits.Count >= 2)
            {
                Measure("Mean radius", group.MeanRadius * 1000);
                Measure("Extreme spread", group.ExtremeSpread * 1000);
                Measure("SD across", group.StandardDeviation.X * 1000);
                Measure("SD up", group.StandardDeviation.Y * 1000);
            }

            _html.Raw("<div class=\"wide\"><dt>").Raw(hits.Count >= 2 ? "Group lies" : "Hit lies").Raw("</dt><dd>").Column(Math.Abs(off.X), 0)
                .Raw(off.X < 0 ? " mm left, " : " mm right, ").Column(Math.Abs(off.Y), 0).Raw(off.Y < 0 ? " mm low" : " mm high").Raw("</dd></div></dl>\n");
        }

        private void Measure(string name, double mm) =>
            _html.Raw("<div><dt>").Raw(name).Raw("</dt><dd>").Column(mm, 0).Raw(" mm</dd></div>");

        private static List<Vector2D> Points(List<ReportShot> hits)
        {
            var points = new List<Vector2D>();
            foreach (ReportShot hit in hits)
            {
                if (hit.Event.Hit.LocalPointM.IsFinite)
                    points.Add(hit.Event.Hit.LocalPointM);
            }

            return points;
        }
    }
}
