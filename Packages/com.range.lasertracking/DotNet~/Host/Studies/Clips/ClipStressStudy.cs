using System;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Sources;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>The recorded clips, as they are and made harder in ways that rooms and cameras do.</summary>
    internal sealed class ClipStressStudy : IStudy
    {
        public string Name => "clips-stress";

        public string What => "the recorded clips with noise, exposure steps, shaking and other exposures";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            ClipSet clips = ClipSet.Open();
            PictureStress[] cases = PictureStress.All().Where(c => options.Includes(c.Name)).ToArray();
            ClipTally[] tallies = cases.Select(_ => new ClipTally()).ToArray();
            foreach (TruthClip clip in clips.Clips)
            {
                ClipRun[] runs = cases.Select(_ => new ClipRun()).ToArray();
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
                        runs[i].Process(stressed, shift);
                    }
                }

                for (int i = 0; i < cases.Length; i++)
                    tallies[i].Add(clip, runs[i].Reported);
            }

            var table = new StudyTable(clips.Clips.Count + " clips, " + clips.Clips.Sum(c => c.Shots.Count) + " shots; step: ten frames each as they are, brighter, as they are, darker; shake: whole pixels, smooth: fractions", ClipTally.Columns);
            for (int i = 0; i < cases.Length; i++)
                tallies[i].Write(cases[i].Name, table);
            return table;
        }
    }
}
