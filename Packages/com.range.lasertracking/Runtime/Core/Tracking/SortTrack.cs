using System;

namespace LaserTracking.Tracking
{
    /// <summary>
    /// One track of <see cref="SortTracker"/>: the filter of SORT (Bewley et al. 2016) over centre, area and aspect ratio with the
    /// velocities of the first three, per frame. Its seven states fall apart into three blocks of two and one alone, because the
    /// published noise matrices are diagonal.
    /// </summary>
    public struct SortTrack
    {
        private const double PlaceNoise = 1, AreaNoise = 10, AspectNoise = 10;
        private const double FirstVariance = 10, FirstVelocityVariance = 10_000;
        private const double PlaceWander = 1, VelocityWander = 0.01, AreaVelocityWander = 1e-4;

        internal SortTrack(int id, in BoundingBox box)
        {
            Id = id;
            Hits = HitStreak = Age = TimeSinceUpdate = 0;
            CenterX = new ConstantVelocityFilter(box.CenterX, FirstVariance, FirstVelocityVariance);
            CenterY = new ConstantVelocityFilter(box.CenterY, FirstVariance, FirstVelocityVariance);
            Area = new ConstantVelocityFilter(box.Width * box.Height, FirstVariance, FirstVelocityVariance);
            Aspect = box.Width / box.Height;
            AspectVariance = FirstVariance;
        }

        /// <summary>Counts from 1 in the order of first sight.</summary>
        public int Id { get; }

        /// <summary>Detections taken since the first.</summary>
        public int Hits { get; private set; }

        /// <summary>Detections taken in frames without a gap between them.</summary>
        public int HitStreak { get; private set; }

        /// <summary>Frames since the first.</summary>
        public int Age { get; private set; }

        /// <summary>Frames since the last detection taken.</summary>
        public int TimeSinceUpdate { get; private set; }

        /// <summary>Px and px per frame.</summary>
        public ConstantVelocityFilter CenterX;

        /// <summary>Px and px per frame.</summary>
        public ConstantVelocityFilter CenterY;

        /// <summary>Px² and px² per frame.</summary>
        public ConstantVelocityFilter Area;

        /// <summary>Width through height; keeps no velocity.</summary>
        public double Aspect { get; private set; }

        public double AspectVariance { get; private set; }

        /// <summary>The box of the state; not a number once area or aspect ratio has become negative.</summary>
        public BoundingBox Box
        {
            get
            {
                double width = Math.Sqrt(Area.Position * Aspect), height = Area.Position / width;
                return new BoundingBox(CenterX.Position - width / 2, CenterY.Position - height / 2, width, height);
            }
        }

        internal void Predict()
        {
            if (Area.Position + Area.Velocity <= 0)
                Area.Velocity = 0;
            CenterX.Predict(1, PlaceWander, 0, VelocityWander);
            CenterY.Predict(1, PlaceWander, 0, VelocityWander);
            Area.Predict(1, PlaceWander, 0, AreaVelocityWander);
            AspectVariance += PlaceWander;
            Age++;
            if (TimeSinceUpdate > 0)
                HitStreak = 0;
            TimeSinceUpdate++;
        }

        internal void Update(in BoundingBox box)
        {
            TimeSinceUpdate = 0;
            Hits++;
            HitStreak++;
            CenterX.Update(box.CenterX, PlaceNoise);
            CenterY.Update(box.CenterY, PlaceNoise);
            Area.Update(box.Width * box.Height, AreaNoise);
            double gain = AspectVariance / (AspectVariance + AspectNoise);
            Aspect += gain * (box.Width / box.Height - Aspect);
            AspectVariance *= 1 - gain;
        }
    }
}
