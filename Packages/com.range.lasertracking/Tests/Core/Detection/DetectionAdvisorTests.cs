using System;
using System.Linq;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class DetectionAdvisorTests
    {
        // Values proportional to light, a dot of two pixels, no halo: what FrameBuilder draws.
        private static AdvisorSettings Settings() => new AdvisorSettings
        {
            Gamma = 1, Columns = 4, Rows = 3, HaloShare = 0, BlurPx = 0, PictureWidthM = 3.2, DotRadiusMm = 40, PowerMw = 1000, WhiteLight = 0.3, ExposureUs = 33_333,
        };

        [Test]
        [Category("Long")]
        public void Advisor_QuietWall_SaysWhereTheDetectorBegins()
        {
            DetectionAdvice advice = Advise(new DetectionRun(), (b, i) => b.Wall(60, 60, 60));
            double levels = advice.DimmestLevels;
            Assert.That(advice.BlindRegions, Is.Zero);
            Assert.That(levels, Is.InRange(5, 80));
            Assert.That(Found(levels * 1.6), Is.GreaterThanOrEqualTo(11), "brighter ones are found");
            Assert.That(Found(levels * 0.4), Is.LessThanOrEqualTo(1), "dimmer ones are not");
        }

        [TestCase(6, 1)]
        [TestCase(12, 1.2)]
        [Category("Long")]
        public void Advisor_NoisyWall_NeedsMoreThanAQuietOne(double noiseSigma, double factor)
        {
            var noisy = new DetectionRun();
            noisy.Builder.NoiseSigma = noiseSigma;
            DetectionAdvice quiet = Advise(new DetectionRun(), (b, i) => b.Wall(60, 60, 60)), loud = Advise(noisy, (b, i) => b.Wall(60, 60, 60));
            Assert.That(loud.DimmestLevels, Is.GreaterThan(factor * quiet.DimmestLevels));
        }

        [Test]
        public void Advisor_SaturatedPart_CatchesNothingThere()
        {
            DetectionAdvice advice = Advise(new DetectionRun(), (b, i) => b.Wall(60, 60, 60).Box(0, 0, 160, 240, 500, 500, 500));
            Assert.That(Enumerable.Range(0, 12).Count(r => r % 4 == 0 && !double.IsNaN(advice.Regions[r].DimmestMw)), Is.Zero);
            Assert.That(Enumerable.Range(0, 12).Count(r => r % 4 == 3 && double.IsNaN(advice.Regions[r].DimmestMw)), Is.Zero);
            Assert.That(advice.Gain, Does.Contain("lower the exposure"));
        }

        [Test]
        public void Advisor_ShortExposure_LosesFlashesBetweenExposuresAndSaysSo()
        {
            AdvisorSettings settings = Settings();
            settings.ExposureUs = 5000;
            DetectionAdvice advice = Advise(new DetectionRun(), (b, i) => b.Wall(60, 60, 60), settings);
            Assert.That(advice.Probability(1000, 8), Is.EqualTo(13 / 33.3).Within(0.05), "pulse and exposure through the interval");
            Assert.That(advice.Probability(1000, 60), Is.GreaterThan(0.94));
            Assert.That(advice.Gain, Does.Contain("between two exposures"));
        }

        [Test]
        public void Advisor_WhileItLooks_TheDetectorFindsTheSame()
        {
            string Run(bool isAdvised)
            {
                var run = new DetectionRun();
                var advisor = new DetectionAdvisor((ShotDetector)run.Detector, Settings());
                for (int i = 0; i < 60; i++)
                {
                    run.Play(i, 1, (b, n) =>
                    {
                        b.Wall(60, 60, 60).Box(n * 3, 40, 30, 30, 120, 60, 90);
                        if (n % 12 < 2)
                            b.GreenDot(60 + n, 150);
                    });
                    if (isAdvised)
                        advisor.Look(run.Frame);
                }

                return string.Join("; ", run.Shots.Select(s => s.FrameIndex + " " + s.Dot.PositionPx)) + run.Rejected.Count;
            }

            Assert.That(Run(true), Is.EqualTo(Run(false)));
        }

        [Test]
        public void Advisor_WarmLook_AllocatesNothing()
        {
            var run = new DetectionRun();
            var advisor = new DetectionAdvisor((ShotDetector)run.Detector, Settings());
            run.Play(0, 6, (b, i) => b.Wall(60, 60, 60));
            Assert.That(Allocation.Of(() => advisor.LookEverywhere(run.Frame)), Is.Zero);
        }

        [Test]
        public void Advisor_BeforeItHasLooked_RefusesToAdvise()
        {
            Assert.That(() => new DetectionAdvisor(new ShotDetector()).Advise(), Throws.InvalidOperationException);
        }

        [TestCase(double.NaN)]
        [TestCase(0)]
        public void AdvisorSettings_OutsideTheirRange_AreRefused(double power)
        {
            Assert.That(() => new DetectionAdvisor(new ShotDetector(), new AdvisorSettings { PowerMw = power }), Throws.ArgumentException);
        }

        private static DetectionAdvice Advise(DetectionRun run, Action<FrameBuilder, int> draw, AdvisorSettings? settings = null)
        {
            var advisor = new DetectionAdvisor((ShotDetector)run.Detector, settings ?? Settings());
            for (int i = 0; i < 30; i++)
            {
                run.Play(i, 1, draw);
                if (i > 10)
                    advisor.LookEverywhere(run.Frame);
                else
                    advisor.Note(run.Frame);
            }

            return advisor.Advise();
        }

        /// <summary>How many of twelve one-frame flashes of this rise in green are found.</summary>
        private static int Found(double levels)
        {
            var run = new DetectionRun();
            run.Play(0, 20 + 12 * 10, (b, i) =>
            {
                b.Wall(60, 60, 60);
                if (i >= 20 && i % 10 == 0)
                    b.Dot(40 + i * 1.7, 30 + i, 2, levels * 0.42 / 2.7, levels, levels * 0.3 / 2.7);
            });
            return run.Shots.Count;
        }
    }
}
