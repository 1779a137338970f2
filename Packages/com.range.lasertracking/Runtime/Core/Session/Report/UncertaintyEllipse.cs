using System;
using LaserTracking.Geometry;

namespace LaserTracking.Session
{
    /// <summary>The ellipse that holds 95 % of a two-dimensional normal distribution.</summary>
    internal readonly struct UncertaintyEllipse
    {
        private const double Sigmas95 = 2.4477468306808166; // √(−2 ln 0.05)

        public UncertaintyEllipse(Covariance2D covariance)
        {
            double mean = (covariance.XX + covariance.YY) / 2, half = (covariance.XX - covariance.YY) / 2;
            double root = Math.Sqrt(half * half + covariance.XY * covariance.XY);
            LongRadius = Sigmas95 * Math.Sqrt(Math.Max(0, mean + root));
            ShortRadius = Sigmas95 * Math.Sqrt(Math.Max(0, mean - root));
            AngleDegrees = root > 0 ? Math.Atan2(covariance.XY, half) * 90 / Math.PI : 0;
        }

        /// <summary>In the root of the covariance's unit.</summary>
        public double LongRadius { get; }

        public double ShortRadius { get; }

        /// <summary>Of the long axis, from x towards y.</summary>
        public double AngleDegrees { get; }

        public bool IsDrawable => LongRadius > 0 && !double.IsInfinity(LongRadius);

        public void Draw(HtmlWriter html, double x, double y)
        {
            if (!IsDrawable)
                return;
            html.Raw("<ellipse class=\"cov\" rx=\"").Number(LongRadius, 2).Raw("\" ry=\"").Number(ShortRadius, 2)
                .Raw("\" transform=\"translate(").Number(x, 1).Raw(" ").Number(y, 1).Raw(") rotate(").Number(AngleDegrees, 1).Raw(")\"/>");
        }
    }
}
