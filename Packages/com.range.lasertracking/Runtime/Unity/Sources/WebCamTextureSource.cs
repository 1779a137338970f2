using System;
using LaserTracking.Capture;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// A webcam through Unity itself, for those who have neither the Kinect nor the OpenCV package. Unity cannot lock its exposure, gain
    /// and white balance, and gives no times of its own: a frame's time is that of the Update in which it came.
    /// </summary>
    [CreateAssetMenu(fileName = "Webcam", menuName = "Laser Tracking/WebCamTexture Source")]
    public sealed class WebCamTextureSource : FrameSourceAsset
    {
        private const double SilentS = 2;

        [SerializeField]
        [Tooltip("Name of the camera as the operating system has it. Empty: the first one.")]
        private string _device = "";

        [SerializeField]
        [Min(64)]
        private int _widthPx = 1280;

        [SerializeField]
        [Min(64)]
        private int _heightPx = 720;

        [SerializeField]
        [Min(1)]
        private int _framesPerSecond = 30;

        [SerializeField]
        [Min(0)]
        [Tooltip("Seconds from the light to its frame, about.")]
        private float _latencyS = 0.08f;

        [NonSerialized]
        private PushedFrameSource? _frames;

        [NonSerialized]
        private Frame? _next;

        [NonSerialized]
        private WebCamTexture? _texture;

        private LaserRange? _told;
        private Color32[] _pixels = Array.Empty<Color32>();
        private double _lastFrameS;
        private int _index;

        public override bool IsLive => true;

        public override double LatencyS => _latencyS;

        public override IFrameSource CreateSource(LaserRange range)
        {
            string device = FindDevice();
            _texture = new WebCamTexture(device, _widthPx, _heightPx, _framesPerSecond);
            _texture.Play();
            _next = new Frame();
            _index = 0;
            _lastFrameS = Time.timeAsDouble;
            if (_told != range)
                ShotEmitters.Report(this, "webcam " + device + ": Unity cannot lock its exposure, gain and white balance; lock them in the camera's own program, or use the OpenCV source, which can", false);
            _told = range;
            return _frames = new PushedFrameSource(new FrameSourceInfo(device, _widthPx, _heightPx, _framesPerSecond, null));
        }

        public override void UpdateSource()
        {
            if (_texture == null || _frames == null)
                return;
            // Before the first picture Unity says 16 pixels.
            if (_texture.didUpdateThisFrame && _texture.width > 16)
            {
                _lastFrameS = Time.timeAsDouble;
                Read(_texture, _next!, (long)(_lastFrameS * 1e6));
                _frames.Push(_next!);
            }
            else if (Time.timeAsDouble > _lastFrameS + SilentS)
            {
                _lastFrameS = Time.timeAsDouble;
                if (Array.FindIndex(WebCamTexture.devices, there => there.name == _texture.deviceName) < 0)
                    _frames.Close();
            }
        }

        public override void ReleaseSource()
        {
            _frames?.Close();
            _next?.Dispose();
            if (_texture != null)
            {
                _texture.Stop();
                Destroy(_texture);
            }

            _frames = null;
            _next = null;
            _texture = null;
        }

        private string FindDevice()
        {
            WebCamDevice[] there = WebCamTexture.devices;
            if (there.Length == 0)
                throw new InputException("webcam source " + name, "no camera is there", "plug one in");
            if (_device.Length == 0)
                return there[0].name;
            if (Array.FindIndex(there, device => device.name == _device) < 0)
                throw new InputException("webcam source " + name, "camera \"" + _device + "\" is not there", "plug it in, or name one of these: " + string.Join(", ", Array.ConvertAll(there, device => device.name)));
            return _device;
        }

        private void Read(WebCamTexture texture, Frame frame, long timeUs)
        {
            int width = texture.width, height = texture.height;
            if (_pixels.Length != width * height)
                _pixels = new Color32[width * height];
            texture.GetPixels32(_pixels);
            frame.Begin(_index++, timeUs);
            _pixels.CopyTo(frame.Color, width, height, !texture.videoVerticallyMirrored, timeUs);
        }
    }
}
