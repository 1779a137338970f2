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

        public Mat()
        {
            if (FakeWebcam.LibraryProblem != null)
                throw FakeWebcam.LibraryProblem;
            FakeWebcam.MatsAlive++;
        }

        public int Cols { get; private set; }

        public byte* DataPointer => (byte*)_memory;

        public int Rows { get; private set; }

        public long Step() => _step;

        public MatType Type() => _type;

        internal override void Release()
        {
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
