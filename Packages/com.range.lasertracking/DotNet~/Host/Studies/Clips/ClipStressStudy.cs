using System;
using System.Linq;
using System.Threading;
using LaserTracking.Detection;
using LaserTracking.Host.Scoring;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>The recorded clips, as they are and made harder in ways that rooms and cameras do.</summary>
    internal sealed class ClipStressStudy : IStudy
    {
        public string Name => "clips-stress";

        public string What => "the recorded clips with noise, exposure steps, shaking and other exposures";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted) => Run(ClipSet.Open(), _ => null, options, interrupted);

        /// <param name="clips">To be played.</param>
        /// <param name="settingsOf">The detector's for the clip with this index; its defaults where null.</param>
        /// <param name="options">Which cases, and the progress line.</param>
        /// <param name="interrupted">Ends the study.</param>
        public static StudyTable Run(ClipSet clips, Func<int, ShotDetectorSettings?> settingsOf, StudyOptions options, CancellationToken interrupted)
        {
            PictureStress[] cases = PictureStress.All().Where(c => options.Includes(c.Name)).ToArray();
            ClipTally[] tallies = cases.Select(_ => new ClipTally()).ToArray();
            int played = 0, shots = 0;
            for (int index = 0; index < clips.Clips.Count; index++)
            {
                TruthClip clip = clips.Clips[index];
                ShotDetectorSettings? settings = settingsOf(index);
                ClipRun[] runs = cases.Select(_ => new ClipRun(settings)).ToArray();
                StressedClip.Play(clips, clip, cases, options, (i, frame, shiftPx) => runs[i].Process(frame, shiftPx), interrupted);
                if (interrupted.IsCancellationRequested)
                    break;
                played++;
                shots += clip.Shots.Count;
                for (int i = 0; i < cases.Length; i++)
                    tallies[i].Add(clip, runs[i].Reported, runs[i].WhyNot);
            }

            var table = new StudyTable((played < clips.Clips.Count ? played + " of " : "") + clips.Clips.Count + " clips, " + shots + " shots; step: ten frames each as they are, brighter, as they are, darker; shake: whole pixels, smooth: fractions", ClipTally.Columns);
            for (int i = 0; i < cases.Length; i++)
                tallies[i].Write(cases[i].Name, table);
            return table;
        }
    }
}
