// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
namespace OpenCvSharp
{
    public class InputArray : CvObject
    {
        private InputArray(Mat mat)
        {
            Mat = mat;
        }

        internal Mat Mat { get; }

        public static implicit operator InputArray(Mat mat) => new InputArray(mat);

        internal override void Release()
        {
        }
    }
}
