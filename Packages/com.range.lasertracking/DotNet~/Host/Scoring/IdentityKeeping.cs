using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host.Studies;
using LaserTracking.Host.Tracks;

namespace LaserTracking.Host.Scoring
{
    /// <summary>
    /// Whether true dots keep their numbers. In a frame a true dot has the number of the tracked box nearest to it, if that lies within
    /// 20 px; what a tracker does not show counts neither for nor against it (CLEAR MOT counts that).
    /// </summary>
    internal sealed class IdentityKeeping
    {
        private const double NearPx = 20;

        /// <summary>Frames beside a gap in which the dot's number is looked for.</summary>
        private const int SearchedFrames = 10;

        private readonly List<SortedDictionary<int, int?>> _numbers = new();

        /// <param name="truth">Visible dots; by frame.</param>
        /// <param name="tracks">By frame.</param>
        public IdentityKeeping(IReadOnlyList<MotRow> truth, IReadOnlyList<MotRow> tracks)
        {
            ILookup<int, MotRow> tracksOfFrame = tracks.ToLookup(row => row.Frame);
            foreach (IGrouping<int, MotRow> dot in truth.GroupBy(row => row.Id))
                _numbers.Add(new SortedDictionary<int, int?>(dot.ToDictionary(row => row.Frame, row => Nearest(row, tracksOfFrame[row.Frame]))));
        }

        /// <summary>Of all dots that have a number and have one so many frames later too: it is the same. Every frame is a beginning.</summary>
        public Proportion KeptOver(int frames)
        {
            int kept = 0, all = 0;
            foreach (SortedDictionary<int, int?> numbers in _numbers)
            {
                foreach ((int frame, int? before) in numbers)
                {
                    if (before == null || !numbers.TryGetValue(frame + frames, out int? after) || after == null)
                        continue;
                    all++;
                    kept += before == after ? 1 : 0;
                }
            }

            return new Proportion(kept, all);
        }

        /// <summary>Of all gaps in which a dot was hidden for so many frames: the number is the same before and after.</summary>
        public Proportion KeptThroughGaps(int leastHidden, int mostHidden)
        {
            int kept = 0, all = 0;
            foreach (SortedDictionary<int, int?> numbers in _numbers)
            {
                int[] frames = numbers.Keys.ToArray();
                for (int i = 1; i < frames.Length; i++)
                {
                    int hidden = frames[i] - frames[i - 1] - 1;
                    if (hidden < leastHidden || hidden > mostHidden)
                        continue;
                    int? before = frames.Take(i).Reverse().Take(SearchedFrames).Select(f => numbers[f]).FirstOrDefault(n => n != null);
                    int? after = frames.Skip(i).Take(SearchedFrames).Select(f => numbers[f]).FirstOrDefault(n => n != null);
                    if (before == null)
                        continue;
                    all++;
                    kept += before == after ? 1 : 0;
                }
            }

            return new Proportion(kept, all);
        }

        private static int? Nearest(MotRow dot, IEnumerable<MotRow> tracked)
        {
            int? number = null;
            double nearest = NearPx;
            foreach (MotRow box in tracked)
            {
                double distance = new Vector2D(box.Box.CenterX - dot.Box.CenterX, box.Box.CenterY - dot.Box.CenterY).Length;
                if (distance > nearest)
                    continue;
                nearest = distance;
                number = box.Id;
            }

            return number;
        }
    }
}
