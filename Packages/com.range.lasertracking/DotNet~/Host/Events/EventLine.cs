using System;
using System.Text.Json;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Events
{
    /// <summary>One line of a JSON-lines file with its place, so that a wrong field is named with file, line and field.</summary>
    internal sealed class EventLine
    {
        private readonly string _path;

        public EventLine(string path, int number, JsonElement root)
        {
            _path = path;
            Number = number;
            Root = root;
        }

        /// <summary>1-based.</summary>
        public int Number { get; }

        public JsonElement Root { get; }

        public string Type => TryGet(Root, "type", out JsonElement type) && type.ValueKind == JsonValueKind.String ? type.GetString()! : throw Wrong("type", "is missing or no text");

        public string Text(string name) => OptionalText(name) ?? throw Wrong(name, "is missing");

        public string? OptionalText(string name) => OptionalText(Root, name);

        public string? OptionalText(JsonElement parent, string name)
        {
            if (!TryGet(parent, name, out JsonElement value))
                return null;
            return value.ValueKind == JsonValueKind.String ? value.GetString() : throw Wrong(name, "is no text");
        }

        public int Integer(string name) => Integer(Root, name);

        public int Integer(JsonElement parent, string name) =>
            TryGet(parent, name, out JsonElement value) && value.ValueKind == JsonValueKind.Number && value.TryGetInt32(out int number)
                ? number : throw Wrong(name, "is missing or no whole number");

        public long Long(string name) => OptionalLong(name) ?? throw Wrong(name, "is missing");

        public long? OptionalLong(string name)
        {
            if (!TryGet(Root, name, out JsonElement value))
                return null;
            return value.ValueKind == JsonValueKind.Number && value.TryGetInt64(out long number) ? number : throw Wrong(name, "is no whole number");
        }

        public double Double(string name) => Double(Root, name);

        /// <summary>NaN for null: what the writer makes of numbers that JSON cannot say.</summary>
        public double Double(JsonElement parent, string name)
        {
            if (parent.TryGetProperty(name, out JsonElement value))
            {
                if (value.ValueKind == JsonValueKind.Null)
                    return double.NaN;
                if (value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) && double.IsFinite(number))
                    return number;
            }

            throw Wrong(name, "is missing or no number");
        }

        public double? OptionalDouble(string name)
        {
            if (!TryGet(Root, name, out JsonElement value))
                return null;
            return value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) && double.IsFinite(number) ? number : throw Wrong(name, "is no number");
        }

        /// <summary>False for null or a missing field.</summary>
        public bool TryNumbers(JsonElement parent, string name, Span<double> numbers)
        {
            if (!TryGet(parent, name, out JsonElement value))
                return false;
            if (value.ValueKind != JsonValueKind.Array || value.GetArrayLength() != numbers.Length)
                throw Wrong(name, "is no list of " + numbers.Length + " numbers");
            for (int i = 0; i < numbers.Length; i++)
            {
                if (value[i].ValueKind != JsonValueKind.Number || !value[i].TryGetDouble(out numbers[i]) || !double.IsFinite(numbers[i]))
                    throw Wrong(name, "is no list of " + numbers.Length + " numbers");
            }

            return true;
        }

        public Vector2D Vector2(JsonElement parent, string name)
        {
            Span<double> n = stackalloc double[2];
            return TryNumbers(parent, name, n) ? new Vector2D(n[0], n[1]) : new Vector2D(double.NaN, double.NaN);
        }

        public Vector3D Vector3(JsonElement parent, string name)
        {
            Span<double> n = stackalloc double[3];
            return TryNumbers(parent, name, n) ? new Vector3D(n[0], n[1], n[2]) : new Vector3D(double.NaN, double.NaN, double.NaN);
        }

        /// <summary>False for null or a missing field; an error for anything but an object.</summary>
        public bool TryObject(string name, out JsonElement value)
        {
            if (!TryGet(Root, name, out value))
                return false;
            return value.ValueKind == JsonValueKind.Object ? true : throw Wrong(name, "is no object");
        }

        public InputException Wrong(string field, string what) =>
            new InputException(_path, "line " + Number + ": field \"" + field + "\" " + what, "write the file anew with ./range replay --events");

        private static bool TryGet(JsonElement parent, string name, out JsonElement value) =>
            parent.TryGetProperty(name, out value) && value.ValueKind != JsonValueKind.Null;
    }
}
