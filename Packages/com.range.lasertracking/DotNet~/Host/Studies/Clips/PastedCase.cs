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
    /// <summary>Dots added to clips: how strong, and whether only on what moves.</summary>
    /// <param name="Strength">Through the strength of the dot that was cut out.</param>
    /// <param name="IsOnMotion">Only where the picture changes.</param>
    internal sealed record PastedCase(double Strength, bool IsOnMotion)
    {
        private const int EveryFrames = 13;
        private const int Margin = 24;

        /// <summary>Mean change from frame to frame, levels, from which a place counts as moving.</summary>
        private const double MovingLevels = 4;

        public string Name => FormattableString.Invariant($"{(IsOnMotion ? "moving" : "anywhere")}-{Strength}");

        /// <summary>The cases that the detector's figures are given for.</summary>
        public static PastedCase[] All() => new[] { false, true }.SelectMany(isOnMotion => new[] { 1, 0.35, 0.15 }.Select(strength => new PastedCase(strength, isOnMotion))).ToArray();

        /// <summary>Reads a clip with dots added to it.</summary>
        /// <param name="clips">Where the clip lies.</param>
        /// <param name="clip">To be read.</param>
        /// <param name="templates">The dots.</param>
        /// <param name="random">Draws dots and places.</param>
        /// <param name="process">Takes each frame.</param>
        /// <param name="interrupted">Ends the reading.</param>
        /// <returns>The clip with the added dots as its truth.</returns>
        public TruthClip Play(ClipSet clips, TruthClip clip, IReadOnlyList<DotTemplate> templates, Random random, Action<Frame> process, CancellationToken interrupted)
        {
            var pasted = new List<PastedDot>();
            int next = EveryFrames;
            using IFrameSource source = new PrefetchingFrameSource(FrameSources.OpenScreenCamera(clips.PathOf(clip)));
            using var frame = new Frame();
            using var before = new Frame();
            while (!interrupted.IsCancellationRequested && source.TryRead(frame))
            {
                if (frame.Index >= next && TryPlace(frame, before, clip, random, templates, out PastedDot dot))
                {
                    pasted.Add(dot);
                    next = frame.Index + EveryFrames;
                }

                before.Color.CopyFrom(frame.Color);
                if (pasted.Count > 0 && frame.Index < pasted[^1].FirstFrame + pasted[^1].Frames)
                    pasted[^1].Template.Paste(frame.Color, pasted[^1].X, pasted[^1].Y, Strength);
                process(frame);
            }

            return new TruthClip(clip.File, clip.Width, pasted.Select((p, i) => Truth(p, clip, i)).ToArray());
        }

        private static TruthShot Truth(PastedDot dot, TruthClip clip, int index) =>
            new(clip.File + "+" + index, dot.Template.Color, dot.FirstFrame, dot.FirstFrame + dot.Frames - 1, new[] { new Vector2D(dot.X, dot.Y) });

        private bool TryPlace(Frame frame, Frame before, TruthClip clip, Random random, IReadOnlyList<DotTemplate> templates, out PastedDot dot)
        {
            dot = null!;
            int frames = 1 + random.Next(3);
            DotTemplate template = templates[random.Next(templates.Count)];
            for (int attempt = 0; attempt < 60; attempt++)
            {
                int x = random.Next(Margin, frame.Color.Width - Margin), y = random.Next(Margin, frame.Color.Height - Margin);
                bool isNearShot = clip.Shots.Any(s => Math.Abs(s.FirstVisibleFrame - frame.Index) < 12 && (s.PlacesPx[0] - new Vector2D(x, y)).Length < 90);
                if (isNearShot || !HasRoom(frame, x, y) || (IsOnMotion && MeanChange(frame, before, x, y) < MovingLevels))
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
