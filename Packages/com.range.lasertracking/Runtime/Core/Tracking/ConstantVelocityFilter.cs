namespace LaserTracking.Tracking
{
    /// <summary>
    /// Kalman filter of one coordinate that moves at a velocity which wanders (Bar-Shalom, Li, Kirubarajan 2001, section 6.2); the
    /// coordinate is measured. Units are the caller's; velocities are per unit of the step. Larger filters whose noise is diagonal fall
    /// apart into blocks of this kind, exactly.
    /// </summary>
    public struct ConstantVelocityFilter
    {
        public double Position;
        public double Velocity;
        public double PositionVariance;
        public double VelocityVariance;

        /// <summary>Of position and velocity.</summary>
        public double Covariance;

        /// <summary>At rest as far as known.</summary>
        public ConstantVelocityFilter(double position, double positionVariance, double velocityVariance)
        {
            Position = position;
            Velocity = 0;
            PositionVariance = positionVariance;
            VelocityVariance = velocityVariance;
            Covariance = 0;
        }

        /// <summary>Goes a step on; the noises are what the step adds to the covariance matrix.</summary>
        public void Predict(double step, double positionNoise, double covarianceNoise, double velocityNoise)
        {
            Position += step * Velocity;
            PositionVariance += step * (2 * Covariance + step * VelocityVariance) + positionNoise;
            Covariance += step * VelocityVariance + covarianceNoise;
            VelocityVariance += velocityNoise;
        }

        /// <summary>Takes a measurement of the position with its variance.</summary>
        public void Update(double measured, double noise)
        {
            double innovationVariance = PositionVariance + noise;
            double gain = PositionVariance / innovationVariance, velocityGain = Covariance / innovationVariance;
            double innovation = measured - Position;
            Position += gain * innovation;
            Velocity += velocityGain * innovation;
            VelocityVariance -= velocityGain * Covariance;
            PositionVariance *= noise / innovationVariance;
            Covariance *= noise / innovationVariance;
        }
    }
}
