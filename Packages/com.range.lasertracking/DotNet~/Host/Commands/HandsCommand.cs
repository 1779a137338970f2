using System;
using System.CommandLine;
using System.Globalization;
using System.Linq;
using System.Threading.Tasks;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Hands.Model;
using LaserTracking.Host.HandModels;
using LaserTracking.Host.Sources;
using Newtonsoft.Json;

namespace LaserTracking.Host.Commands
{
    /// <summary>range hands IMAGE: the hand landmark model on one picture.</summary>
    internal static class HandsCommand
    {
        private static readonly string[] RegionNames = { "CX", "CY", "SIDE", "ROTATION_RAD" };

        public static Command Create()
        {
            var image = new Argument<string>("IMAGE") { Description = "A picture (png, jpg, bmp, tif, ppm, …); of a video or recording the first frame." };
            var roi = new Option<string?>("--roi") { HelpName = "CX,CY,SIDE,ROTATION_RAD", Description = "The square to look at: centre and side in px (picture's corner = 0), rotation clockwise. Left out: the whole picture is searched." };
            var model = new Option<string>("--model") { HelpName = "NAME", Description = "lite (default) or full; './range models' fetches them.", DefaultValueFactory = _ => HandModelFile.Lite.Name };
            var command = new Command("hands", "Finds a hand's 21 landmarks in one picture, as JSON.") { image, roi, model };
            command.SetAction(parsed =>
            {
                HandModelFile file = HandModelStore.Named(parsed.GetValue(model)!);
                HandRegion? region = parsed.GetValue(roi) is { } text ? ParseRegion(text) : null;
                return Task.FromResult(Run(parsed.GetValue(image)!, region, file));
            });
            return command;
        }

        private static int Run(string path, HandRegion? region, HandModelFile file)
        {
            using HandLandmarkNetwork network = HandModelStore.Open(file);
            using IFrameSource source = FrameSources.OpenScreenCamera(path);
            using var frame = new Frame();
            if (!source.TryRead(frame) || !HandLandmarkNetwork.CanRead(frame.Color))
                throw new InputException(path, "has no picture that can be decoded", "give a picture, a video or a recording");
            var landmarks = new HandLandmarks();
            if (region is { } given)
                network.Run(frame.Color, given, landmarks);
            else if (!new HandSearch(network).TryFind(frame.Color, landmarks))
                Console.Error.WriteLine("range: " + path + ": no hand was found; what follows is the answer to the picture as a whole");
            Console.WriteLine(JsonConvert.SerializeObject(new
            {
                presence = landmarks.Presence,
                handedness = landmarks.RightHandProbability,
                landmarks_px = landmarks.PicturePx.ToArray().Select(Numbers),
                world_m = landmarks.WorldM.ToArray().Select(Numbers),
                roi = Describe(landmarks.Region),
                next_roi = Describe(landmarks.NextRegion),
            }));
            return ExitCodes.Done;
        }

        private static HandRegion ParseRegion(string text)
        {
            string[] words = text.Split(',');
            if (words.Length != RegionNames.Length)
                throw new InputException("--roi", $"\"{text}\" is not {string.Join(',', RegionNames)}", "give four numbers, for example 320,240,200,0");
            var values = new double[words.Length];
            for (int i = 0; i < words.Length; i++)
            {
                if (!double.TryParse(words[i], NumberStyles.Float, CultureInfo.InvariantCulture, out values[i]) || !(Math.Abs(values[i]) <= 1e6))
                    throw new InputException("--roi", $"{RegionNames[i]}: \"{words[i]}\" is not a number up to a million", "give four numbers, for example 320,240,200,0");
            }

            if (values[2] <= 0)
                throw new InputException("--roi", $"SIDE: \"{words[2]}\" is not above 0", "give the square's side in px");
            return new HandRegion(values[0], values[1], values[2], values[3]);
        }

        private static double[] Numbers(Vector3D point) => new[] { point.X, point.Y, point.Z };

        private static object Describe(HandRegion region) =>
            new { cx = region.CenterXPx, cy = region.CenterYPx, side = region.SidePx, rotation_rad = region.RotationRad };
    }
}
