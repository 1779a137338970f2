// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;

namespace UnityEngine
{
    [AttributeUsage(AttributeTargets.Property | AttributeTargets.Field, AllowMultiple = false, Inherited = true)]
    public abstract class PropertyAttribute : Attribute
    {
        protected PropertyAttribute()
        {
        }

        public int order { get; set; }
    }
}
