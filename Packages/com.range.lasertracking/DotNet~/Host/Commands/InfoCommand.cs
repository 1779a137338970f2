using System;
using System.CommandLine;
using System.Threading.Tasks;
using LaserTracking.Host.Sources;

namespace LaserTracking.Host.Commands
{
    /// <summary>range info: what a recording holds, as JSON.</summary>
    internal static class InfoCommand
    {
        public static Command Create()
        {
            var input = new Argument<string>("INPUT") { Description = "An Azure Kinect recording, a video, or a folder of numbered images." };
            var command = new Command("info", "Says what a recording holds, as JSON; damage is listed under \"problems\".") { input };
            command.SetAction((parsed, interrupted) =>
            {
                Console.WriteLine(FrameSources.Describe(parsed.GetValue(input)!, interrupted));
                return Task.FromResult(ExitCodes.Done);
            });
            return command;
        }
    }
}
