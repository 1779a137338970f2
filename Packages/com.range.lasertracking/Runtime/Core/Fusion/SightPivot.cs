using System;
using System.Runtime.CompilerServices;
using LaserTracking.Geometry;

namespace LaserTracking.Fusion
{
    /// <summary>The point over which somebody aims, with its covariance. Screen space, metres.</summary>
    internal struct SightPivot
    {
        public Vector3D PlaceM;

        /// <summary>Information xx, yy, zz and xy, xz, yz, its adjugate in the same order, and its determinant.</summary>
        private Vector3D _diagonal;
        private Vector3D _mixed;
        private Vector3D _adjugateDiagonal;
        private Vector3D _adjugateMixed;
        private double _determinant;

        /// <summary>Of what lines tell and of where the eyes are seen.</summary>
        /// <param name="known">The lines.</param>
        /// <param name="eyeM">The eyes.</param>
        /// <param name="prior">1 / σ² of those along each axis.</param>
        public static SightPivot Of(in SightEvidence known, Vector3D eyeM, Vector3D prior)
        {
            // Inverse of a symmetric 3×3: its adjugate over its determinant.
            Vector3D a = known.Diagonal + prior, m = known.Mixed;
            var pivot = new SightPivot
            {
                _diagonal = a,
                _mixed = m,
                _adjugateDiagonal = new Vector3D(a.Y * a.Z - m.Z * m.Z, a.X * a.Z - m.Y * m.Y, a.X * a.Y - m.X * m.X),
                _adjugateMixed = new Vector3D(m.Y * m.Z - m.X * a.Z, m.X * m.Z - m.Y * a.Y, m.X * m.Y - m.Z * a.X),
            };
            pivot._determinant = a.X * pivot._adjugateDiagonal.X + m.X * pivot._adjugateMixed.X + m.Y * pivot._adjugateMixed.Y;
            var w = known.Weighted + new Vector3D(eyeM.X * prior.X, eyeM.Y * prior.Y, eyeM.Z * prior.Z);
            pivot.PlaceM = Times(pivot._adjugateDiagonal, pivot._adjugateMixed, w) * (1 / pivot._determinant);
            return pivot;
        }

        /// <summary>Variance along a unit vector, m².</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly double VarianceAlong(Vector3D unit) => Form(_adjugateDiagonal, _adjugateMixed, unit) / _determinant;

        /// <summary>Sum of the variances along two axes at right angles to a unit vector, m².</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly double VarianceAcross(Vector3D unit) =>
            Math.Max(0, (_adjugateDiagonal.X + _adjugateDiagonal.Y + _adjugateDiagonal.Z) / _determinant - VarianceAlong(unit));

        /// <summary>Determinant of the covariance at right angles to a unit vector, m⁴.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly double DeterminantAcross(Vector3D unit) => Math.Max(0, Form(_diagonal, _mixed, unit) / _determinant);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static double Form(Vector3D diagonal, Vector3D mixed, Vector3D v) => Vector3D.Dot(v, Times(diagonal, mixed, v));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector3D Times(Vector3D diagonal, Vector3D mixed, Vector3D v) => new Vector3D(
            diagonal.X * v.X + mixed.X * v.Y + mixed.Y * v.Z,
            mixed.X * v.X + diagonal.Y * v.Y + mixed.Z * v.Z,
            mixed.Y * v.X + mixed.Z * v.Y + diagonal.Z * v.Z);
    }
}
