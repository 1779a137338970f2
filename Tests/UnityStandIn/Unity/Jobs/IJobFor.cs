// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace Unity.Jobs
{
    public interface IJobFor
    {
        void Execute(int index);
    }
}
