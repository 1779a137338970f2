using System.Collections.Generic;
using LaserTracking.Host.Studies.Clips;

namespace LaserTracking.Host.Studies
{
    /// <summary>All studies by the names of the command line.</summary>
    internal static class StudyList
    {
        public static IReadOnlyList<IStudy> All { get; } = new IStudy[]
        {
            new ClipStressStudy(),
            new Moving.MovingStudy(),
            new PastedDotsStudy(),
        };
    }
}
