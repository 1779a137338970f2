using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Sessions
{
    /// <summary>Writes what was really fired on the simulated range, in the layout of truth files that 'score' reads.</summary>
    internal static class SimulationTruthWriter
    {
        /// <param name="truth">Of the range that was rendered.</param>
        /// <param name="name">What the events name as their input.</param>
        /// <param name="scenario">For the picture's size.</param>
        /// <param name="path">File to write.</param>
        public static void Write(SimulationTruth truth, string name, SimulationScenario scenario, string path)
        {
            ILookup<int, TrueDot> dots = Dots(truth).ToLookup(d => d.ShotId);
            var clip = new JObject
            {
                ["file"] = name,
                ["width"] = scenario.ColorCamera.Width,
                ["height"] = scenario.ColorCamera.Height,
                ["frames"] = truth.ColorFrameCount,
                ["shots"] = new JArray(truth.Shots.Where(s => s.FirstFrame >= 0).Select(s => Shot(s, dots[s.Id]))),
            };
            using var file = new ResultFile(path);
            file.Stream.Write(Encoding.UTF8.GetBytes(new JObject { ["clips"] = new JArray(clip) }.ToString(Formatting.Indented) + "\n"));
            file.Commit();
        }

        private static IEnumerable<TrueDot> Dots(SimulationTruth truth)
        {
            for (int frame = 0; frame < truth.ColorFrameCount; frame++)
            {
                foreach (TrueDot dot in truth.DotsOf(frame).ToArray())
                    yield return dot;
            }
        }

        private static JObject Shot(TrueShot shot, IEnumerable<TrueDot> dots) => new()
        {
            ["id"] = shot.Id,
            ["color"] = shot.Color.ToString().ToLowerInvariant(),
            ["first_visible_frame"] = shot.FirstFrame,
            ["last_visible_frame"] = shot.LastFrame,
            ["x_px"] = shot.FirstLightPx.X,
            ["y_px"] = shot.FirstLightPx.Y,
            ["path"] = new JArray(dots.Select(d => new JArray(d.Frame, d.PositionPx.X, d.PositionPx.Y))),
            ["time_us"] = shot.TimeUs,
            ["screen_m"] = Point(shot.ScreenM),
            ["shooter"] = shot.Shooter,
            ["muzzle_m"] = new JArray(shot.MuzzleM.X, shot.MuzzleM.Y, shot.MuzzleM.Z),
            ["target"] = shot.Target,
            ["zone"] = shot.Zone,
        };

        private static JArray Point(Vector2D p) => new(p.X, p.Y);
    }
}
