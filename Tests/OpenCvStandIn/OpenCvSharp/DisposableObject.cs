// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
using System;

namespace OpenCvSharp
{
    public abstract class DisposableObject : IDisposable
    {
        public void Dispose()
        {
            if (!IsDisposed)
                DisposeUnmanaged();
            IsDisposed = true;
        }

        public bool IsDisposed { get; protected set; }

        protected virtual void DisposeUnmanaged()
        {
        }
    }
}
