using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Studies.Evidence;
using LaserTracking.Scoring;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Studies.Evidence
{
    public sealed class CandidateCollectorTests
    {
        [Test]
        public void CandidateCollector_AShot_IsADotOrNoneAsTheTruthSays()
        {
            var scenario = new SimulationScenario { DurationS = 1.2 };
            (scenario.ColorCamera.Width, scenario.ColorCamera.Height) = (320, 180);
            (scenario.Projector.Width, scenario.Projector.Height) = (320, 180);
            scenario.DepthCamera.Enabled = false;
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shots.Add(new ShotSettings { TimeS = 0.6, PulseMs = 60, ScreenM = new Vector2D(1.2, 0.5) });
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            var collector = new CandidateCollector();
            using (IFrameSource source = range.CreateColorSource())
            using (var frame = new Frame())
            {
                while (source.TryRead(frame))
                    collector.Process(frame, default);
            }

            TrueShot fired = range.Truth.Shots[0];
            var shot = new TruthShot("1", null, fired.FirstFrame, fired.LastFrame, new[] { fired.FirstLightPx });
            WeighedCandidate dot = Label(collector, shot, null).Single(c => c.Label == CandidateLabel.FirstDot);
            Assert.That(collector.Measures, Has.Length.EqualTo(Enum.GetValues<DotFeature>().Length));
            Assert.That(dot.Features, Has.Length.EqualTo(collector.Measures.Length));
            Assert.That(dot.LogOdds, Is.GreaterThan(0));
            Assert.That(Label(collector, null, shot).Any(c => c.Features == dot.Features), Is.False, "too weak to be judged: left out");
            Assert.That(Label(collector, null, null).Single(c => c.Features == dot.Features).Label, Is.EqualTo(CandidateLabel.NoDot));
        }

        [Test]
        public void RandomRange_SameSeed_IsTheSameRange()
        {
            RandomRange a = new(3), b = new(3), c = new(4);
            Assert.That(b.Shots.Select(s => s.PlacesPx[0]), Is.EqualTo(a.Shots.Select(s => s.PlacesPx[0])));
            Assert.That(c.Shots.Select(s => s.PlacesPx[0]), Is.Not.EqualTo(a.Shots.Select(s => s.PlacesPx[0])));
            Assert.That(a.Shots, Is.Not.Empty);
        }

        private static List<WeighedCandidate> Label(CandidateCollector collector, TruthShot? shot, TruthShot? neither) =>
            collector.Label(0, 0, shot == null ? [] : [shot], neither == null ? [] : [neither]).ToList();
    }
}
