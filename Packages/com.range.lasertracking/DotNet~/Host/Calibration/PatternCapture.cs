using System;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Host.Sources;
using LaserTracking.Host.Terminal;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Calibration
{
    /// <summary>What the camera saw of the projected pattern, from all inputs one after the other.</summary>
    internal static class PatternCapture
    {
        /// <summary>Twenty seconds at thirty frames a second: all four pictures come by several times.</summary>
        private const int MostFrames = 600;

        /// <exception cref="InputException">An input cannot be read, has no picture, or is of another size than the lens or the others.</exception>
        public static ScreenPatternView Look(string[] inputs, LensCamera? lens, CancellationToken interrupted)
        {
            using var finder = new ScreenPatternFinder();
            using var progress = new ProgressLine();
            using var frame = new Frame();
            int frames = 0;
            foreach (string input in inputs)
            {
                int before = frames;
                if (ImageFolder.IsImage(input) && ImageFileHeader.IsText(input))
                    throw new InputException(input, "this is a text, not a picture, whatever its name says", "name what the camera saw of the pattern");
                using IFrameSource source = CameraInput.Open(input);
                while (frames < MostFrames && source.TryRead(frame))
                {
                    interrupted.ThrowIfCancellationRequested();
                    if (!frame.Color.IsPresent)
                        continue;
                    if (lens != null && (frame.Color.Width, frame.Color.Height) != (lens.Pinhole.Width, lens.Pinhole.Height))
                        throw new InputException(input, FormattableString.Invariant($"its pictures are {frame.Color.Width}x{frame.Color.Height}, the camera's calibration is for {lens.Pinhole.Width}x{lens.Pinhole.Height}"), "take both at one size");
                    if (!finder.Add(frame.Color))
                        throw new InputException(input, FormattableString.Invariant($"its pictures are {frame.Color.Width}x{frame.Color.Height}, unlike those before, or too small"), "give pictures of one size, 64 pixels or more");
                    frames++;
                    progress.Show(FormattableString.Invariant($"{frames} frames …"));
                }

                if (frames == before && frames < MostFrames)
                    throw new InputException(input, "holds no picture that can be read", "record it again");
            }

            progress.Show("looking for the pattern …");
            ScreenPatternView view = finder.Find();
            progress.Clear();
            return view;
        }
    }
}
