using System;
using System.Collections.Generic;
using System.Numerics;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Simulation
{
    /// <summary>Colours one type of target from its zones: steel, paper, cardboard. Values as in <see cref="RoomPainter"/>, with alpha.</summary>
    internal sealed class TargetPainter
    {
        private readonly TargetDefinition _definition;
        private readonly Vector2D[][] _corners;
        private readonly double _standM;
        private readonly int _layer;

        /// <param name="definition">What to paint.</param>
        /// <param name="standM">Length of the post below it; 0 = none.</param>
        /// <param name="layer">Makes the scuffs of one target differ from another's.</param>
        public TargetPainter(TargetDefinition definition, double standM, int layer)
        {
            _definition = definition;
            _standM = standM;
            _layer = layer;
            _corners = new Vector2D[definition.Zones.Count][];
            for (int i = 0; i < _corners.Length; i++)
            {
                IReadOnlyList<Vector2D> corners = definition.Zones[i].CornersM;
                _corners[i] = new Vector2D[corners.Count];
                for (int j = 0; j < corners.Count; j++)
                    _corners[i][j] = corners[j];
            }
        }

        /// <summary>Extent of everything painted, m: half width, top, bottom.</summary>
        public void Bounds(out double halfWidth, out double top, out double bottom)
        {
            double margin = _definition.Kind == TargetKind.RingPaper ? 1.12 : 1.04;
            halfWidth = Math.Max(_definition.SizeM.X / 2 * margin, _standM > 0 ? 0.14 : 0) + 0.01;
            top = _definition.SizeM.Y / 2 * margin + 0.01;
            bottom = -_definition.SizeM.Y / 2 * margin - _standM - 0.01;
        }

        /// <summary>Blue, green, red (0…255, multiplied by alpha) and alpha (0…1) at a point of the target's plane.</summary>
        public Vector4 Paint(Vector2D p, double texelM)
        {
            Vector4 color = default;
            if (_standM > 0)
                color = Stand(p, texelM);
            double outline = double.PositiveInfinity;
            for (int i = 0; i < _corners.Length; i++)
                outline = Math.Min(outline, Distance(i, p));
            if (_definition.Kind == TargetKind.RingPaper)
                outline = Math.Min(outline, ZoneDistance.Box(p, _definition.SizeM.X * 0.55, _definition.SizeM.Y * 0.55));
            float cover = Cover(outline, texelM);
            if (cover <= 0)
                return color;
            Vector3 face = Face(p, outline, texelM);
            return new Vector4(face * cover, cover) + color * (1 - cover);
        }

        private static float Cover(double distance, double texelM) => (float)Math.Max(0, Math.Min(1, 0.5 - distance / texelM));

        private static float Line(double distance, double width, double texelM) =>
            (float)Math.Max(0, Math.Min(1, 0.5 + (width / 2 - Math.Abs(distance)) / texelM));

        private double Distance(int zone, Vector2D p) => ZoneDistance.Of(_definition.Zones[zone], _corners[zone], p);

        private Vector3 Face(Vector2D p, double outline, double texelM)
        {
            switch (_definition.Kind)
            {
                case TargetKind.SteelPopper: return Steel(p, outline, texelM);
                case TargetKind.RingPaper: return Rings(p, texelM);
                case TargetKind.NoShoot: return NoShoot(p, outline, texelM);
                default: return Cardboard(p, outline, texelM);
            }
        }

        private Vector3 Steel(Vector2D p, double outline, double texelM)
        {
            float light = 0.86f + 0.14f * (float)(p.Y / _definition.SizeM.Y * 2);
            float scuff = ValueNoise.At(p.X * 60, p.Y * 60, _layer + 10);
            light *= scuff > 0.86f ? 0.8f : 0.97f + 0.03f * scuff;
            Vector3 color = new Vector3(206, 214, 216) * light;
            return Mix.Of(color, new Vector3(96, 98, 100), 0.75f * Cover(-outline - 0.012, Math.Max(texelM, 0.006)) * 1f);
        }

        private Vector3 Rings(Vector2D p, double texelM)
        {
            float grain = 0.98f + 0.02f * ValueNoise.At(p.X * 40, p.Y * 40, _layer + 20);
            Vector3 paper = new Vector3(214, 228, 232) * grain, ink = new Vector3(34, 32, 32), color = paper;
            int black = (_corners.Length + 1) / 2;
            for (int i = _corners.Length - 1; i >= 0; i--)
            {
                double distance = Distance(i, p);
                color = Mix.Of(color, i < black ? ink : paper, Cover(distance, texelM));
                color = Mix.Of(color, i < black ? paper * 0.9f : ink, 0.8f * Line(distance, 0.004, texelM));
            }

            return color;
        }

        private Vector3 Cardboard(Vector2D p, double outline, double texelM)
        {
            float grain = 0.93f + 0.09f * ValueNoise.At(p.X * 9, p.Y * 45, _layer + 30) + 0.04f * (float)(p.Y / _definition.SizeM.Y);
            Vector3 color = new Vector3(98, 150, 188) * grain;
            for (int i = 0; i < _corners.Length; i++)
                color = Mix.Of(color, new Vector3(48, 84, 112), 0.75f * Line(Distance(i, p), 0.006, texelM));
            return Mix.Of(color, new Vector3(58, 92, 118), 0.6f * Cover(-outline - 0.008, Math.Max(texelM, 0.006)));
        }

        private Vector3 NoShoot(Vector2D p, double outline, double texelM)
        {
            float grain = 0.97f + 0.03f * ValueNoise.At(p.X * 20, p.Y * 20, _layer + 40);
            Vector3 color = new Vector3(224, 226, 226) * grain;
            for (int i = 0; i < _corners.Length; i++)
                color = Mix.Of(color, new Vector3(170, 170, 172), 0.6f * Line(Distance(i, p), 0.005, texelM));
            // A red cross through the body says "do not shoot" from any distance.
            double half = Math.Min(_definition.SizeM.X, _definition.SizeM.Y) * 0.3;
            double x = (p.X + p.Y) / Math.Sqrt(2), y = (p.X - p.Y) / Math.Sqrt(2);
            double bar = Math.Min(ZoneDistance.Box(new Vector2D(x, y), half, half * 0.16), ZoneDistance.Box(new Vector2D(y, x), half, half * 0.16));
            color = Mix.Of(color, new Vector3(38, 30, 196), Cover(bar, texelM));
            return Mix.Of(color, new Vector3(38, 30, 170), 0.9f * Cover(-outline - 0.014, Math.Max(texelM, 0.006)));
        }

        private Vector4 Stand(Vector2D p, double texelM)
        {
            double top = -_definition.SizeM.Y / 2, foot = top - _standM;
            double post = ZoneDistance.Box(p - new Vector2D(0, (top + foot) / 2 + 0.05), 0.02, _standM / 2 + 0.05);
            double plate = ZoneDistance.Box(p - new Vector2D(0, foot + 0.015), 0.13, 0.015);
            float cover = Cover(Math.Min(post, plate), texelM);
            Vector3 wood = (_definition.Kind == TargetKind.SteelPopper ? new Vector3(70, 72, 74) : new Vector3(62, 94, 122)) *
                           (0.85f + 0.3f * (float)Math.Max(0, Math.Min(1, p.X / 0.04 + 0.5)));
            return new Vector4(wood * cover, cover);
        }
    }
}
