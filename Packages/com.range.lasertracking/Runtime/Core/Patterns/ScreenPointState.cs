namespace LaserTracking.Patterns
{
    /// <summary>Why a projected point was measured or not.</summary>
    public enum ScreenPointState : byte
    {
        Measured = 0,

        /// <summary>It lies beside the camera's picture.</summary>
        OutOfPicture = 1,

        /// <summary>The projector's light does not arrive there, or on something dark: somebody or something is in the way.</summary>
        Covered = 2,

        /// <summary>The light is there, its corner is not clear enough: blur, noise, something half in the way.</summary>
        Unclear = 3,
    }
}
