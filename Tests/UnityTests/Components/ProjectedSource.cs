using System;
using System.Collections.Generic;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>A camera that sees what is projected, obliquely, with blur and noise; every opened one looks at the same picture.</summary>
    internal sealed class ProjectedSource : IFrameSource
    {
        public const int Width = 960;
        public const int Height = 600;

        private readonly ProjectedSource _shared;
        private readonly System.Random _random = new System.Random(3);
        private readonly Homography _toPlace;
        private byte[] _light = new byte[Width * Height];
        private static readonly byte[] Dark = new byte[0];

        private byte[]? _shown;
        private volatile bool _isDisposed;
        private int _index;

        public ProjectedSource(ProjectedSource? shared = null)
        {
            _shared = shared ?? this;
            Vector2D[] corners = { new Vector2D(70.3, 61.7), new Vector2D(880.2, 40.9), new Vector2D(905.6, 540.3), new Vector2D(52.8, 560.1) };
            Vector2D[] places = { new Vector2D(0, 0), new Vector2D(1, 0), new Vector2D(1, 1), new Vector2D(0, 1) };
            HomographyEstimator.TryFit(corners, places, out Homography fitted, out _);
            _toPlace = fitted;
        }

        public bool IsCovered { get; set; }

        public FrameSourceInfo Info { get; } = new FrameSourceInfo("oblique camera", Width, Height, 30, null);

        public IReadOnlyList<FrameProblem> Problems { get; } = new List<FrameProblem>();

        /// <summary>Where the camera sees a place of the picture, given as shares of it.</summary>
        public Vector2D ToImagePx(Vector2D place) => _toPlace.Inverse.Map(place);

        /// <summary>Looks at the texture; null: a dark screen.</summary>
        public void Show(Texture2D? texture)
        {
            byte[] shown = texture == null ? Dark : Projector.Shown(texture);
            if (ReferenceEquals(shown, _shown))
                return;
            _shown = shown;
            var light = new byte[Width * Height];
            for (int y = 0; y < Height; y++)
            for (int x = 0; x < Width; x++)
            {
                double sum = 0;
                // Four by four samples a pixel, over a width of one and a half: the lens.
                for (int i = 0; i < 16 && shown.Length > 0 && !IsCovered; i++)
                {
                    Vector2D place = _toPlace.Map(new Vector2D(x + (i % 4 - 1.5) * 0.375, y + (i / 4 - 1.5) * 0.375));
                    if (place.X >= 0 && place.Y >= 0 && place.X < 1 && place.Y < 1)
                        sum += shown[4 * ((texture!.height - 1 - (int)(place.Y * texture.height)) * texture.width + (int)(place.X * texture.width))];
                }

                light[y * Width + x] = (byte)(20 + sum / 16 * 0.6);
            }

            lock (_shared)
                _shared._light = light;
        }

        public bool TryRead(Frame frame)
        {
            Thread.Sleep(10);
            if (_isDisposed)
                return false;
            long timeUs = _index * 33333L;
            frame.Begin(_index++, timeUs);
            frame.Color.Reset(PixelFormat.Gray8, Width, Height, timeUs);
            byte[] light;
            lock (_shared)
                light = _shared._light;
            Span<byte> pixels = frame.Color.Bytes;
            for (int i = 0; i < pixels.Length; i++)
                pixels[i] = (byte)(light[i] + (_random.Next() & 3));
            return true;
        }

        public void Dispose() => _isDisposed = true;
    }
}
