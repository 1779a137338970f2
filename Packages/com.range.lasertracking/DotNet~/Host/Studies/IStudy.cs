using System.Threading;

namespace LaserTracking.Host.Studies
{
    /// <summary>An experiment that anybody can repeat: the same options give the same table.</summary>
    internal interface IStudy
    {
        string Name { get; }

        /// <summary>One line for the help.</summary>
        string What { get; }

        /// <exception cref="InputException">Something outside the program that it needs is missing.</exception>
        StudyTable Run(StudyOptions options, CancellationToken interrupted);
    }
}
