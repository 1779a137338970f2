using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// Walks over a scenario's settings. Each setting is described once (name, value, range); reading, writing and checking are
    /// three visitors over that one description, so that they cannot disagree. A method returns the value that shall stand.
    /// </summary>
    internal abstract class ScenarioVisitor
    {
        public abstract double Number(string name, double value, double minimum, double maximum);

        public abstract bool Flag(string name, bool value);

        public abstract string Text(string name, string value);

        public abstract TEnum Choice<TEnum>(string name, TEnum value) where TEnum : struct, Enum;

        public abstract double[]? Numbers(string name, double[]? values, int count, double minimum, double maximum);

        public abstract void Group(string name, Action<ScenarioVisitor> visit);

        public abstract void List<T>(string name, List<T> items, Func<T> create, Action<T, ScenarioVisitor> visit);

        /// <summary>Ends the walk: the named setting of the present group cannot stand.</summary>
        public abstract void Refuse(string name, string what, string remedy);

        public int Integer(string name, int value, int minimum, int maximum)
        {
            double number = Number(name, value, minimum, maximum);
            if (Math.Floor(number) != number)
                Refuse(name, "is not a whole number", "give a whole number");
            return (int)number;
        }

        public Vector2D? Point(string name, Vector2D? value, double limit)
        {
            double[]? numbers = Numbers(name, value is Vector2D p ? new[] { p.X, p.Y } : null, 2, -limit, limit);
            return numbers == null ? (Vector2D?)null : new Vector2D(numbers[0], numbers[1]);
        }

        public Vector3D? Point(string name, Vector3D? value, double limit)
        {
            double[]? numbers = Numbers(name, value is Vector3D p ? new[] { p.X, p.Y, p.Z } : null, 3, -limit, limit);
            return numbers == null ? (Vector3D?)null : new Vector3D(numbers[0], numbers[1], numbers[2]);
        }
    }
}
