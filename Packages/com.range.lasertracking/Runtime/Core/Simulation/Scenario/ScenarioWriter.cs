using System;
using System.Collections.Generic;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Simulation
{
    /// <summary>Puts settings into JSON, all of them, in the order of their description.</summary>
    internal sealed class ScenarioWriter : ScenarioVisitor
    {
        private JObject _group;

        public ScenarioWriter(JObject root) => _group = root;

        public override double Number(string name, double value, double minimum, double maximum)
        {
            _group[name] = Token(value);
            return value;
        }

        public override bool Flag(string name, bool value)
        {
            _group[name] = value;
            return value;
        }

        public override string Text(string name, string value)
        {
            _group[name] = value;
            return value;
        }

        public override TEnum Choice<TEnum>(string name, TEnum value)
        {
            _group[name] = value.ToString().ToLowerInvariant();
            return value;
        }

        public override double[]? Numbers(string name, double[]? values, int count, double minimum, double maximum)
        {
            if (values == null)
                return null;
            var array = new JArray();
            foreach (double value in values)
                array.Add(Token(value));
            _group[name] = array;
            return values;
        }

        public override void Group(string name, Action<ScenarioVisitor> visit)
        {
            var group = new JObject();
            _group[name] = group;
            Enter(group, () => visit(this));
        }

        public override void List<T>(string name, List<T> items, Func<T> create, Action<T, ScenarioVisitor> visit)
        {
            var array = new JArray();
            _group[name] = array;
            foreach (T item in items)
            {
                var group = new JObject();
                array.Add(group);
                Enter(group, () => visit(item, this));
            }
        }

        public override void Refuse(string name, string what, string remedy) =>
            throw new ArgumentException(name + " " + what + "; " + remedy);

        private static JValue Token(double value) =>
            Math.Floor(value) == value && Math.Abs(value) < 1e15 ? new JValue((long)value) : new JValue(value);

        private void Enter(JObject group, Action visit)
        {
            JObject outer = _group;
            _group = group;
            visit();
            _group = outer;
        }
    }
}
