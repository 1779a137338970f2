using System;
using System.Collections.Generic;
using System.Linq;

namespace LaserTracking.Editor
{
    /// <summary>A managed library that only part of the package needs, and the symbol that wakes that part.</summary>
    public sealed class OptionalLibrary
    {
        /// <summary>All of them.</summary>
        public static readonly IReadOnlyList<OptionalLibrary> All = new[]
        {
            new OptionalLibrary("RANGE_KINECT", "Microsoft.Azure.Kinect.Sensor.dll", "Range.LaserTracking.Kinect"),
            new OptionalLibrary("RANGE_OPENCV", "OpenCvSharp.dll", "Range.LaserTracking.OpenCv"),
            new OptionalLibrary("RANGE_MATHNET", "MathNet.Numerics.dll", "Range.LaserTracking.Calibration"),
        };

        private OptionalLibrary(string symbol, string file, string assembly)
        {
            Symbol = symbol;
            File = file;
            Assembly = assembly;
        }

        /// <summary>The scripting define symbol.</summary>
        public string Symbol { get; }

        /// <summary>The library's own file.</summary>
        public string File { get; }

        /// <summary>The part of this package that needs it.</summary>
        public string Assembly { get; }

        /// <summary>What stops a project's scripts from compiling, in plain words: a symbol that is set without its library. One line each.</summary>
        /// <param name="symbols">Scripting define symbols of the project.</param>
        /// <param name="files">Names of the libraries in the project.</param>
        public static IEnumerable<string> Problems(IReadOnlyCollection<string> symbols, IReadOnlyCollection<string> files) => All
            .Where(library => symbols.Contains(library.Symbol) && !files.Contains(library.File, StringComparer.OrdinalIgnoreCase))
            .Select(library => library.Symbol + " is set, but " + library.File + " is not in the project, so no script of it compiles: put the library into Assets/Plugins "
                + "(Documentation~/cameras.md, calibration.md), or take the symbol away under Project Settings > Player > Scripting Define Symbols");
    }
}
