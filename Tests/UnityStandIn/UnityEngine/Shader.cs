// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Collections.Generic;

namespace UnityEngine
{
    public sealed class Shader : Object
    {
        private static readonly List<string> Names = new List<string>();

        private Shader()
        {
        }

        public static int PropertyToID(string name)
        {
            if (!Names.Contains(name))
                Names.Add(name);
            return Names.IndexOf(name);
        }
    }
}
