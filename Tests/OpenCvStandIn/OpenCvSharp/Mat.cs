// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
using System;
using System.Runtime.InteropServices;
using OpenCvStandIn;

namespace OpenCvSharp
{
    public unsafe class Mat : CvObject
    {
        private IntPtr _memory;
        private int _capacity;
        private MatType _type;
        private int _step;
        private bool _isBorrowed;

        public Mat()
        {
            if (FakeWebcam.LibraryProblem != null)
                throw FakeWebcam.LibraryProblem;
            FakeWebcam.MatsAlive++;
        }

        /// <summary>Memory of the caller's; not copied, not freed.</summary>
        public static Mat FromPixelData(int rows, int cols, MatType type, IntPtr data, long step = 0) =>
            new Mat { Rows = rows, Cols = cols, _type = type, _step = (int)step, _memory = data, _isBorrowed = true };

        public int Cols { get; private set; }

        public byte* DataPointer => (byte*)_memory;

        public int Rows { get; private set; }

        public long Step() => _step;

        public MatType Type() => _type;

        internal override void Release()
        {
            if (!_isBorrowed)
                Marshal.FreeHGlobal(_memory);
            FakeWebcam.MatsAlive--;
        }

        internal void Fill(int width, int height, MatType type, byte value)
        {
            Cols = width;
            Rows = height;
            _type = type;
            // Rows of OpenCV's pictures may be padded.
            _step = width * (type.Value / 8 + 1) + 4;
            int size = _step * height;
            if (size > _capacity)
            {
                Marshal.FreeHGlobal(_memory);
                _memory = Marshal.AllocHGlobal(size);
                _capacity = size;
            }

            new Span<byte>(DataPointer, size).Fill(value);
        }
    }
}
