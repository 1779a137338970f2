using System;
using System.Collections.Generic;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>Runs detector and tracker over a simulated range and pairs what they report with what was fired.</summary>
    internal static class ShotCollector
    {
        private const double MatchPx = 12;

        /// <param name="scenario">What is fired; three shooters on the default scene.</param>
        /// <param name="told">Shots of a tracker that is told shutter and row time are added here.</param>
        /// <param name="untold">Shots of a tracker that is not; null: none runs.</param>
        /// <param name="interrupted">Ends the run early.</param>
        public static void Collect(SimulationScenario scenario, List<MeasuredShot> told, List<MeasuredShot>? untold, CancellationToken interrupted)
        {
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            var detector = new ShotDetector();
            detector.SetScreenPolygon(range.Calibration.Screen.CornersPx);
            var settings = new ShotTrackerSettings();
            settings.Timing.ExposureUs = scenario.ColorCamera.ExposureUs;
            settings.Timing.RowUs = scenario.ColorCamera.RollingShutterRowUs;
            ShotTracker knowing = new(settings), unknowing = new();
            HashSet<int> takenByKnowing = new(), takenByUnknowing = new();
            var detections = new Detections();
            using IFrameSource source = range.CreateColorSource();
            using var frame = new Frame();
            while (!interrupted.IsCancellationRequested && source.TryRead(frame))
            {
                detections.Begin(frame.Index, frame.TimeUs);
                detector.Process(frame, detections);
                Track(knowing, detections, range.Truth, scenario, takenByKnowing, told);
                if (untold != null)
                    Track(unknowing, detections, range.Truth, scenario, takenByUnknowing, untold);
            }
        }

        private static void Track(ShotTracker tracker, Detections detections, SimulationTruth truth, SimulationScenario scenario, HashSet<int> taken, List<MeasuredShot> shots)
        {
            tracker.Process(detections);
            foreach (Shot shot in tracker.Shots)
            {
                if (Find(truth, shot, scenario, taken) is { } match)
                    shots.Add(match);
            }
        }

        /// <summary>The nearest pulse not yet taken whose light the shot's first frame shows within reach.</summary>
        private static MeasuredShot? Find(SimulationTruth truth, in Shot shot, SimulationScenario scenario, HashSet<int> taken)
        {
            double best = MatchPx * scenario.ColorCamera.Width / 640;
            MeasuredShot? match = null;
            foreach (TrueDot dot in truth.DotsOf(shot.FirstFrameIndex))
            {
                double distance = (dot.PositionPx - shot.Dot.PositionPx).Length - dot.StreakPx.Length / 2;
                if (distance >= best || taken.Contains(dot.ShotId))
                    continue;
                best = distance;
                match = new MeasuredShot(scenario.Name, shot, truth.Shots[dot.ShotId - 1], dot, scenario.ColorCamera.ExposureUs);
            }

            if (match != null)
                taken.Add(match.Fired.Id);
            return match;
        }
    }
}
