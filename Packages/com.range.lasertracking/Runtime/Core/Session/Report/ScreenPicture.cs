using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Session
{
    /// <summary>
    /// The projected picture with the targets as they stood and every shot where it landed. Without a screen calibration: the
    /// camera's picture with the shots in pixels.
    /// </summary>
    internal sealed class ScreenPicture
    {
        private const double ViewWidth = 1000;
        private const int MostLabels = 300;
        private const int MostStandingGhosts = 60;
        private readonly HtmlWriter _html;
        private readonly ReportData _data;
        private readonly SceneModel? _scene;
        private readonly ScenePerspective? _perspective;
        private readonly double _scale;
        private readonly double _viewHeight;
        private readonly LabelPlacer _labels;

        public ScreenPicture(HtmlWriter html, ReportData data)
        {
            _html = html;
            _data = data;
            Vector2D size = data.HasScreen ? data.ScreenSizeM ?? Extent(shot => shot.Event.HasScreenPosition ? shot.Event.ScreenM : default)
                : data.Options.ImageSizePx ?? Extent(shot => shot.Event.Shot.Dot.PositionPx);
            _scale = ViewWidth / size.X;
            _viewHeight = Math.Round(size.Y * _scale, 1);
            _labels = new LabelPlacer(ViewWidth, _viewHeight);
            _scene = data.HasScreen ? data.Options.Scene : null;
            _perspective = _scene == null ? null : new ScenePerspective(_scene);
        }

        /// <summary>The SVG element.</summary>
        public void Draw()
        {
            _html.Raw("<svg class=\"picture\" viewBox=\"0 0 1000 ").Number(_viewHeight, 1)
                .Raw("\" role=\"group\" aria-label=\"The ").Raw(_data.HasScreen ? "screen" : "camera picture").Raw(" with ")
                .Integer(_data.Shots.Length).Raw(" shots\">\n");
            _html.Raw("<defs><pattern id=\"hatch\" width=\"9\" height=\"9\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">")
                .Raw("<rect width=\"9\" height=\"9\" fill=\"#fff\"/><rect width=\"3\" height=\"9\" fill=\"#d6423c\" opacity=\"0.55\"/></pattern></defs>\n")
                .Raw("<rect class=\"sheet\" width=\"1000\" height=\"").Number(_viewHeight, 1).Raw("\"/>\n");
            bool hasBackground = _data.Options.BackgroundPng is byte[] png && DrawBackground(png);
            if (_scene != null)
                DrawScene(_scene, hasBackground);
            foreach (ReportShot shot in _data.Shots)
            {
                if (TryPlace(shot, out Vector2D at))
                    _labels.Take(at.X, at.Y, 12, 12);
            }

            foreach (ReportShot shot in _data.Shots)
                DrawShot(shot);
            _html.Raw("</svg>\n");
        }

        private bool DrawBackground(byte[] png)
        {
            _html.Raw("<image width=\"1000\" height=\"").Number(_viewHeight, 1)
                .Raw("\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,").Raw(Convert.ToBase64String(png)).Raw("\"/>\n");
            return true;
        }

        private void DrawScene(SceneModel scene, bool hasBackground)
        {
            _html.Raw(hasBackground ? "<g class=\"scene over\">\n" : "<g class=\"scene\">\n");
            if (!hasBackground)
                DrawScenery(scene);
            List<int> order = FarthestFirst(scene);
            foreach (int index in order)
                DrawTravel(scene.Objects[index]);
            foreach (int index in order)
                DrawTarget(scene.Objects[index]);
            _html.Raw("</g>\n");
            foreach (int index in order)
                DrawName(scene.Objects[index]);
        }

        private void DrawScenery(SceneModel scene)
        {
            foreach (SceneObject thing in scene.Objects)
            {
                if (thing.Target != null)
                    continue;
                foreach (SceneCollider collider in thing.Colliders)
                {
                    List<Vector2D> outline = _perspective!.Outline(thing, collider, _data.PictureTimeS);
                    for (int i = 0; i < outline.Count; i++)
                        outline[i] = Clamp(outline[i] * _scale);
                    if (outline.Count > 2)
                        TargetDrawing.Path(_html, outline, "scenery");
                }
            }
        }

        private List<int> FarthestFirst(SceneModel scene)
        {
            var order = new List<int>();
            for (int i = 0; i < scene.Objects.Count; i++)
            {
                if (scene.Objects[i].Target != null)
                    order.Add(i);
            }

            double Distance(int index) => _perspective!.DistanceTo(scene.Objects[index].PoseAt(_data.PictureTimeS).Position);
            order.Sort((a, b) => Distance(a) != Distance(b) ? Distance(b).CompareTo(Distance(a)) : a.CompareTo(b));
            return order;
        }

        private void DrawTravel(SceneObject target)
        {
            if (target.Motion.Kind == MotionKind.None)
                return;
            var points = new List<Vector2D>();
            for (int i = 0; i <= 48; i++)
            {
                if (!MapAt(target, target.Motion.PeriodS * i / 48 - target.Motion.PhaseS, default, out Vector2D view))
                    return;
                points.Add(view);
            }

            TargetDrawing.Path(_html, points, "travel", false);
        }

        private void DrawTarget(SceneObject target) => TargetDrawing.Draw(_html, target.Target!, 40,
            (Vector2D local, out Vector2D view) => MapAt(target, _data.PictureTimeS, local, out view));

        private void DrawName(SceneObject target)
        {
            TargetDefinition definition = target.Target!;
            TargetZone outer = definition.Zones[definition.Zones.Count - 1];
            if (!TargetDrawing.TryMap(TargetDrawing.Outline(outer, 8),
                (Vector2D local, out Vector2D mapped) => MapAt(target, _data.PictureTimeS, local, out mapped), out List<Vector2D> view))
                return;
            TargetDrawing.Bounds(view, out Vector2D low, out Vector2D high);
            double width = 6.6 * target.Name.Length, x = Math.Max(width / 2, Math.Min(ViewWidth - width / 2, (low.X + high.X) / 2));
            double y = _labels.FirstFree(x, width, 13, high.Y + 10, low.Y - 8, high.Y + 23, low.Y - 21);
            y = Math.Max(12, Math.Min(_viewHeight - 5, y + 4));
            _html.Raw("<text class=\"name\" x=\"").Number(x, 1).Raw("\" y=\"").Number(y, 1).Raw("\">").Text(target.Name).Raw("</text>\n");
        }

        private void DrawShot(ReportShot shot)
        {
            if (!TryPlace(shot, out Vector2D at))
                return;
            string paint = ReportData.ColorClass(_data.Shooters[shot.ShooterIndex].Number);
            DrawGhosts(shot, paint);
            _html.Raw("<a class=\"hole ").Raw(paint).Raw(_data.MarkClass(shot))
                .Raw("\" id=\"hole-").Integer(shot.Id).Raw("\" href=\"#shot-").Integer(shot.Id).Raw("\" data-shot=\"").Integer(shot.Id).Raw("\">");
            ShotText.Title(_html, _data, shot);
            Covariance2D covariance = _data.HasScreen ? shot.Event.ScreenCovarianceMm2.Transform(_scale * 1e-3, 0, 0, _scale * 1e-3)
                : shot.Event.Shot.Dot.CovariancePx.Transform(_scale, 0, 0, _scale);
            new UncertaintyEllipse(covariance).Draw(_html, at.X, at.Y);
            ShotText.Mark(_html, shot, at, 4.5);
            if (_data.Shots.Length <= MostLabels)
            {
                double width = 9.5 * (shot.Id < 10 ? 1 : shot.Id < 100 ? 2 : 3);
                Vector2D label = _labels.Place(at.X, at.Y, width, 14, 7);
                _html.Raw("<text x=\"").Number(label.X, 1).Raw("\" y=\"").Number(label.Y + 5, 1).Raw("\">").Integer(shot.Id).Raw("</text>");
            }

            _html.Raw("</a>\n");
        }

        /// <summary>Moving targets as they stood for this shot: what it hit, faintly, while there are few; else when the shot is chosen.</summary>
        private void DrawGhosts(ReportShot shot, string paint)
        {
            if (_scene == null)
                return;
            double timeS = _data.SceneTimeS(shot);
            bool any = false;
            for (int i = 0; i < _scene.Objects.Count; i++)
            {
                SceneObject target = _scene.Objects[i];
                bool wanted = shot.Event.HasHit ? i == shot.ObjectIndex : _data.Shots.Length <= MostLabels;
                if (target.Target == null || target.Motion.Kind == MotionKind.None || !wanted)
                    continue;
                if (!any)
                    _html.Raw("<g class=\"ghost ").Raw(paint).Raw(shot.Event.HasHit && _data.Shots.Length <= MostStandingGhosts ? " hit" : "").Raw("\" data-shot=\"").Integer(shot.Id).Raw("\">");
                any = true;
                TargetDrawing.DrawGhost(_html, target.Target, 24, (Vector2D local, out Vector2D view) => MapAt(target, timeS, local, out view));
            }

            if (any)
                _html.Raw("</g>\n");
        }

        private bool MapAt(SceneObject target, double timeS, Vector2D localM, out Vector2D view)
        {
            bool seen = _perspective!.TryProject(target, timeS, localM, out Vector2D screenM);
            view = Clamp(screenM * _scale);
            return seen;
        }

        private bool TryPlace(ReportShot shot, out Vector2D at)
        {
            at = (_data.HasScreen ? shot.Event.ScreenM : shot.Event.Shot.Dot.PositionPx) * _scale;
            if (!at.IsFinite || _data.HasScreen && !shot.Event.HasScreenPosition)
                return false;
            at = new Vector2D(Math.Max(5, Math.Min(ViewWidth - 5, at.X)), Math.Max(5, Math.Min(_viewHeight - 5, at.Y)));
            return true;
        }

        /// <summary>Keeps far-off points near enough for every viewer's number range.</summary>
        private static Vector2D Clamp(Vector2D view) =>
            new Vector2D(Math.Max(-20000, Math.Min(20000, view.X)), Math.Max(-20000, Math.Min(20000, view.Y)));

        private Vector2D Extent(Func<ReportShot, Vector2D> place)
        {
            double right = 0, bottom = 0;
            foreach (ReportShot shot in _data.Shots)
            {
                Vector2D at = place(shot);
                if (!at.IsFinite)
                    continue;
                right = Math.Max(right, at.X);
                bottom = Math.Max(bottom, at.Y);
            }

            return right > 0 && bottom > 0 ? new Vector2D(right * 1.08, Math.Max(bottom * 1.08, right * 0.4)) : new Vector2D(16, 9);
        }
    }
}
