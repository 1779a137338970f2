using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Session;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Multiuser
{
    /// <summary>What was said of one true palm in one frame.</summary>
    /// <param name="ErrorMm">How far off it was; infinite where no hand was said to be there.</param>
    /// <param name="SigmaMm">Its standard deviation as stated; 0: it was not stated.</param>
    /// <param name="TrackId">The hand's number; 0 where none was said to be there.</param>
    internal readonly record struct SaidPalm(double ErrorMm, double SigmaMm, int TrackId)
    {
        /// <summary>A palm farther off is somebody else's.</summary>
        private const double OwnHandM = 0.3;

        /// <summary>What a normal distribution in three directions holds within so many standard deviations: a half, nine tenths.</summary>
        private const double HalfRadius = 1.538, NineTenthsRadius = 2.5;

        private static readonly double[] Bins = { 0, 8, 10, 12, 15, 1000 };

        public bool IsFound => double.IsFinite(ErrorMm);

        public bool IsStated => SigmaMm > 0;

        /// <summary>By weapon hand, in order of the shooters: all hands said and all true palms, hanging ones too, one to one with the least total distance.</summary>
        public static SaidPalm[] Match(SimulatedRange range, int depthFrame, IReadOnlyList<HandEvent> hands)
        {
            double timeUs = range.Truth.DepthFrameTimeUs(depthFrame);
            int[] people = Enumerable.Range(1, range.Scenario.Shooters.Count).ToArray();
            Vector3D[] palms = people.Select(s => range.Truth.HandAt(s, timeUs).PalmM)
                .Concat(people.Where(s => !range.Scenario.Shooters[s - 1].TwoHanded).Select(s => range.Truth.SupportPalmAt(s, timeUs))).ToArray();
            var said = new SaidPalm[people.Length];
            Array.Fill(said, new SaidPalm(double.PositiveInfinity, 0, 0));
            int columns = palms.Length + hands.Count;
            var costs = new double[hands.Count * columns];
            for (int i = 0; i < hands.Count; i++)
            {
                for (int k = 0; k < columns; k++)
                {
                    double distance = k < palms.Length ? (hands[i].PalmM - palms[k]).Length : k - palms.Length == i ? OwnHandM : double.PositiveInfinity;
                    costs[i * columns + k] = distance <= OwnHandM ? distance : HungarianAssignment.Forbidden;
                }
            }

            var chosen = new int[hands.Count];
            new HungarianAssignment(columns).Solve(costs, hands.Count, columns, chosen);
            for (int i = 0; i < hands.Count; i++)
            {
                if (chosen[i] >= 0 && chosen[i] < people.Length)
                    said[chosen[i]] = new SaidPalm(1000 * (hands[i].PalmM - palms[chosen[i]]).Length, 1000 * hands[i].PalmSigmaM, hands[i].TrackId);
            }

            return said;
        }

        /// <summary>One line for each range of what was stated: how many, and how many lie within the radii that it stands for.</summary>
        public static IEnumerable<string> Describe(IReadOnlyCollection<SaidPalm> all)
        {
            for (int i = 0; i + 1 < Bins.Length; i++)
            {
                SaidPalm[] bin = all.Where(p => p.IsStated && p.SigmaMm >= Bins[i] && p.SigmaMm < Bins[i + 1]).ToArray();
                if (bin.Length > 0)
                    yield return FormattableString.Invariant($"palm σ {Bins[i]:0}–{(i + 2 < Bins.Length ? Bins[i + 1].ToString("0") : "")} mm: {bin.Length}, said {bin.Average(p => p.SigmaMm):F1} mm; within the 50 % radius {new Proportion(bin.Count(p => p.ErrorMm <= HalfRadius * p.SigmaMm), bin.Length)}, the 90 % radius {new Proportion(bin.Count(p => p.ErrorMm <= NineTenthsRadius * p.SigmaMm), bin.Length)}");
            }
        }
    }
}
