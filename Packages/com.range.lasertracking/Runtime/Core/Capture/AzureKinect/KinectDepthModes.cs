namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Names and picture sizes of the depth modes, as recordings hold them.</summary>
    public static class KinectDepthModes
    {
        /// <summary>The mode that a tag names, early spellings included; <see cref="KinectDepthMode.Off"/> for any other text.</summary>
        public static KinectDepthMode Parse(string? name)
        {
            switch (name)
            {
                case "NFOV_2X2BINNED":
                case "NFOV_2x2BINNED":
                    return KinectDepthMode.Nfov2x2Binned;
                case "NFOV_UNBINNED":
                    return KinectDepthMode.NfovUnbinned;
                case "WFOV_2X2BINNED":
                case "WFOV_2x2BINNED":
                    return KinectDepthMode.Wfov2x2Binned;
                case "WFOV_UNBINNED":
                    return KinectDepthMode.WfovUnbinned;
                case "PASSIVE_IR":
                    return KinectDepthMode.PassiveIr;
                default:
                    return KinectDepthMode.Off;
            }
        }

        public static string NameOf(KinectDepthMode mode)
        {
            switch (mode)
            {
                case KinectDepthMode.Nfov2x2Binned: return "NFOV_2X2BINNED";
                case KinectDepthMode.NfovUnbinned: return "NFOV_UNBINNED";
                case KinectDepthMode.Wfov2x2Binned: return "WFOV_2X2BINNED";
                case KinectDepthMode.WfovUnbinned: return "WFOV_UNBINNED";
                case KinectDepthMode.PassiveIr: return "PASSIVE_IR";
                default: return "OFF";
            }
        }

        /// <summary>Width and height in pixels; zeros for <see cref="KinectDepthMode.Off"/>.</summary>
        public static (int Width, int Height) SizeOf(KinectDepthMode mode)
        {
            switch (mode)
            {
                case KinectDepthMode.Nfov2x2Binned: return (320, 288);
                case KinectDepthMode.NfovUnbinned: return (640, 576);
                case KinectDepthMode.Wfov2x2Binned: return (512, 512);
                case KinectDepthMode.WfovUnbinned:
                case KinectDepthMode.PassiveIr: return (1024, 1024);
                default: return (0, 0);
            }
        }

        /// <summary>The mode that gives pictures of a size; <see cref="KinectDepthMode.Off"/> when none does.</summary>
        public static KinectDepthMode FromSize(int width, int height, bool hasDepth)
        {
            for (var mode = KinectDepthMode.Nfov2x2Binned; mode <= KinectDepthMode.PassiveIr; mode++)
            {
                if (SizeOf(mode) == (width, height) && (mode != KinectDepthMode.WfovUnbinned || hasDepth))
                    return mode;
            }

            return KinectDepthMode.Off;
        }
    }
}
