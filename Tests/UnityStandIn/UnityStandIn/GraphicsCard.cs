// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace UnityStandIn
{
    /// <summary>What is drawn into render textures, and how they are read back: some frames later, in the order of the requests.</summary>
    public static class GraphicsCard
    {
        private static readonly Queue<(int Due, AsyncGPUReadbackRequest Request, Action<AsyncGPUReadbackRequest> Callback)> Waiting =
            new Queue<(int Due, AsyncGPUReadbackRequest Request, Action<AsyncGPUReadbackRequest> Callback)>();

        public static bool CanBeReadBack { get; set; }

        /// <summary>Every request ends with an error.</summary>
        public static bool Fails { get; set; }

        /// <summary>Frames from a request to its answer.</summary>
        public static int FramesLate { get; set; }

        /// <summary>What the scene looks like: pixels with rows from the bottom, for a width and a height.</summary>
        public static Func<int, int, Color32[]> Scene { get; set; }

        /// <summary>Render textures that were made and not released.</summary>
        public static int Textures { get; internal set; }

        /// <summary>Draws the scene into a texture, as a program may do itself.</summary>
        public static void Draw(RenderTexture texture) => texture.Content = Scene(texture.width, texture.height);

        internal static void Queue(AsyncGPUReadbackRequest request, Action<AsyncGPUReadbackRequest> callback) =>
            Waiting.Enqueue((Time.frameCount + FramesLate, request, callback));

        /// <summary>Before the frame's Update.</summary>
        internal static void Answer()
        {
            while (Waiting.Count > 0 && Waiting.Peek().Due <= Time.frameCount)
            {
                (_, AsyncGPUReadbackRequest request, Action<AsyncGPUReadbackRequest> callback) = Waiting.Dequeue();
                callback?.Invoke(request);
            }
        }

        /// <summary>After the frame's LateUpdate: cameras that draw into textures do so.</summary>
        internal static void Render()
        {
            foreach (Camera camera in World.All<Camera>())
            {
                if (camera.isActiveAndEnabled && camera.targetTexture != null && Scene != null)
                    Draw(camera.targetTexture);
            }
        }

        internal static void Reset()
        {
            Waiting.Clear();
            CanBeReadBack = true;
            Fails = false;
            FramesLate = 2;
            Scene = null;
            Textures = 0;
        }
    }
}
