using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("RangeTests")]
