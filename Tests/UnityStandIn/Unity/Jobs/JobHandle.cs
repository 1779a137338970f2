// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace Unity.Jobs
{
    public struct JobHandle
    {
        private readonly int _number;

        internal JobHandle(int number) => _number = number;

        public void Complete() => JobWorkers.Complete(_number);
    }
}
