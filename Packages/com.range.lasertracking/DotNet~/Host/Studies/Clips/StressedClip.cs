using System;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Sources;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>Reads a clip once and gives each of its frames in every stressed form.</summary>
    internal static class StressedClip
    {
        /// <param name="clips">Where the clip lies.</param>
        /// <param name="clip">To be read.</param>
        /// <param name="cases">In which forms.</param>
        /// <param name="options">For the progress line.</param>
        /// <param name="process">Index of the case, frame (valid only during the call), by how much it was displaced on purpose, px.</param>
        /// <param name="interrupted">Ends the reading.</param>
        public static void Play(ClipSet clips, TruthClip clip, PictureStress[] cases, StudyOptions options, Action<int, Frame, Vector2D> process, CancellationToken interrupted)
        {
            using IFrameSource source = new PrefetchingFrameSource(FrameSources.OpenScreenCamera(clips.PathOf(clip)));
            using var frame = new Frame();
            using var stressed = new Frame();
            while (!interrupted.IsCancellationRequested && source.TryRead(frame))
            {
                options.Progress.Show(FormattableString.Invariant($"{clip.File}, frame {frame.Index}"));
                for (int i = 0; i < cases.Length; i++)
                {
                    stressed.Begin(frame.Index, frame.TimeUs);
                    stressed.Color.CopyFrom(frame.Color);
                    Vector2D shift = cases[i].Apply(frame.Color, frame.Index, stressed.Color);
                    process(i, stressed, shift);
                }
            }
        }
    }
}
