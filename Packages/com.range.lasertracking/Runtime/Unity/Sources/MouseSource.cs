using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// A click is a shot, for work at a desk: makes the frames of a camera that sees the screen straight, and shows a laser's dot in them
    /// where the scene's camera ray through the mouse meets the screen. From there on all is as with a camera.
    /// </summary>
    [CreateAssetMenu(fileName = "Mouse", menuName = "Laser Tracking/Mouse Source")]
    public sealed class MouseSource : FrameSourceAsset
    {
        private const int WidthPx = 960;
        private const int FlashFrames = 3;
        private const int DarkFrames = 2;
        private const int MostClicks = 32;
        private const double DotSigmaPx = 2.4;
        private const int DotReachPx = 10;

        [NonSerialized]
        private PushedFrameSource? _frames;

        [NonSerialized]
        private Frame? _next;

        private LaserRange? _range;
        private RangeCalibration? _calibration;
        private byte[] _noise = Array.Empty<byte>();
        private readonly Queue<Vector2D> _clicksPx = new Queue<Vector2D>(MostClicks);
        private Vector2D _dotPx;
        private int _phase;
        private double _lastS = double.NegativeInfinity;
        private int _index;

        public override bool IsLive => true;

        /// <summary>Its own; where the screen has one the dots are drawn as that one's camera would see them.</summary>
        public override RangeCalibration? Calibration => _calibration;

        public override IFrameSource CreateSource(LaserRange range)
        {
            ScreenSurface? screen = range.Screen;
            if (screen == null || !screen.HasSize)
                throw new InputException("mouse source " + name, "its LaserRange " + range.name + (screen == null ? " has no screen" : " has a screen without size") + ", so a click is nowhere", "give it a ScreenSurface of the picture's size in metres");
            if (Camera.main == null)
                throw new InputException("mouse source " + name, "the scene has no main camera, so a click points nowhere", "tag the camera that draws the picture MainCamera");
#if !ENABLE_LEGACY_INPUT_MANAGER
            ShotEmitters.Report(this, "mouse source " + name + ": this project reads input with the Input System package alone, so clicks do not come by themselves; set Player Settings > Active Input Handling to Both, or call Fire", false);
#endif
            _range = range;
            _calibration = screen.ReadCalibration() ?? Straight(screen.SizeM);
            _noise = MakeNoise(_calibration.ImageWidth * 4 * _calibration.ImageHeight);
            _index = 0;
            _lastS = double.NegativeInfinity;
            _clicksPx.Clear();
            _phase = FlashFrames + DarkFrames;
            _next = new Frame();
            return _frames = new PushedFrameSource(new FrameSourceInfo("mouse", _calibration.ImageWidth, _calibration.ImageHeight, 0, null));
        }

        /// <summary>Fires at a point of the window, as a click there would; for other pointers than the mouse.</summary>
        /// <param name="windowPx">Pixels from the lower left corner of the display that the main camera draws on.</param>
        public void Fire(Vector2 windowPx)
        {
            Camera camera = Camera.main;
            if (_range == null || _range.Screen == null || camera == null)
                return;
            Ray ray = camera.ScreenPointToRay(new Vector3(windowPx.x, windowPx.y, 0));
            ScreenSurface screen = _range.Screen;
            Vector3D from = screen.Pose.InverseTransformPoint(ray.origin.ToCore()), along = screen.Pose.InverseTransformDirection(ray.direction.ToCore());
            if (!(along.Z > 0 && from.Z < 0))
                return;
            Vector3D screenM = Axes.SurfaceToScreen(from + along * (-from.Z / along.Z), screen.SizeM);
            if (_clicksPx.Count < MostClicks)
                _clicksPx.Enqueue(_calibration!.Screen.ToImagePx(new Vector2D(screenM.X, screenM.Y)));
        }

        public override void UpdateSource()
        {
#if ENABLE_LEGACY_INPUT_MANAGER
            if (Input.GetMouseButtonDown(0) && Camera.main is Camera camera && camera != null && OutputDisplay.TryGetPlaceOn(camera.targetDisplay, Input.mousePosition, out Vector2 placePx))
                Fire(placePx);
#endif
            double nowS = Time.timeAsDouble;
            // While the detector is late its clicks wait: none is lost.
            if (_frames == null || !(nowS > _lastS) || !_frames.HasRoom)
                return;
            _lastS = nowS;
            if (++_phase > FlashFrames + DarkFrames && _clicksPx.Count > 0)
            {
                _dotPx = _clicksPx.Dequeue();
                _phase = 1;
            }

            Draw(_next!, (long)(nowS * 1e6), _phase <= FlashFrames);
            _frames.Push(_next!);
        }

        public override void ReleaseSource()
        {
            _frames?.Close();
            _next?.Dispose();
            _frames = null;
            _next = null;
            _range = null;
        }

        private static RangeCalibration Straight(Vector2D sizeM)
        {
            int height = (int)Math.Round(Math.Max(64, Math.Min(4 * WidthPx, WidthPx * sizeM.Y / sizeM.X)));
            double x = sizeM.X / WidthPx, y = sizeM.Y / height;
            // A pixel's centre is an integer, the picture begins half a pixel before.
            var toScreen = new Homography(new[] { x, 0, x / 2, 0, y, y / 2, 0, 0, 1 });
            return new RangeCalibration(new ScreenGeometry(toScreen, sizeM), WidthPx, height, null);
        }

        private void Draw(Frame frame, long timeUs, bool isLit)
        {
            int width = _calibration!.ImageWidth, height = _calibration.ImageHeight;
            frame.Begin(_index, timeUs);
            frame.Color.Reset(PixelFormat.Bgra32, width, height, timeUs);
            Span<byte> pixels = frame.Color.Bytes;
            // The same noise from another place in every frame: a picture without any would be called frozen.
            new ReadOnlySpan<byte>(_noise, _index * 4 * 997 % 65536, pixels.Length).CopyTo(pixels);
            _index++;
            if (!isLit || !(_dotPx.X >= 0 && _dotPx.Y >= 0 && _dotPx.X <= width - 1 && _dotPx.Y <= height - 1))
                return;
            int centerX = (int)Math.Round(_dotPx.X), centerY = (int)Math.Round(_dotPx.Y);
            for (int y = Math.Max(0, centerY - DotReachPx); y <= Math.Min(height - 1, centerY + DotReachPx); y++)
            {
                for (int x = Math.Max(0, centerX - DotReachPx); x <= Math.Min(width - 1, centerX + DotReachPx); x++)
                {
                    double dx = x - _dotPx.X, dy = y - _dotPx.Y;
                    AddLight(pixels.Slice(y * frame.Color.Stride + x * 4, 3), 900 * Math.Exp(-(dx * dx + dy * dy) / (2 * DotSigmaPx * DotSigmaPx)));
                }
            }
        }

        /// <summary>A green laser that saturates in its middle.</summary>
        private static void AddLight(Span<byte> blueGreenRed, double light)
        {
            blueGreenRed[0] = (byte)Math.Min(255, blueGreenRed[0] + light * 0.3);
            blueGreenRed[1] = (byte)Math.Min(255, blueGreenRed[1] + light);
            blueGreenRed[2] = (byte)Math.Min(255, blueGreenRed[2] + light * 0.25);
        }

        private static byte[] MakeNoise(int length)
        {
            var random = new System.Random(1);
            var noise = new byte[length + 65536];
            for (int i = 0; i < noise.Length; i++)
                noise[i] = (byte)(30 + random.Next(4));
            return noise;
        }
    }
}
