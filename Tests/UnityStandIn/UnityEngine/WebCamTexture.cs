// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using UnityStandIn;

namespace UnityEngine
{
    public sealed class WebCamTexture : Texture
    {
        public WebCamTexture(string deviceName, int requestedWidth, int requestedHeight, int requestedFPS)
        {
            this.deviceName = deviceName;
            // As in Unity: 16 pixels either way until the first frame has come.
            width = height = 16;
        }

        public static WebCamDevice[] devices => WebCams.Devices;

        public string deviceName { get; set; }

        public bool isPlaying { get; private set; }

        public bool videoVerticallyMirrored => false;

        public bool didUpdateThisFrame => isPlaying && WebCams.IsNew(deviceName);

        public void Play()
        {
            isPlaying = true;
            WebCams.Playing++;
        }

        public void Stop()
        {
            if (isPlaying)
                WebCams.Playing--;
            isPlaying = false;
        }

        /// <summary>Rows from the bottom.</summary>
        public Color32[] GetPixels32(Color32[] colors)
        {
            Array.Copy(WebCams.Pixels, colors, WebCams.Pixels.Length);
            return colors;
        }

        internal override int Width
        {
            get => WebCams.Pixels == null ? base.Width : WebCams.Width;
            set => base.Width = value;
        }

        internal override int Height
        {
            get => WebCams.Pixels == null ? base.Height : WebCams.Height;
            set => base.Height = value;
        }
    }
}
