using System;
using System.CommandLine;
using System.IO;
using System.Text;
using LaserTracking.Host.Calibration;
using LaserTracking.Host.Pictures;
using LaserTracking.Host.Sessions;
using LaserTracking.Imaging;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate pattern: what the projector shows for the calibration of the screen.</summary>
    internal static class CalibratePatternCommand
    {
        public static Command Create()
        {
            var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where to write pattern-1.png … pattern-4.png and show.html, which shows them in turn.", DefaultValueFactory = _ => Path.Combine("out", "pattern") };
            var size = new Option<string>("--size") { HelpName = "WxH", Description = "The projector's picture in pixels.", DefaultValueFactory = _ => "1920x1080" };
            var command = new Command("pattern", "Writes the pictures to project for 'calibrate screen --image'.") { folder, size };
            command.SetAction(parsed => Write(parsed.GetValue(folder)!, ScreenPoints.PixelSize(parsed.GetValue(size)!, "--size")));
            return command;
        }

        private static int Write(string folder, (int Width, int Height) size)
        {
            if (!ScreenPattern.CanDraw(size.Width, size.Height))
                throw new InputException("--size", FormattableString.Invariant($"\"{size.Width}x{size.Height}\" cannot hold the pattern"), "give the projector's own size, 160 to 16384 px wide and between 16:6 and 16:14");
            var pattern = new ScreenPattern(size.Width, size.Height);
            using Image drawn = new(), colored = new();
            for (int i = 0; i < ScreenPattern.Pictures; i++)
            {
                pattern.Draw(i, drawn);
                ColorConversion.ToBgra(drawn, colored);
                Save(Path.Combine(folder, FileName(i)), PngEncoder.Encode(colored));
            }

            Save(Path.Combine(folder, "show.html"), Encoding.UTF8.GetBytes(Page()));
            Console.WriteLine(folder + ": open show.html on the projector, full screen, and record up to ten seconds of it with the camera");
            return ExitCodes.Done;
        }

        private static string FileName(int picture) => FormattableString.Invariant($"pattern-{picture + 1}.png");

        private static void Save(string path, byte[] content)
        {
            using var file = new ResultFile(path);
            file.Stream.Write(content);
            file.Commit();
        }

        /// <summary>Any browser shows the pictures in turn, a second each; a click makes it full screen.</summary>
        private static string Page()
        {
            var images = new StringBuilder();
            for (int i = 0; i < ScreenPattern.Pictures; i++)
                images.Append("<img src=\"").Append(FileName(i)).Append("\" alt=\"\">");
            return $$"""
                <!DOCTYPE html>
                <html lang="en"><head><meta charset="utf-8"><title>Calibration pattern</title>
                <style>html,body{margin:0;height:100%;background:#000;cursor:none;overflow:hidden}
                img{position:absolute;inset:0;width:100vw;height:100vh;visibility:hidden}img.shown{visibility:visible}</style></head>
                <body>{{images}}
                <script>
                const pictures = document.images;
                let at = 0;
                function next() { for (const p of pictures) p.classList.remove("shown"); pictures[at++ % pictures.length].classList.add("shown"); }
                next(); setInterval(next, 1000);
                document.body.addEventListener("click", () => document.documentElement.requestFullscreen());
                </script></body></html>

                """;
        }
    }
}
