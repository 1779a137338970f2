using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Sources;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>Dots cut out of the clips and pasted elsewhere into all of them, also weaker and onto what moves.</summary>
    internal sealed class PastedDotsStudy : IStudy
    {
        private const int EveryFrames = 13;
        private const int Margin = 24;
        private static readonly double[] Strengths = { 1, 0.35, 0.15 };

        /// <summary>Mean change from frame to frame, levels, from which a place counts as moving.</summary>
        private const double MovingLevels = 4;

        public string Name => "pasted-dots";

        public string What => "dots of the recorded clips pasted into all of them at full, 0.35 and 0.15 strength, and on what moves";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            ClipSet clips = ClipSet.Open();
            List<DotTemplate> templates = DotTemplate.CutAll(clips, options.Progress.Show);
            var table = new StudyTable(clips.Clips.Count + " clips, " + templates.Count + " different dots of 1 to 3 frames", ClipTally.Columns);
            foreach (bool isOnMotion in new[] { false, true })
            {
                foreach (double strength in Strengths)
                {
                    string name = FormattableString.Invariant($"{(isOnMotion ? "moving" : "anywhere")}-{strength}");
                    if (options.Includes(name))
                        Run(name, strength, isOnMotion, clips, templates, options, interrupted).Write(name, table);
                }
            }

            table.Notes.Add("false shots are counted beside the clips' own shots, which are not counted as found");
            return table;
        }

        private static ClipTally Run(string name, double strength, bool isOnMotion, ClipSet clips, List<DotTemplate> templates, StudyOptions options, CancellationToken interrupted)
        {
            var tally = new ClipTally();
            var random = new Random(options.FirstSeed);
            foreach (TruthClip clip in clips.Clips)
            {
                options.Progress.Show(name + ", " + clip.File);
                var pasted = new List<PastedDot>();
                var run = new ClipRun();
                int next = EveryFrames;
                using IFrameSource source = new PrefetchingFrameSource(FrameSources.OpenScreenCamera(clips.PathOf(clip)));
                using var frame = new Frame();
                using var before = new Frame();
                while (!interrupted.IsCancellationRequested && source.TryRead(frame))
                {
                    if (frame.Index >= next && TryPlace(frame, before, clip, isOnMotion, random, templates, out PastedDot dot))
                    {
                        pasted.Add(dot);
                        next = frame.Index + EveryFrames;
                    }

                    before.Color.CopyFrom(frame.Color);
                    if (pasted.Count > 0 && frame.Index < pasted[^1].FirstFrame + pasted[^1].Frames)
                        pasted[^1].Template.Paste(frame.Color, pasted[^1].X, pasted[^1].Y, strength);
                    run.Process(frame, default);
                }

                tally.Add(new TruthClip(clip.File, clip.Width, pasted.Select((p, i) => Truth(p, clip, i)).ToArray()), run.Without(clip));
            }

            return tally;
        }

        private static TruthShot Truth(PastedDot dot, TruthClip clip, int index) =>
            new(clip.File + "+" + index, dot.Template.Color, dot.FirstFrame, dot.FirstFrame + dot.Frames - 1, new[] { new Vector2D(dot.X, dot.Y) });

        private static bool TryPlace(Frame frame, Frame before, TruthClip clip, bool isOnMotion, Random random, List<DotTemplate> templates, out PastedDot dot)
        {
            dot = null!;
            int frames = 1 + random.Next(3);
            DotTemplate template = templates[random.Next(templates.Count)];
            for (int attempt = 0; attempt < 60; attempt++)
            {
                int x = random.Next(Margin, frame.Color.Width - Margin), y = random.Next(Margin, frame.Color.Height - Margin);
                bool isNearShot = clip.Shots.Any(s => Math.Abs(s.FirstVisibleFrame - frame.Index) < 12 && (s.PlacesPx[0] - new Vector2D(x, y)).Length < 90);
                if (isNearShot || !HasRoom(frame, x, y) || (isOnMotion && MeanChange(frame, before, x, y) < MovingLevels))
                    continue;
                dot = new PastedDot(frame.Index, frames, x, y, template);
                return true;
            }

            return false;
        }

        /// <summary>Light added to white shows nothing.</summary>
        private static unsafe bool HasRoom(Frame frame, int x, int y)
        {
            int room = 0;
            for (int dy = -2; dy <= 2; dy++)
            {
                byte* pixel = frame.Color.Pixels + (y + dy) * (long)frame.Color.Stride + 4 * (x - 2);
                for (int i = 0; i < 5; i++, pixel += 4)
                    room += 255 - Math.Min(pixel[0], Math.Min(pixel[1], pixel[2]));
            }

            return room >= 25 * 64;
        }

        private static unsafe double MeanChange(Frame frame, Frame before, int x, int y)
        {
            if (!before.Color.IsPresent)
                return 0;
            int sum = 0;
            for (int dy = -12; dy < 12; dy++)
            {
                byte* now = frame.Color.Pixels + (y + dy) * (long)frame.Color.Stride + 4 * (x - 12);
                byte* then = before.Color.Pixels + (y + dy) * (long)before.Color.Stride + 4 * (x - 12);
                for (int i = 0; i < 24 * 4; i++)
                    sum += Math.Abs(now[i] - then[i]);
            }

            return sum / (24.0 * 24 * 3);
        }
    }
}
