using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using LaserTracking.Burst;
using LaserTracking.Kernels;
using NUnit.Framework;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>A range in Unity has its heavy kernels run by Burst and by nothing else.</summary>
    public sealed class RangeKernelsTests : StandInTests
    {
        [Test]
        public void LaserRange_Running_HasBurstRunItsKernels()
        {
            var rig = new RangeRig(new StubSource(200, 0));
            rig.Range.gameObject.SetActive(true);
            for (int i = 0; i < 5; i++)
                PlayerLoop.Step(1 / 60.0);
            KernelRunner[] runners = Reachable(rig.Range).OfType<KernelRunner>().ToArray();
            Assert.That(runners, Has.Length.EqualTo(1));
            Assert.That(runners[0], Is.TypeOf<BurstKernelRunner>());
        }

        /// <summary>This package's objects that one holds, directly or through others.</summary>
        private static IEnumerable<object> Reachable(object root)
        {
            var seen = new HashSet<object>(ReferenceEqualityComparer.Instance);
            var open = new Stack<object>(new[] { root });
            while (open.Count > 0)
            {
                object next = open.Pop();
                if (!seen.Add(next))
                    continue;
                yield return next;
                IEnumerable<object?> held = next is IEnumerable list && !IsOwn(next.GetType()) ? list.Cast<object?>() : Fields(next.GetType()).Select(field => field.GetValue(next));
                foreach (object value in held.OfType<object>().Where(value => IsOwn(value.GetType()) || value is object[]))
                    open.Push(value);
            }
        }

        private static bool IsOwn(Type type) => type.Namespace?.StartsWith("LaserTracking", StringComparison.Ordinal) == true && !type.IsValueType;

        private static IEnumerable<FieldInfo> Fields(Type? type)
        {
            for (; type != null && IsOwn(type); type = type.BaseType)
            {
                foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly).Where(field => !field.FieldType.IsPointer))
                    yield return field;
            }
        }
    }
}
