// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;

namespace UnityEngine
{
    public struct Color : IEquatable<Color>
    {
        public float r;
        public float g;
        public float b;
        public float a;

        public Color(float r, float g, float b, float a)
        {
            this.r = r;
            this.g = g;
            this.b = b;
            this.a = a;
        }

        public static Color white => new Color(1, 1, 1, 1);

        public static Color black => new Color(0, 0, 0, 1);

        public static Color red => new Color(1, 0, 0, 1);

        public static Color green => new Color(0, 1, 0, 1);

        public static Color magenta => new Color(1, 0, 1, 1);

        public static Color yellow => new Color(1, 0.92156863f, 0.015686275f, 1);

        public static Color cyan => new Color(0, 1, 1, 1);

        public bool Equals(Color other) => r == other.r && g == other.g && b == other.b && a == other.a;

        public override bool Equals(object other) => other is Color c && Equals(c);

        public override int GetHashCode() => new Vector4(r, g, b, a).GetHashCode();
    }
}
