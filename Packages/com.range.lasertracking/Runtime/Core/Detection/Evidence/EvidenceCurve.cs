using System;

namespace LaserTracking.Detection
{
    /// <summary>What one measured quantity says for or against a laser dot: a step function to log-odds. Immutable.</summary>
    public sealed class EvidenceCurve
    {
        private readonly float[] _edges;
        private readonly float[] _values;

        /// <param name="what">The quantity, for people.</param>
        /// <param name="reason">Why a candidate is rejected when this quantity speaks most against it.</param>
        /// <param name="edges">Where the steps lie, rising; a value at or above an edge has passed it.</param>
        /// <param name="values">Log-odds below, between and above the edges: one more than edges.</param>
        public EvidenceCurve(string what, RejectionReason reason, float[] edges, float[] values)
        {
            if (values.Length != edges.Length + 1)
                throw new ArgumentException("a curve needs one value more than edges", nameof(values));
            What = what;
            Reason = reason;
            _edges = edges;
            _values = values;
            Highest = Math.Max(float.MinValue, Largest(values));
        }

        public string What { get; }

        public RejectionReason Reason { get; }

        /// <summary>The most that this quantity can say for a dot.</summary>
        public float Highest { get; }

        /// <summary>Log-odds at a value; NaN counts as the lowest.</summary>
        public float At(float value) => _values[Step(value)];

        /// <summary>
        /// The value nearest to this one that would speak for a dot (not against it), or, where it does so already or no value would, say
        /// more; the value itself where nothing says more.
        /// </summary>
        public float NearestLimit(float value)
        {
            int at = Step(value);
            bool canChangeSides = _values[at] < 0 && Highest >= 0;
            float nearest = value, distance = float.PositiveInfinity;
            for (int step = 0; step < _values.Length; step++)
            {
                if (canChangeSides ? _values[step] < 0 : _values[step] <= _values[at])
                    continue;
                float edge = step > at ? _edges[step - 1] : Below(_edges[step]);
                if (Math.Abs(edge - value) >= distance)
                    continue;
                distance = Math.Abs(edge - value);
                nearest = edge;
            }

            return nearest;
        }

        /// <summary>A value at an edge has passed it: what stays below is a little smaller.</summary>
        private static float Below(float edge) => edge - Math.Max(1e-7f, 1e-6f * Math.Abs(edge));

        private int Step(float value)
        {
            int step = 0;
            while (step < _edges.Length && value >= _edges[step])
                step++;
            return step;
        }

        private static float Largest(float[] values)
        {
            float largest = values[0];
            foreach (float value in values)
                largest = Math.Max(largest, value);
            return largest;
        }
    }
}
