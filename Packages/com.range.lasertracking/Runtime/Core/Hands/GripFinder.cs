using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Where the palm behind a seen muzzle is, and how well that is known: a grip's length back along the line of whoever aims over it. Everybody
    /// within an arm's length is weighed by the weapon's bearing, by the hand's visible surface and by their distance; the palm is the mean
    /// over them, and its variance holds how far they disagree. Of a weapon that fits nobody the bearing alone tells, which is too little.
    /// </summary>
    internal sealed class GripFinder
    {
        /// <summary>From the eyes to a muzzle held out: measured 690 mm with two hands, 870 with one.</summary>
        private const double ReachMm = 750;
        private const double ReachSigmaMm = 130;
        private const double MinReachMm = 450;
        private const double MaxReachMm = 1100;

        /// <summary>Of a fist the front is seen: the middle of its surface lies so far before the grip, and so far beside and above it (measured on the simulated range).</summary>
        private const double SurfaceAheadMm = 39;
        private const double SurfaceSigmaMm = 20;
        private const double SurfaceHeightSigmaMm = 30;

        /// <summary>Standard deviation of a weapon's bearing with two hands on it; with one 0.07.</summary>
        private const double BearingSigmaRad = 0.18;

        /// <summary>Weight of a neighbour beside whom the arm seems to be, and of somebody who is not seen at all.</summary>
        private const double NeighbourShare = 0.3;
        private const double NobodysShare = 0.03;

        /// <summary>What the muzzle itself errs, and the share of the eyes' standard deviation that the simulated range shows.</summary>
        private const double LeastSigmaMm = 4;
        private const double EyeShare = 0.5;

        private readonly DepthHandSettings _settings;
        private readonly UprightFrame _upright;

        public GripFinder(DepthHandSettings settings, UprightFrame upright)
        {
            _settings = settings;
            _upright = upright;
        }

        /// <summary>Sets the grip of an arm whose weapon is seen; leaves it unknown where nothing tells along which line that lies.</summary>
        public void Find(PersonSet people, ref ArmFit fit)
        {
            if (!fit.HasWeapon)
                return;
            Vector3D muzzle = _upright.ToUpright(fit.MuzzleMm), bearing = _upright.ToUpright(fit.WeaponDirection);
            var all = default(Mixture);
            for (int i = 0; i < people.Count; i++)
            {
                if (!people.TryEyes(i, out int id, out Vector3D eye, out double eyeSigma))
                    continue;
                Vector3D line = muzzle - eye;
                double reach = line.Length;
                if (reach < MinReachMm || reach > MaxReachMm)
                    continue;
                Vector3D aim = line * (1 / reach);
                double weight = (id == fit.PersonId ? 1 : NeighbourShare) * Normal((reach - ReachMm) / ReachSigmaMm);
                if (bearing.LengthSquared > 0)
                    weight *= Normal(Vector3D.Turn(bearing, aim) / BearingSigmaRad);
                all.Add(Back(aim), weight * SurfaceFit(fit, aim, 0), _settings.GripToMuzzleMm * EyeShare * eyeSigma / reach);
            }

            if (bearing.LengthSquared > 0)
            {
                Vector3D level = new Vector3D(bearing.X, 0, bearing.Z).Normalized;
                double sigma = _settings.GripToMuzzleMm * BearingSigmaRad;
                all.Add(Back(level), NobodysShare * SurfaceFit(fit, level, sigma), sigma);
            }

            if (!(all.Weight > 0))
                return;
            fit.GripMm = fit.MuzzleMm + _upright.ToCamera(all.Mean);
            fit.GripSigmaMm = all.Sigma;
        }

        private Vector3D Back(Vector3D aim) => aim * -_settings.GripToMuzzleMm - new Vector3D(0, _settings.BoreAboveGripMm, 0);

        /// <summary>How well the hand's surface agrees with a weapon that lies so, 0…1; 1 where it is not seen.</summary>
        private double SurfaceFit(in ArmFit fit, Vector3D aim, double besideSigma)
        {
            if (!fit.HasSurface)
                return 1;
            Vector3D off = _upright.ToUpright(fit.SurfaceMm - fit.MuzzleMm) - Back(aim) - aim * SurfaceAheadMm;
            off -= aim * Vector3D.Dot(off, aim);
            double height = off.Y, beside = off.LengthSquared - height * height;
            return Normal(height / SurfaceHeightSigmaMm) * Math.Exp(-0.5 * beside / (SurfaceSigmaMm * SurfaceSigmaMm + besideSigma * besideSigma));
        }

        private static double Normal(double errors) => Math.Exp(-0.5 * errors * errors);

        /// <summary>Places with their weights and standard deviations along each axis, mm.</summary>
        private struct Mixture
        {
            private Vector3D _sum;
            private double _squares;

            public double Weight { get; private set; }

            public readonly Vector3D Mean => _sum * (1 / Weight);

            public readonly double Sigma => Math.Sqrt(Math.Max(0, (_squares / Weight - Mean.LengthSquared) / 3));

            public void Add(Vector3D place, double weight, double sigma)
            {
                Weight += weight;
                _sum += place * weight;
                _squares += weight * (place.LengthSquared + 3 * (sigma * sigma + LeastSigmaMm * LeastSigmaMm));
            }
        }
    }
}
