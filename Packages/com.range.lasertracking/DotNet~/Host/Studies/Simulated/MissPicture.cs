using System;
using System.IO;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Explanations;
using LaserTracking.Host.Pictures;
using LaserTracking.Host.Sessions;
using LaserTracking.Host.Terminal;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Simulated
{
    /// <summary>Draws why a shot was missed, below out/study.</summary>
    internal static class MissPicture
    {
        /// <summary>Returns the verdict and the file.</summary>
        public static string Draw(SimulatedRange range, TracedShot shot, string name, CancellationToken interrupted)
        {
            string path = Path.Combine("out", "study", name);
            Vector2D at = shot.Truth.PlacesPx[Math.Min(shot.Truth.PlacesPx.Count - 1, 1 + shot.BestFrame - shot.Truth.FirstVisibleFrame)];
            using var file = new ResultFile(path);
            using IFrameSource source = new PrefetchingFrameSource(range.CreateColorSource());
            using var progress = new ProgressLine();
            using ExplainedFrame explained = new FrameExaminer(new ShotDetector()).Run(source, range.Scenario.Name, shot.BestFrame, at, progress, interrupted);
            using Canvas canvas = ExplanationPicture.Draw(explained, at);
            file.Stream.Write(PngEncoder.Encode(canvas.Image));
            file.Commit();
            string verdict = explained.At(at)?.Verdict ?? SpotReason.Lines(explained, at)[0];
            return verdict + " (" + path + ")";
        }
    }
}
