using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Range.LaserTracking.Tests")]
[assembly: InternalsVisibleTo("UnityTests")]
[assembly: InternalsVisibleTo("Range.LaserTracking.Editor")]
