using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Range.LaserTracking.Burst")]
[assembly: InternalsVisibleTo("Range.LaserTracking.Core.Tests")]
[assembly: InternalsVisibleTo("Range.LaserTracking.Core.Tests.NetStandard")]
[assembly: InternalsVisibleTo("BurstTests")]
