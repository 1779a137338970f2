// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
using System;

namespace OpenCvSharp
{
    [Flags]
    public enum ChessboardFlags
    {
        None = 0,
        NormalizeImage = 2,
        Accuracy = 32,
    }
}
