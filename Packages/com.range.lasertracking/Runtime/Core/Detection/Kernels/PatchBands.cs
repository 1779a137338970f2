using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>Patches spread over the raw picture, read and summed up; a band is a patch.</summary>
    internal unsafe struct PatchBands : IKernelBands
    {
        public const int Across = 6, Down = 4, Count = Across * Down, Area = PatchKernel.Window * PatchKernel.Window;

        public PictureView Source;

        /// <summary>Of the working picture.</summary>
        public int Width;
        public int Height;

        /// <summary>Source pixels per working pixel, 1 or 2.</summary>
        public int Factor;

        /// <summary><see cref="Area"/> for each patch.</summary>
        public byte* Patches;

        /// <summary><see cref="PatchKernel.Window"/> for each patch.</summary>
        public int* Columns;
        public int* Rows;

        public void Execute(int patch)
        {
            int left = (Width - PatchKernel.Window) * (2 * (patch % Across) + 1) / (2 * Across), top = (Height - PatchKernel.Window) * (2 * (patch / Across) + 1) / (2 * Down);
            PatchKernel.Read(Source, left, top, Factor, Patches + patch * Area);
            PatchKernel.SumUp(Patches + patch * Area, Columns + patch * PatchKernel.Window, Rows + patch * PatchKernel.Window);
        }
    }
}
