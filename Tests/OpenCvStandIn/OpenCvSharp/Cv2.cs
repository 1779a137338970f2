// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
using OpenCvStandIn;

namespace OpenCvSharp
{
    public static class Cv2
    {
        public static bool FindChessboardCornersSB(InputArray image, Size patternSize, out Point2f[] corners, ChessboardFlags flags = ChessboardFlags.None)
        {
            if (FakeBoard.Problem != null)
                throw FakeBoard.Problem;
            FakeBoard.Seen = FakeBoard.Copy(image.Mat);
            corners = FakeBoard.Corners;
            return corners.Length == patternSize.Width * patternSize.Height;
        }
    }
}
