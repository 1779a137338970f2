using System;
using LaserTracking.Geometry;

namespace LaserTracking.Tracking
{
    /// <summary>Where <see cref="DotTracker"/> believes one dot to be. Pixels of a picture 640 wide, seconds.</summary>
    internal struct DotPath
    {
        public ConstantVelocityFilter X;
        public ConstantVelocityFilter Y;

        /// <summary>0: not seen often enough to have one.</summary>
        public int Id;
        public int Hits;

        /// <summary>On the tracker's own clock, which never runs back.</summary>
        public long FirstUs;
        public long LastUs;

        public DotPath(Vector2D at, long timeUs, DotTrackerSettings settings)
            : this()
        {
            FirstUs = timeUs;
            Restart(at, timeUs, settings);
        }

        /// <summary>Seen there, with a velocity of which nothing is known.</summary>
        public void Restart(Vector2D at, long timeUs, DotTrackerSettings settings)
        {
            double place = settings.TremorPx * settings.TremorPx, speed = settings.FirstSpeedPxPerS * settings.FirstSpeedPxPerS;
            X = new ConstantVelocityFilter(at.X, place, speed);
            Y = new ConstantVelocityFilter(at.Y, place, speed);
            Hits++;
            LastUs = timeUs;
        }

        /// <summary>White noise of the acceleration, integrated over the step.</summary>
        public void Predict(double stepS, double wander)
        {
            double density = wander * wander, velocityNoise = density * stepS;
            double covarianceNoise = velocityNoise * stepS / 2, placeNoise = covarianceNoise * stepS * (2.0 / 3);
            X.Predict(stepS, placeNoise, covarianceNoise, velocityNoise);
            Y.Predict(stepS, placeNoise, covarianceNoise, velocityNoise);
        }

        public void Update(Vector2D at, long timeUs, double tremor)
        {
            X.Update(at.X, tremor * tremor);
            Y.Update(at.Y, tremor * tremor);
            Hits++;
            LastUs = timeUs;
        }

        public readonly Vector2D PlacePx => new Vector2D(X.Position, Y.Position);

        /// <summary>
        /// Squared Mahalanobis distance of a dot; with the spread (log-determinant of the covariance: the wider the prediction the less its
        /// nearness says) twice the negative log-likelihood but for a constant. Both axes have the same variances.
        /// </summary>
        public readonly double DistanceSquared(Vector2D at, double tremor, out double spread)
        {
            double variance = X.PositionVariance + tremor * tremor;
            spread = 2 * Math.Log(variance);
            return (at - PlacePx).LengthSquared / variance;
        }

        /// <summary>The same of place and velocity (four degrees of freedom) between this one and another at the same moment.</summary>
        public readonly double DistanceSquared(in DotPath other, out double spread)
        {
            double place = X.PositionVariance + other.X.PositionVariance, speed = X.VelocityVariance + other.X.VelocityVariance;
            double both = X.Covariance + other.X.Covariance, determinant = place * speed - both * both;
            spread = 2 * Math.Log(determinant);
            return (Form(X, other.X, place, both, speed) + Form(Y, other.Y, place, both, speed)) / determinant;
        }

        private static double Form(in ConstantVelocityFilter a, in ConstantVelocityFilter b, double place, double both, double speed)
        {
            double p = a.Position - b.Position, v = a.Velocity - b.Velocity;
            return speed * p * p - 2 * both * p * v + place * v * v;
        }
    }
}
