using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>Makes the dot of a candidate that passed: its place on the whole picture, its colour, how sure it is.</summary>
    internal sealed class DotMeasurer
    {
        private readonly ShotDetectorSettings _settings;
        private readonly DotLocator _locator = new DotLocator();

        public DotMeasurer(ShotDetectorSettings settings) => _settings = settings;

        /// <param name="image">The frame as it came.</param>
        /// <param name="view">Its working picture.</param>
        /// <param name="factor">Pixels of the frame along a working pixel.</param>
        /// <param name="candidate">Judged.</param>
        /// <param name="known">The dot of the last frame that it continues; Frames is 0 when none.</param>
        /// <param name="noise">Temporal noise, levels (one standard deviation).</param>
        public Dot Measure(Image image, in FrameView view, int factor, in Candidate candidate, in RememberedDot known, double noise)
        {
            var dot = new Dot { IsConclusive = candidate.IsConclusive, IsOnset = candidate.IsOnset, MayBeContent = candidate.MayBeContent };
            _locator.Locate(image, view, factor, candidate, noise, ref dot);
            dot.Color = candidate.IsOnset || known.Frames == 0 ? ColorOf(candidate) : known.Color;
            dot.Factors = ConfidenceModel.Of(candidate, AwayShare(dot.PositionPx, image));
            dot.Confidence = Math.Min(1, dot.Factors.Sum);
            return dot;
        }

        private LaserColor ColorOf(in Candidate candidate)
        {
            if (candidate.GreenCoherence >= _settings.ColorCoherence && candidate.GreenRise > 0 && candidate.RedHeadroom >= _settings.MinColorHeadroom)
                return LaserColor.Green;
            bool isRed = candidate.GreenCoherence <= -_settings.ColorCoherence && candidate.RedRise > 0 && !IsReddishWhite(candidate);
            return isRed && candidate.GreenHeadroom >= _settings.MinColorHeadroom ? LaserColor.Red : LaserColor.Unknown;
        }

        /// <summary>
        /// Beyond 800 nm all three filters of a colour camera let light through, the red one a little more: red that stands clear of
        /// green but hardly of blue may be infrared.
        /// </summary>
        private static bool IsReddishWhite(in Candidate candidate)
        {
            double overGreen = candidate.RedRise - candidate.GreenRise, overBlue = candidate.RedRise - candidate.BlueRise;
            return overGreen >= 0.05 * candidate.RedRise && overBlue < 0.3 * overGreen;
        }

        private static double AwayShare(Vector2D positionPx, Image image)
        {
            var center = new Vector2D((image.Width - 1) * 0.5, (image.Height - 1) * 0.5);
            return (positionPx - center).Length / Math.Max(1, center.Length);
        }
    }
}
