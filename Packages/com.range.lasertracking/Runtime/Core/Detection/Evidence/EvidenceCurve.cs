using System;

namespace LaserTracking.Detection
{
    /// <summary>What one measured quantity says for or against a laser dot: a step function to log-odds. Immutable.</summary>
    internal sealed class EvidenceCurve
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

        /// <summary>The edge nearest to a value beyond which it would speak for a dot (not against it); the value itself where it does already.</summary>
        public float NearestLimit(float value)
        {
            int at = Step(value);
            if (_values[at] >= 0)
                return value;
            float nearest = value, distance = float.PositiveInfinity;
            for (int step = 0; step < _values.Length; step++)
            {
                if (_values[step] < 0)
                    continue;
                float edge = step > at ? _edges[step - 1] : _edges[step];
                if (Math.Abs(edge - value) >= distance)
                    continue;
                distance = Math.Abs(edge - value);
                nearest = edge;
            }

            return nearest;
        }

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
