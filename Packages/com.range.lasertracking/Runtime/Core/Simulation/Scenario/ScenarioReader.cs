using System;
using System.Collections.Generic;
using System.Globalization;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Simulation
{
    /// <summary>Takes settings out of JSON; every complaint names the line.</summary>
    internal sealed class ScenarioReader : ScenarioVisitor
    {
        private readonly string _source;
        private JObject _group;
        private HashSet<string> _known = new HashSet<string>(StringComparer.Ordinal);

        public ScenarioReader(string source, JObject root)
        {
            _source = source;
            _group = root;
        }

        /// <summary>Refuses the first field of the present group that no setting asked for.</summary>
        public void RefuseUnknownFields()
        {
            foreach (JProperty property in _group.Properties())
            {
                if (!_known.Contains(property.Name))
                    throw Complaint(property, property.Path, "is no known setting", "remove it or correct its name");
            }
        }

        public override double Number(string name, double value, double minimum, double maximum)
        {
            JToken? token = Find(name);
            return token == null ? value : ReadNumber(token, minimum, maximum);
        }

        public override bool Flag(string name, bool value)
        {
            JToken? token = Find(name);
            if (token == null)
                return value;
            if (token.Type != JTokenType.Boolean)
                throw Complaint(token, token.Path, "is " + Show(token), "give true or false");
            return (bool)token;
        }

        public override string Text(string name, string value)
        {
            JToken? token = Find(name);
            if (token == null)
                return value;
            if (token.Type != JTokenType.String)
                throw Complaint(token, token.Path, "is " + Show(token), "give a text in quotes");
            return (string)token!;
        }

        public override TEnum Choice<TEnum>(string name, TEnum value)
        {
            JToken? token = Find(name);
            if (token == null)
                return value;
            string[] names = Enum.GetNames(typeof(TEnum));
            foreach (string candidate in names)
            {
                if (token.Type == JTokenType.String && candidate.ToLowerInvariant() == (string)token!)
                    return (TEnum)Enum.Parse(typeof(TEnum), candidate);
            }

            string choices = string.Join(", ", names).ToLowerInvariant();
            throw Complaint(token, token.Path, "is " + Show(token), "give one of " + choices);
        }

        public override double[]? Numbers(string name, double[]? values, int count, double minimum, double maximum)
        {
            JToken? token = Find(name);
            if (token == null)
                return values;
            if (token.Type == JTokenType.Null)
                return null;
            if (!(token is JArray array) || array.Count != count)
                throw Complaint(token, token.Path, "is " + Show(token), "give a list of " + count + " numbers");
            var result = new double[count];
            for (int i = 0; i < count; i++)
                result[i] = ReadNumber(array[i], minimum, maximum);
            return result;
        }

        public override void Group(string name, Action<ScenarioVisitor> visit)
        {
            JToken? token = Find(name);
            if (token == null)
                return;
            if (!(token is JObject group))
                throw Complaint(token, token.Path, "is " + Show(token), "give an object { … }");
            Enter(group, () => visit(this));
        }

        public override void List<T>(string name, List<T> items, Func<T> create, Action<T, ScenarioVisitor> visit)
        {
            JToken? token = Find(name);
            if (token == null)
                return;
            if (!(token is JArray array))
                throw Complaint(token, token.Path, "is " + Show(token), "give a list [ … ]");
            items.Clear();
            foreach (JToken element in array)
            {
                if (!(element is JObject group))
                    throw Complaint(element, element.Path, "is " + Show(element), "give an object { … }");
                T item = create();
                items.Add(item);
                Enter(group, () => visit(item, this));
            }
        }

        public override void Refuse(string name, string what, string remedy)
        {
            JToken? token = _group.Property(name);
            string path = _group.Path.Length > 0 ? _group.Path + "." + name : name;
            throw Complaint(token ?? _group, path, what, remedy);
        }

        private static string Show(JToken token)
        {
            string text = token is JValue value ? Convert.ToString(value.Value, CultureInfo.InvariantCulture) ?? "null" : token.Type.ToString();
            if (token.Type == JTokenType.Null)
                text = "null";
            return token.Type == JTokenType.String ? "\"" + (text.Length > 40 ? text.Substring(0, 40) + "…" : text) + "\"" : text.ToLowerInvariant();
        }

        private JToken? Find(string name)
        {
            _known.Add(name);
            return _group.TryGetValue(name, StringComparison.Ordinal, out JToken? token) ? token : null;
        }

        private double ReadNumber(JToken token, double minimum, double maximum)
        {
            string range = FormattableString.Invariant($"give a number from {minimum} to {maximum}");
            if (token.Type != JTokenType.Integer && token.Type != JTokenType.Float)
                throw Complaint(token, token.Path, "is " + Show(token), range);
            object? value = ((JValue)token).Value;
            // Whole numbers beyond 64 bits come as a type that Convert does not know.
            double number = value is IConvertible ? Convert.ToDouble(value, CultureInfo.InvariantCulture) : double.PositiveInfinity;
            if (!(number >= minimum && number <= maximum))
                throw Complaint(token, token.Path, FormattableString.Invariant($"is {number}"), range);
            return number;
        }

        private void Enter(JObject group, Action visit)
        {
            JObject outerGroup = _group;
            HashSet<string> outerKnown = _known;
            _group = group;
            _known = new HashSet<string>(StringComparer.Ordinal);
            visit();
            RefuseUnknownFields();
            _group = outerGroup;
            _known = outerKnown;
        }

        private InputException Complaint(IJsonLineInfo place, string path, string what, string remedy) =>
            new InputException(_source, "line " + place.LineNumber.ToString(CultureInfo.InvariantCulture) + ": " + path + " " + what, remedy);
    }
}
