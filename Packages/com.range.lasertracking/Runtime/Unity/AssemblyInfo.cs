using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Range.LaserTracking.Tests")]
[assembly: InternalsVisibleTo("UnityTests")]
