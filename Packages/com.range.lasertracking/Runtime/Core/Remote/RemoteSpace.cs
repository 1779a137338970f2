namespace LaserTracking.Remote
{
    /// <summary>In what frame of reference a pose is given.</summary>
    public enum RemoteSpace
    {
        /// <summary>Screen space: metres from the picture's top-left corner, x right, y down, z into the picture.</summary>
        ScreenM = 0,

        /// <summary>Camera 0's space: millimetres, x right, y down, z forward. The published message's.</summary>
        CameraMm = 1,
    }
}
