using System;
using System.Collections.Generic;
using LaserTracking.Detection;
using UnityEngine;
using UnityEngine.Rendering;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Tells a <see cref="LaserRange"/> with a live camera what the projector shows, so that shots are found while the picture moves. Each
    /// picture is read back from the graphics card, which takes it some frames, and goes to the detector with the time at which it was drawn;
    /// Unity's thread waits for neither. Needs a calibration.
    /// </summary>
    [DisallowMultipleComponent]
    [RequireComponent(typeof(LaserRange))]
    [DefaultExecutionOrder(1000)]
    [AddComponentMenu("Laser Tracking/Rendered Pictures")]
    public sealed class RenderedPictures : MonoBehaviour
    {
        /// <summary>Pictures on their way back; a card that takes longer gets no further ones to read.</summary>
        private const int MostUnderWay = 8;

        [SerializeField]
        [Tooltip("What the projector shows, where the scene is drawn into a texture first: nothing is drawn twice, and all is known that was laid over the scene. Empty: a copy of the camera at the range's viewpoint draws the scene again, small.")]
        private RenderTexture? _picture;

        [SerializeField]
        [Range(0, 200)]
        [Tooltip("How long camera 0 exposes, milliseconds: so much of what is shown blends in one of its pictures.")]
        private float _exposureMs = 16.7f;

        private readonly Queue<long> _drawnUs = new Queue<long>(MostUnderWay);
        private readonly Action<AsyncGPUReadbackRequest> _take;
        private Color32[] _pixels = Array.Empty<Color32>();
        private LaserRange? _range;
        private PictureInbox? _inbox;
        private Camera? _copy;
        private RenderTexture? _small;
        private long? _newestUs;
        private bool _hasToldProblem;

        public RenderedPictures()
        {
            _take = Take;
        }

        /// <summary>Of the expected view. A camera's latency may be entered too long: then a picture seems drawn after it was seen.</summary>
        internal PredictionSettings Settings() => new PredictionSettings { ExposureUs = (long)Math.Round(_exposureMs * 1000.0), MinDelayUs = -100_000 };

        /// <summary>A range opens its camera: pictures go there from now on.</summary>
        internal PictureInbox Begin()
        {
            _newestUs = null;
            return _inbox = new PictureInbox();
        }

        private void OnEnable()
        {
            _range = GetComponent<LaserRange>();
            _hasToldProblem = false;
            if (SystemInfo.supportsAsyncGPUReadback)
                _range.AttachPictures(this);
            else
                Tell("this graphics device cannot be read back, so what the projector shows is not known, and shots are found as without it");
        }

        private void OnDisable()
        {
            _inbox = null;
            _newestUs = null;
            if (_range != null && _range.Pictures == this)
                _range.AttachPictures(null);
            DropCopy();
        }

        // What the last frame drew is complete now, and nothing of this frame has been drawn yet.
        private void Update()
        {
            RenderTexture? drawn = _picture != null ? _picture : _small;
            if (_newestUs is long drawnUs && drawn != null && _drawnUs.Count < MostUnderWay)
                Read(drawn, drawnUs);
            _newestUs = null;
        }

        private void LateUpdate()
        {
            if (_inbox == null || !_range!.IsRunning)
                return;
            if (_picture == null)
                FollowCamera();
            _newestUs = _range.CameraTimeUs;
        }

        /// <summary>Halves are the mean of four pixels: fine texture keeps its brightness.</summary>
        private void Read(RenderTexture drawn, long drawnUs)
        {
            RenderTexture small = drawn;
            while (small.width > RenderedFrameHistory.MaxWidthPx && small.height > 1)
            {
                RenderTexture half = RenderTexture.GetTemporary(small.width / 2, small.height / 2, 0, RenderTextureFormat.ARGB32);
                Graphics.Blit(small, half);
                if (small != drawn)
                    RenderTexture.ReleaseTemporary(small);
                small = half;
            }

            _drawnUs.Enqueue(drawnUs);
            AsyncGPUReadback.Request(small, 0, TextureFormat.RGBA32, _take);
            if (small != drawn)
                RenderTexture.ReleaseTemporary(small);
        }

        /// <summary>Called on Unity's thread in the order of the requests.</summary>
        private void Take(AsyncGPUReadbackRequest request)
        {
            long drawnUs = _drawnUs.Dequeue();

            // Switched off meanwhile, or gone.
            if (_inbox == null)
                return;
            if (request.hasError)
            {
                Tell("a picture could not be read back from the graphics card; while that is so, what the projector shows is not known");
                return;
            }

            int count = request.width * request.height;
            if (_pixels.Length != count)
                _pixels = new Color32[count];
            request.GetData<Color32>().CopyTo(_pixels);
            _inbox.Add(_pixels, request.width, request.height, drawnUs);
        }

        private void FollowCamera()
        {
            Camera? shown = _range!.Camera;
            if (shown == null)
            {
                Tell("the range's viewpoint has no camera, so what the projector shows is not known; drag the camera in that draws it, or the texture it draws into");
                return;
            }

            int width = Math.Max(1, Math.Min(RenderedFrameHistory.MaxWidthPx, shown.pixelWidth));
            int height = Math.Max(1, width * shown.pixelHeight / Math.Max(1, shown.pixelWidth));
            if (_copy == null || _small == null || _small.width != width || _small.height != height)
            {
                DropCopy();
                _small = new RenderTexture(width, height, 24);
                _copy = new GameObject("Rendered Pictures' copy of " + shown.name).AddComponent<Camera>();
            }

            // With its place; texture, part of it and turn are its own. Before the other, so that it is done when that is.
            _copy.CopyFrom(shown);
            _copy.targetTexture = _small;
            _copy.rect = new Rect(0, 0, 1, 1);
            _copy.depth = shown.depth - 1;
        }

        private void DropCopy()
        {
            if (_copy != null)
                Destroy(_copy.gameObject);
            if (_small != null)
                _small.Release();
            _copy = null;
            _small = null;
        }

        private void Tell(string problem)
        {
            if (!_hasToldProblem)
                ShotEmitters.Report(this, "RenderedPictures " + name + ": " + problem, false);
            _hasToldProblem = true;
        }
    }
}
