// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
namespace OpenCvSharp
{
    public readonly struct MatType
    {
        public static readonly MatType CV_8UC1 = new MatType(0);
        public static readonly MatType CV_8UC2 = new MatType(8);
        public static readonly MatType CV_8UC3 = new MatType(16);
        public static readonly MatType CV_8UC4 = new MatType(24);

        public MatType(int value)
        {
            Value = value;
        }

        public int Value { get; }
    }
}
