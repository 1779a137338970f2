// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityStandIn
{
    /// <summary>In which order the workers take the batches of a job: Unity promises none.</summary>
    public enum JobOrder
    {
        Forward,
        Backward,
        Scrambled,

        /// <summary>Several threads at the same time.</summary>
        Parallel,
    }
}
