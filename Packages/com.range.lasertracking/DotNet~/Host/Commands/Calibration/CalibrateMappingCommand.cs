using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using System.Text;
using LaserTracking.Geometry;
using LaserTracking.Host.Calibration;
using LaserTracking.Host.Sessions;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate mapping: where in the colour picture lies what the infrared picture shows, for things on one plane.</summary>
    internal static class CalibrateMappingCommand
    {
        private const double JudgedWidthPx = 1920, DefaultLimitPx = 0.5;
        private const string Remedy = "give \"infrared\" and \"color\", each with image_size, K, dist, px and, unless both list the same points, ids";

        public static Command Create()
        {
            var corners = new Option<string>("--corners") { HelpName = "FILE", Required = true, Description = "JSON: \"infrared\" and \"color\" (or \"ir\"; also inside \"registration\"), each with the camera (image_size, K, dist) and points of one plane (px, ids)." };
            var output = new Option<string>("--out") { HelpName = "FILE", Description = "The mapping to write.", DefaultValueFactory = _ => "mapping.json" };
            var limit = new Option<double>("--limit") { HelpName = "PX", Description = "Largest held-out error that passes, RMS, px of a colour picture 1920 wide.", DefaultValueFactory = _ => DefaultLimitPx };
            var command = new Command("mapping", "Lays the infrared picture on the colour picture, from points of one plane seen in both; exit 1 over the limit.") { corners, output, limit };
            command.SetAction(parsed => Run(parsed.GetValue(corners)!, parsed.GetValue(output)!, parsed.GetValue(limit)));
            return command;
        }

        private static int Run(string file, string target, double limitPx)
        {
            if (!(limitPx >= 0))
                throw new InputException("--limit", "must be a number of pixels, 0 or more", "write it as 0.5");
            ResultFile.CheckNotRead(target, file);
            JObject root = CalibrationJson.ReadFile(file);
            CalibrationJson.CheckVersion(root, file);
            root = root["registration"] as JObject ?? root;
            (LensCamera infrared, Dictionary<int, Vector2D> infraredPx) = Seen(root["infrared"] ?? root["ir"], file, "infrared");
            (LensCamera color, Dictionary<int, Vector2D> colorPx) = Seen(root["color"], file, "color");
            int[] common = infraredPx.Keys.Where(colorPx.ContainsKey).Order().ToArray();
            InfraredMapping mapping = Fit(common);
            if (IsMirrored(mapping, infrared, infraredPx[common[0]]))
                throw new InputException(file, "the infrared picture is mirrored against the colour picture, or its points run the wrong way round", "give the pictures as the cameras see the plane, both from one side");

            // Either half of the points proves the other half's fit.
            var heldOut = new List<double>();
            for (int half = 0; half < 2 && common.Length >= 10; half++)
                heldOut.AddRange(Squares(Fit(common.Where((_, i) => i % 2 == half)), common.Where((_, i) => i % 2 != half)));
            double rms = Math.Sqrt(Squares(mapping, common).Average()), proven = heldOut.Count == 0 ? double.NaN : Math.Sqrt(heldOut.Average());
            double ignored = Math.Sqrt(Squares(Fit(common, isLensIgnored: true), common).Average());
            var result = new JObject
            {
                ["v"] = CalibrationJson.Version, ["kind"] = "mapping", ["points"] = common.Length, ["rms_px_1920"] = rms,
                ["held_out"] = new JObject { ["n"] = heldOut.Count, ["rms_px_1920"] = heldOut.Count == 0 ? null : proven },
                ["lenses_ignored_rms_px_1920"] = ignored,
                ["infrared"] = LensCameraJson.Format(infrared), ["color"] = LensCameraJson.Format(color),
                ["H_rays"] = CalibrationJson.Rows(mapping.RayHomography.ToArray(), 3),
            };
            Console.WriteLine(result.ToString());
            if (!((heldOut.Count > 0 ? proven : rms) <= limitPx))
            {
                Console.Error.WriteLine(FormattableString.Invariant($"range: the {(heldOut.Count > 0 ? "held-out " : string.Empty)}error is {(heldOut.Count > 0 ? proven : rms):F2} px RMS at {JudgedWidthPx} px width, over the limit of {limitPx} px; nothing was written"));
                return ExitCodes.CheckFailed;
            }

            if (heldOut.Count == 0)
                Console.Error.WriteLine($"range: {common.Length} points are too few to hold half of them out: nothing proves this mapping");
            if ((long)infrared.Pinhole.Width * infrared.Pinhole.Height > (long)color.Pinhole.Width * color.Pinhole.Height)
                Console.Error.WriteLine(FormattableString.Invariant($"range: {file}: infrared is the larger picture ({infrared.Pinhole.Width}x{infrared.Pinhole.Height}, color {color.Pinhole.Width}x{color.Pinhole.Height}): are the two exchanged?"));
            using var written = new ResultFile(target);
            written.Stream.Write(Encoding.UTF8.GetBytes(result.ToString().ReplaceLineEndings("\n") + "\n"));
            written.Commit();
            return ExitCodes.Done;

            InfraredMapping Fit(IEnumerable<int> ids, bool isLensIgnored = false)
            {
                int[] used = ids.ToArray();
                LensCamera Of(LensCamera camera) => isLensIgnored ? new LensCamera(camera.Pinhole, BrownDistortion.None) : camera;
                return InfraredMapping.TryFitPlane(Of(infrared), Of(color), used.Select(id => infraredPx[id]).ToArray(), used.Select(id => colorPx[id]).ToArray(), out InfraredMapping? found, out string reason)
                    ? found!
                    : throw new InputException(file, reason, "give at least four points of one plane, seen by both cameras and not on one line");
            }

            IEnumerable<double> Squares(InfraredMapping judged, IEnumerable<int> ids)
            {
                double scale = JudgedWidthPx / color.Pinhole.Width;
                return ids.Select(id => judged.TryMap(infraredPx[id], out Vector2D at) ? (at - colorPx[id]).LengthSquared * scale * scale : double.PositiveInfinity);
            }
        }

        private static (LensCamera Camera, Dictionary<int, Vector2D> Px) Seen(JToken? token, string file, string name)
        {
            if (token is not JObject camera || camera["px"] is not JArray list)
                throw new InputException(file, $"field {name} is missing, or has no px", Remedy);
            LensCamera lens = LensCameraJson.Parse(camera, file, name + ".");
            var ids = camera["ids"] as JArray;
            if (ids != null && ids.Count != list.Count)
                throw new InputException(file, FormattableString.Invariant($"{name} has {list.Count} points and {ids.Count} ids"), "every point needs its own");
            var px = new Dictionary<int, Vector2D>();
            for (int i = 0; i < list.Count; i++)
            {
                double[] at = CalibrationJson.Numbers(list[i], 2, file, FormattableString.Invariant($"{name}.px, point {i + 1}"));
                if (ids != null && !(ids[i].Type == JTokenType.Integer && (double)ids[i] is >= 0 and <= int.MaxValue))
                    throw new InputException(file, FormattableString.Invariant($"field {name}.ids, element {i + 1}, is no whole number from 0 on"), Remedy);
                if (!px.TryAdd(ids == null ? i : (int)ids[i], new Vector2D(at[0], at[1])))
                    throw new InputException(file, FormattableString.Invariant($"{name} has id {ids![i]} twice"), "every point needs its own");
            }

            if (ScreenPoints.FirstOutside(px.Values.ToArray(), lens.Pinhole.Width, lens.Pinhole.Height) is string outside)
                throw new InputException(file, $"field {name}.px, {outside}", "correct the point, or image_size");
            return (lens, px);
        }

        private static bool IsMirrored(InfraredMapping mapping, LensCamera infrared, Vector2D px)
        {
            if (!infrared.TryUnproject(px, out Vector2D ray))
                return false;
            mapping.RayHomography.Jacobian(ray, out double xx, out double xy, out double yx, out double yy);
            return xx * yy - xy * yx < 0;
        }
    }
}
