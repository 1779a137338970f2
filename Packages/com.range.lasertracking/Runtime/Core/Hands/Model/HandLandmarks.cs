using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands.Model
{
    /// <summary>What the landmark model says about one region. Written by <see cref="HandLandmarkNetwork"/>, used again and again.</summary>
    public sealed class HandLandmarks
    {
        /// <summary>
        /// 21 points: 0 wrist; 1–4 thumb, 5–8 index, 9–12 middle, 13–16 ring, 17–20 little finger, each from its root to its tip.
        /// </summary>
        public const int Count = 21;

        // MediaPipe's normalize_z: its z is in crop widths after a division by this.
        private const double DepthScale = 0.4;

        private readonly float[] _crop = new float[3 * Count];
        private readonly Vector3D[] _picturePx = new Vector3D[Count];
        private readonly Vector3D[] _worldM = new Vector3D[Count];

        /// <summary>The region that was looked at.</summary>
        public HandRegion Region { get; private set; }

        /// <summary>Probability 0…1 that a hand is there; says little about its rotation.</summary>
        public double Presence { get; private set; }

        /// <summary>Probability 0…1 that it is a right hand, in a picture that is not mirrored.</summary>
        public double RightHandProbability { get; private set; }

        /// <summary>x, y, z of each as the network gives them: crop px, 0…224.</summary>
        public ReadOnlySpan<float> CropPx => _crop;

        /// <summary>Picture px as in <see cref="HandRegion"/>; z in the same unit, relative to the wrist, smaller is nearer, rough.</summary>
        public ReadOnlySpan<Vector3D> PicturePx => _picturePx;

        /// <summary>Metres about the hand's own centre, axes of the picture (x right, y down, z away); the true size is not known to it.</summary>
        public ReadOnlySpan<Vector3D> WorldM => _worldM;

        /// <summary>Where to look in the next frame.</summary>
        public HandRegion NextRegion => HandRegion.FromLandmarks(_picturePx);

        /// <param name="region">That the crop was taken from.</param>
        /// <param name="crop">21 × (x, y, z), crop px.</param>
        /// <param name="world">21 × (x, y, z), metres, axes of the crop.</param>
        /// <param name="presence">0…1.</param>
        /// <param name="rightHand">0…1.</param>
        public void Set(HandRegion region, ReadOnlySpan<float> crop, ReadOnlySpan<float> world, double presence, double rightHand)
        {
            Region = region;
            Presence = presence;
            RightHandProbability = rightHand;
            crop.CopyTo(_crop);
            double cos = Math.Cos(region.RotationRad), sin = Math.Sin(region.RotationRad);
            for (int i = 0; i < Count; i++)
            {
                Vector2D place = region.ToPicture(crop[3 * i] / (double)HandLandmarkNetwork.InputSizePx, crop[3 * i + 1] / (double)HandLandmarkNetwork.InputSizePx);
                double depth = crop[3 * i + 2] / (double)HandLandmarkNetwork.InputSizePx / DepthScale * region.SidePx;
                _picturePx[i] = new Vector3D(place.X, place.Y, depth);
                double x = world[3 * i], y = world[3 * i + 1];
                _worldM[i] = new Vector3D(x * cos - y * sin, x * sin + y * cos, world[3 * i + 2]);
            }
        }

        public void CopyFrom(HandLandmarks other)
        {
            Region = other.Region;
            Presence = other.Presence;
            RightHandProbability = other.RightHandProbability;
            other._crop.CopyTo(_crop, 0);
            other._picturePx.CopyTo(_picturePx, 0);
            other._worldM.CopyTo(_worldM, 0);
        }
    }
}
