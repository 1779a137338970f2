// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
namespace OpenCvSharp
{
    public struct Point2f
    {
        public float X;
        public float Y;

        public Point2f(float X, float Y)
        {
            this.X = X;
            this.Y = Y;
        }
    }
}
