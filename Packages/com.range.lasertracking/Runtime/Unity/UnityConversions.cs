using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using UnityEngine;
using Pose = LaserTracking.Geometry.Pose;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Core's doubles and pictures to and from Unity's: the only place where they meet. Scene space is Unity's own (left-handed, y up,
    /// metres), so that nothing is turned or mirrored here; see <see cref="Axes"/> for what is.
    /// </summary>
    public static class UnityConversions
    {
        public static Vector2 ToUnity(this Vector2D v) => new Vector2((float)v.X, (float)v.Y);

        public static Vector3 ToUnity(this Vector3D v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);

        public static Quaternion ToUnity(this Rotation3D r) => new Quaternion((float)r.X, (float)r.Y, (float)r.Z, (float)r.W);

        public static Vector2D ToCore(this Vector2 v) => new Vector2D(v.x, v.y);

        public static Vector3D ToCore(this Vector3 v) => new Vector3D(v.x, v.y, v.z);

        public static Rotation3D ToCore(this Quaternion q) => new Rotation3D(q.x, q.y, q.z, q.w);

        /// <summary>Where the transform stands in the world. Its scale is left out: lengths stay metres.</summary>
        public static Pose WorldPose(this Transform transform) => new Pose(transform.position.ToCore(), transform.rotation.ToCore());

        /// <summary>Unity's pixels as a picture: rows from the top, blue first.</summary>
        /// <param name="pixels">At least width times height.</param>
        /// <param name="image">Filled.</param>
        /// <param name="width">Pixels.</param>
        /// <param name="height">Pixels.</param>
        /// <param name="isFromBottom">Their first row is the lowest, as in textures.</param>
        /// <param name="timeUs">The picture's.</param>
        public static void CopyTo(this Color32[] pixels, Image image, int width, int height, bool isFromBottom, long timeUs)
        {
            image.Reset(PixelFormat.Bgra32, width, height, timeUs);
            for (int y = 0; y < height; y++)
            {
                Span<byte> row = image.Bytes.Slice(y * image.Stride, width * 4);
                int from = (isFromBottom ? height - 1 - y : y) * width;
                for (int x = 0; x < width; x++)
                {
                    Color32 pixel = pixels[from + x];
                    row[4 * x] = pixel.b;
                    row[4 * x + 1] = pixel.g;
                    row[4 * x + 2] = pixel.r;
                    row[4 * x + 3] = 255;
                }
            }
        }
    }
}
