using System;
using LaserTracking.Geometry;

namespace LaserTracking.Remote
{
    /// <summary>
    /// The members of a message's object by name: known ones as the bytes of their values, null counts as missing, others are passed
    /// over. A numeric value that is wrong is remembered, so that a reader may take all it wants and ask at the end.
    /// </summary>
    internal ref struct MessageFields
    {
        private static readonly string[] Names =
        {
            "v", "type", "stream", "counter", "sent_us", "time_us", "id", "frame", "first_frame", "last_frame", "time_sigma_us", "x_px", "y_px", "cov_px",
            "peak", "area_px", "color", "confidence", "streak_px", "screen_m", "screen_cov_mm2", "shooter", "shooter_p", "hand", "muzzle_m", "direction",
            "pair_dt_us", "palm_m", "palm_sigma_m", "track", "timestamp", "muzzle", "target", "shot",
        };

        private readonly ReadOnlySpan<byte> _text;
        private readonly Span<int> _places;

        /// <summary>Room that a caller gives for the places of values: start and length of each.</summary>
        public static int Room => 2 * Names.Length;

        /// <param name="text">A well-formed object.</param>
        /// <param name="places">As long as <see cref="Room"/>.</param>
        public MessageFields(ReadOnlySpan<byte> text, Span<int> places)
        {
            _text = text;
            _places = places;
            Problem = RemoteDrop.None;
            places.Clear();
            var members = new Utf8JsonCursor(text);
            while (members.TryNext(out ReadOnlySpan<byte> name, out ReadOnlySpan<byte> value))
            {
                int index = IndexOf(name);
                if (index < 0)
                    continue;
                if (places[2 * index + 1] > 0)
                    Problem = RemoteDrop.WrongField;
                text.Overlaps(value, out int start);
                places[2 * index] = start;
                places[2 * index + 1] = value.Length;
            }
        }

        /// <summary>What was wrong with the values asked for so far.</summary>
        public RemoteDrop Problem { get; private set; }

        /// <summary>Empty when it is missing or null.</summary>
        public ReadOnlySpan<byte> Value(string name)
        {
            int index = Array.IndexOf(Names, name);
            ReadOnlySpan<byte> value = _text.Slice(_places[2 * index], _places[2 * index + 1]);
            return Utf8JsonCursor.Is(value, "null") ? default : value;
        }

        public bool Has(string name) => Value(name).Length > 0;

        /// <summary>Without its quotes; empty when it is missing.</summary>
        public ReadOnlySpan<byte> Text(string name)
        {
            ReadOnlySpan<byte> value = Value(name);
            if (value.Length == 0)
                return default;
            if (value[0] != '"')
            {
                Refuse(RemoteDrop.WrongField);
                return default;
            }

            return value.Slice(1, value.Length - 2);
        }

        public long Integer(string name, long least, long most)
        {
            ReadOnlySpan<byte> value = Value(name);
            if (value.Length == 0 || !Utf8JsonCursor.TryNumber(value, out _))
                Refuse(RemoteDrop.WrongField);
            else if (Utf8JsonCursor.TryInteger(value, out long number) && number >= least && number <= most)
                return number;
            else
                Refuse(RemoteDrop.OutOfRange);
            return least;
        }

        public long Integer(string name, long least, long most, long missing) => Has(name) ? Integer(name, least, most) : missing;

        public double Number(string name, double least, double most)
        {
            ReadOnlySpan<byte> value = Value(name);
            if (value.Length == 0 || !Utf8JsonCursor.TryNumber(value, out double number))
                Refuse(RemoteDrop.WrongField);
            else if (number >= least && number <= most)
                return number;
            else
                Refuse(RemoteDrop.OutOfRange);
            return least;
        }

        public double Number(string name, double least, double most, double missing) => Has(name) ? Number(name, least, most) : missing;

        /// <summary>Components within ±most; NaN when it is missing or wrong.</summary>
        public Vector2D Vector2(string name, double most)
        {
            Span<double> n = stackalloc double[2];
            return Check(Numbers(Value(name), most, n)) ? new Vector2D(n[0], n[1]) : new Vector2D(double.NaN, double.NaN);
        }

        /// <summary>Components within ±most; NaN when it is missing or wrong.</summary>
        public Vector3D Vector3(string name, double most)
        {
            Span<double> n = stackalloc double[3];
            return Check(Numbers(Value(name), most, n)) ? new Vector3D(n[0], n[1], n[2]) : new Vector3D(double.NaN, double.NaN, double.NaN);
        }

        /// <summary>Remembers the first thing that is wrong.</summary>
        public void Refuse(RemoteDrop problem)
        {
            if (Problem == RemoteDrop.None)
                Problem = problem;
        }

        /// <summary>Null: there is no value.</summary>
        private static RemoteDrop? Numbers(ReadOnlySpan<byte> value, double most, Span<double> numbers)
        {
            if (value.Length == 0)
                return null;
            if (!Utf8JsonCursor.TryNumbers(value, numbers))
                return RemoteDrop.WrongField;
            foreach (double number in numbers)
            {
                if (!(Math.Abs(number) <= most))
                    return RemoteDrop.OutOfRange;
            }

            return RemoteDrop.None;
        }

        private bool Check(RemoteDrop? problem)
        {
            Refuse(problem ?? RemoteDrop.None);
            return problem == RemoteDrop.None;
        }

        private static int IndexOf(ReadOnlySpan<byte> name)
        {
            for (int i = 0; i < Names.Length; i++)
            {
                if (Utf8JsonCursor.Is(name, Names[i]))
                    return i;
            }

            return -1;
        }
    }
}
