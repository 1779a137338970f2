// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
using System;

namespace OpenCvSharp
{
    public class OpenCVException : Exception
    {
        public OpenCVException(string message)
            : base(message)
        {
        }
    }
}
