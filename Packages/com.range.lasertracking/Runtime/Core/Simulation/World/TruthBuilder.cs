using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Simulation
{
    /// <summary>Works out the truth of a session from its plan.</summary>
    internal static class TruthBuilder
    {
        public static SimulationTruth Build(SimulationScenario scenario, SceneView view, List<PlannedShot> plan, ShooterMotion[] motions,
            LightSampler light, LaserOptics optics, FrameTiming depthTiming)
        {
            var shots = new TrueShot[plan.Count];
            for (int i = 0; i < shots.Length; i++)
                shots[i] = Describe(scenario, view, plan[i], i + 1, motions, light);
            var dots = new List<TrueDot>();
            for (int frame = 0; frame < light.Timing.Count; frame++)
            {
                Vector2D shift = light.ShiftPx(frame);
                for (int i = 0; i < shots.Length; i++)
                {
                    if (!light.TryGetLight(plan[i], frame, shift, out double begin, out double end))
                        continue;
                    dots.Add(Gather(plan[i], i + 1, frame, shift, begin, end, light, optics));
                    if (shots[i].FirstFrame < 0)
                        shots[i].FirstFrame = frame;
                    shots[i].LastFrame = frame;
                }
            }

            return new SimulationTruth(scenario, motions, light, depthTiming, shots, dots.ToArray());
        }

        private static TrueDot Gather(PlannedShot shot, int id, int frame, Vector2D shift, double begin, double end, LightSampler light, LaserOptics optics)
        {
            int count = light.SampleCount(shot, shift, begin, end);
            Vector2D sum = default;
            for (int i = 0; i < count; i++)
                sum += light.ImagePx(shot, LightSampler.SampleTimeS(begin, end, i, count), shift);
            Vector2D first = light.ImagePx(shot, begin / 1e6, shift), last = light.ImagePx(shot, end / 1e6, shift);
            double peak = optics.Peak(shot.Shooter, sum * (1.0 / count) - shift, begin / 1e6, end - begin, (last - first).Length);
            return new TrueDot(id, frame, sum * (1.0 / count), first, last, end - begin, peak * light.ExposureFactor(frame));
        }

        private static TrueShot Describe(SimulationScenario scenario, SceneView view, PlannedShot shot, int id, ShooterMotion[] motions, LightSampler light)
        {
            ShooterSettings shooter = scenario.Shooters[shot.Shooter];
            TrueHand hand = motions[shot.Shooter].Hand(shot.StartS);
            var truth = new TrueShot
            {
                Id = id,
                SceneTimeUs = (long)Math.Round(shot.StartS * 1e6),
                TimeUs = light.Timing.ToClockUs(shot.StartS * 1e6),
                PulseUs = (shot.EndS - shot.StartS) * 1e6,
                Shooter = shot.Shooter + 1,
                Hand = shooter.Hand,
                Color = shooter.Laser.Color,
                ScreenM = hand.DotM,
                MuzzleM = hand.MuzzleM,
                Direction = hand.LightDirection,
                AimedAt = shot.Target >= 0 ? view.Scene.Objects[shot.Target].Name : "",
            };
            Vector2D shift = default;
            foreach (NudgeSettings nudge in scenario.Nudges)
            {
                if (nudge.TimeS <= shot.StartS)
                    shift += nudge.ShiftPx;
            }

            truth.FirstLightPx = light.ImagePx(shot, shot.StartS, shift);
            int picture = SimulationTruth.PictureShown(scenario.Projector, shot.StartS * 1e6);
            Name(view, hand.DotM, shot.StartS, out string target, out TargetZone? zone);
            truth.Target = target;
            truth.Zone = zone?.Name ?? "";
            truth.Points = zone?.Points ?? 0;
            Name(view, hand.DotM, picture / scenario.Projector.RefreshHz, out target, out zone);
            truth.ShownTarget = target;
            truth.ShownZone = zone?.Name ?? "";
            return truth;
        }

        private static void Name(SceneView view, Vector2D screenM, double timeS, out string target, out TargetZone? zone)
        {
            int index = view.Pick(screenM, timeS, out int zoneIndex, out _);
            target = index < 0 ? "" : view.Scene.Objects[index].Name;
            zone = index < 0 ? null : view.Scene.Objects[index].Target!.Zones[zoneIndex];
        }
    }
}
