using System.Runtime.CompilerServices;
using LaserTracking.Geometry;

namespace LaserTracking.Fusion
{
    /// <summary>What lines of fire tell of the point over which somebody aims, in information form, and of how closely they do.</summary>
    internal struct SightEvidence
    {
        /// <summary>Sums over shots of (I − u uᵀ)/σ² as xx, yy, zz and xy, xz, yz, and of that times the muzzle.</summary>
        public Vector3D Diagonal;
        public Vector3D Mixed;
        public Vector3D Weighted;

        /// <summary>Squared sight errors in units of what is expected, and how many.</summary>
        public double SpreadSum;
        public double SpreadCount;

        /// <summary>Of one line through a muzzle.</summary>
        public static SightEvidence OfLine(Vector3D muzzleM, Vector3D direction, double weight) => new SightEvidence
        {
            Diagonal = new Vector3D(1 - direction.X * direction.X, 1 - direction.Y * direction.Y, 1 - direction.Z * direction.Z) * weight,
            Mixed = new Vector3D(direction.X * direction.Y, direction.X * direction.Z, direction.Y * direction.Z) * -weight,
            Weighted = (muzzleM - direction * Vector3D.Dot(muzzleM, direction)) * weight,
        };

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Add(in SightEvidence other, double share)
        {
            Diagonal += other.Diagonal * share;
            Mixed += other.Mixed * share;
            Weighted += other.Weighted * share;
            SpreadSum += other.SpreadSum * share;
            SpreadCount += other.SpreadCount * share;
        }

        public void Scale(double share)
        {
            Diagonal *= share;
            Mixed *= share;
            Weighted *= share;
            SpreadSum *= share;
            SpreadCount *= share;
        }
    }
}
