// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
using System;

namespace OpenCvSharp
{
    public abstract class DisposableObject : IDisposable
    {
        private bool _isDisposed;

        public void Dispose()
        {
            if (!_isDisposed)
                Release();
            _isDisposed = true;
        }

        internal abstract void Release();
    }
}
