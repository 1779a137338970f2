using System;
using System.Collections.Generic;

namespace LaserTracking.Simulation
{
    /// <summary>Checks settings that were made in code against the ranges of their description.</summary>
    internal sealed class ScenarioChecker : ScenarioVisitor
    {
        private string _path = "";

        public override double Number(string name, double value, double minimum, double maximum)
        {
            if (!(value >= minimum && value <= maximum))
                Refuse(name, FormattableString.Invariant($"is {value}"), FormattableString.Invariant($"give a number from {minimum} to {maximum}"));
            return value;
        }

        public override bool Flag(string name, bool value) => value;

        public override string Text(string name, string value) => value;

        public override TEnum Choice<TEnum>(string name, TEnum value)
        {
            if (!Enum.IsDefined(typeof(TEnum), value))
                Refuse(name, "is " + value, "give a defined value");
            return value;
        }

        public override double[]? Numbers(string name, double[]? values, int count, double minimum, double maximum)
        {
            if (values != null)
            {
                foreach (double value in values)
                    Number(name, value, minimum, maximum);
            }

            return values;
        }

        public override void Group(string name, Action<ScenarioVisitor> visit) => Enter(name, () => visit(this));

        public override void List<T>(string name, List<T> items, Func<T> create, Action<T, ScenarioVisitor> visit)
        {
            for (int i = 0; i < items.Count; i++)
            {
                T item = items[i];
                Enter(FormattableString.Invariant($"{name}[{i}]"), () => visit(item, this));
            }
        }

        public override void Refuse(string name, string what, string remedy) =>
            throw new ArgumentException(_path + name + " " + what + "; " + remedy);

        private void Enter(string name, Action visit)
        {
            string outer = _path;
            _path += name + ".";
            visit();
            _path = outer;
        }
    }
}
