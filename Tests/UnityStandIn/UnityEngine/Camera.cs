// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using UnityStandIn;

namespace UnityEngine
{
    /// <summary>A perspective camera that fills the window.</summary>
    public sealed class Camera : Behaviour
    {
        public Camera()
        {
        }

        /// <summary>The first enabled one tagged MainCamera.</summary>
        public static Camera main
        {
            get
            {
                foreach (Camera camera in World.All<Camera>())
                {
                    if (camera.isActiveAndEnabled && camera.gameObject.tag == "MainCamera")
                        return camera;
                }

                return null;
            }
        }

        public float fieldOfView { get; set; } = 60;

        public int targetDisplay { get; set; }

        public RenderTexture targetTexture { get; set; }

        public float depth { get; set; }

        public Rect rect { get; set; }

        public int pixelWidth => Desk.Width;

        public int pixelHeight => Desk.Height;

        /// <summary>Its texture too, and its place.</summary>
        public void CopyFrom(Camera other)
        {
            fieldOfView = other.fieldOfView;
            targetDisplay = other.targetDisplay;
            targetTexture = other.targetTexture;
            depth = other.depth;
            rect = other.rect;
            transform.position = other.transform.position;
            transform.rotation = other.transform.rotation;
        }

        /// <summary>From the eye through a pixel, counted from the lower left corner; begins at the eye, Unity's at the near plane.</summary>
        public Ray ScreenPointToRay(Vector3 pos)
        {
            double up = Math.Tan(fieldOfView * Math.PI / 360);
            double y = (2 * pos.y / pixelHeight - 1) * up, x = (2 * pos.x / pixelWidth - 1) * up * pixelWidth / pixelHeight;
            return new Ray(transform.position, transform.rotation * new Vector3((float)x, (float)y, 1));
        }
    }
}
