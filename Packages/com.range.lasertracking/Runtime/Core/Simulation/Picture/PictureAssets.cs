using System;
using System.Numerics;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Simulation
{
    /// <summary>What every drawn picture is put together from: the empty bay and one sprite a target. Immutable after construction.</summary>
    internal sealed class PictureAssets
    {
        private readonly TargetSprite[] _sprites;
        private readonly byte[] _background;

        /// <param name="view">The scene.</param>
        /// <param name="projector">Size of the picture and what moves behind the targets.</param>
        /// <param name="seed">Of the moving content.</param>
        public PictureAssets(SceneView view, ProjectorSettings projector, int seed)
        {
            View = view;
            Width = projector.Width;
            Height = projector.Height;
            Vector2D size = view.Scene.ScreenSizeM;
            // Pixel centres are integers: the picture's left edge lies at -0.5.
            ScreenToPicture = PlaneMap.Scale(Width / size.X, Height / size.Y, -0.5, -0.5);
            var room = new RoomPainter(view);
            _background = PaintBackground(room, view.Scene.ScreenSizeM);
            if (projector.Content != ProjectedContent.Bay)
                MovingContent = projector.Content == ProjectedContent.Calibration ? (IPictureContent)new PatternContent(projector) : new MovingContent(projector, seed);
            _sprites = new TargetSprite[view.Scene.Objects.Count];
            foreach (int i in view.FarToNear)
                _sprites[i] = PaintSprite(view, i, room.FloorM);
        }

        public SceneView View { get; }

        public int Width { get; }

        public int Height { get; }

        /// <summary>Screen m to picture px.</summary>
        public PlaneMap ScreenToPicture { get; }

        /// <summary>The empty bay, BGRA without padding.</summary>
        public ReadOnlySpan<byte> Background => _background;

        /// <summary>What moves behind the targets in place of the bay; null: nothing.</summary>
        public IPictureContent? MovingContent { get; }

        /// <summary>Objects drawn over it, far to near; the calibration's pictures have none.</summary>
        public ReadOnlySpan<int> Targets => MovingContent is PatternContent ? default : View.FarToNear;

        public PixelRect Bounds => new PixelRect(0, 0, Width, Height);

        public TargetSprite Sprite(int objectIndex) => _sprites[objectIndex];

        /// <summary>From a target's plane (m) to picture px at a time.</summary>
        public PlaneMap TargetToPicture(int objectIndex, double timeS) => ScreenToPicture * View.TargetToScreen(objectIndex, timeS);

        private TargetSprite PaintSprite(SceneView view, int index, double floorM)
        {
            SceneObject item = view.Scene.Objects[index];
            TargetDefinition definition = item.Target!;
            TargetToPicture(index, 0).Jacobian(default, out double a, out double b, out double c, out double d);
            double texelM = 0.9 / Math.Sqrt(Math.Max(1e-9, Math.Abs(a * d - b * c)));
            // A target in the viewer's face would ask for a sprite without end.
            texelM = Math.Max(texelM, Math.Max(definition.SizeM.X, definition.SizeM.Y) / 1500);
            double middle = view.Scene.Surface.InverseTransformPoint(item.RestPose.Position).Y;
            double stand = SceneView.Moves(item) ? 0 : Math.Max(0, Math.Min(1.5, middle - definition.SizeM.Y / 2 - floorM));
            return new TargetSprite(new TargetPainter(definition, stand, index * 100), texelM);
        }

        private byte[] PaintBackground(RoomPainter room, Vector2D size)
        {
            var pixels = new byte[Width * Height * 4];
            for (int y = 0; y < Height; y++)
            {
                for (int x = 0; x < Width; x++)
                {
                    Vector3D surface = Axes.ScreenToSurface(new Vector3D((x + 0.5) / Width * size.X, (y + 0.5) / Height * size.Y, 0), size);
                    Vector3 color = room.Color(new Vector2D(surface.X, surface.Y));
                    int offset = (y * Width + x) * 4;
                    // Dither: gradients would show steps otherwise.
                    float dither = (CounterRandom.Pixel((uint)offset, 7) >> 8) * (1f / 16777216);
                    pixels[offset] = ToByte(color.X + dither);
                    pixels[offset + 1] = ToByte(color.Y + dither);
                    pixels[offset + 2] = ToByte(color.Z + dither);
                    pixels[offset + 3] = 255;
                }
            }

            return pixels;
        }

        private static byte ToByte(float value) => (byte)Math.Max(0, Math.Min(255, value));
    }
}
