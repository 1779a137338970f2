using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Host.Scoring;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>Dots cut out of the clips and pasted elsewhere into all of them, also weaker and onto what moves.</summary>
    internal sealed class PastedDotsStudy : IStudy
    {
        public string Name => "pasted-dots";

        public string What => "dots of the recorded clips pasted into all of them at full, 0.35 and 0.15 strength, and on what moves";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            ClipSet clips = ClipSet.Open();
            List<DotTemplate> templates = DotTemplate.CutAll(clips, options.Progress.Show);
            var table = new StudyTable(clips.Clips.Count + " clips, " + templates.Count + " different dots of 1 to 3 frames", ClipTally.Columns);
            foreach (PastedCase pasted in PastedCase.All().Where(c => options.Includes(c.Name)))
            {
                var tally = new ClipTally();
                var random = new Random(options.FirstSeed);
                foreach (TruthClip clip in clips.Clips)
                {
                    options.Progress.Show(pasted.Name + ", " + clip.File);
                    var run = new ClipRun();
                    TruthClip truth = pasted.Play(clips, clip, templates, random, frame => run.Process(frame, default), interrupted);
                    if (interrupted.IsCancellationRequested)
                        return table;
                    tally.Add(truth, run.Without(clip), run.WhyNot);
                }

                tally.Write(pasted.Name, table);
            }

            table.Notes.Add("false shots are counted beside the clips' own shots, which are not counted as found");
            return table;
        }
    }
}
