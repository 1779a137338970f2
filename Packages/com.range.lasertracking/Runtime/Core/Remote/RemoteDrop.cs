namespace LaserTracking.Remote
{
    /// <summary>Why a packet was not used. Documentation~/remote.md says what to do about each.</summary>
    public enum RemoteDrop
    {
        /// <summary>It was used.</summary>
        None = 0,

        /// <summary>Longer than allowed.</summary>
        Oversized = 1,

        /// <summary>Its address is not on the list of senders.</summary>
        NotAllowed = 2,

        /// <summary>No signature although there is a key.</summary>
        Unsigned = 3,

        /// <summary>The signature does not fit: another key, or somebody changed the packet.</summary>
        Forged = 4,

        /// <summary>Signed, but this receiver has no key to check it with.</summary>
        NoKey = 5,

        NotUtf8 = 6,

        /// <summary>No JSON object, or nested too deeply.</summary>
        NotJson = 7,

        /// <summary>A field is missing, twice there, or of the wrong kind; or an unknown version.</summary>
        WrongField = 8,

        /// <summary>A number is not finite or outside what a range can hold.</summary>
        OutOfRange = 9,

        /// <summary>A type of message that is not known here.</summary>
        UnknownType = 10,

        /// <summary>Too old, or from the future.</summary>
        Stale = 11,

        /// <summary>Its counter was used before.</summary>
        Replayed = 12,

        /// <summary>More packets a second than allowed.</summary>
        TooFast = 13,

        /// <summary>More senders at once than there is room for.</summary>
        TooManySenders = 14,

        /// <summary>A shot for which the queue had no room.</summary>
        QueueFull = 15,

        /// <summary>The network or the file failed.</summary>
        Failed = 16,
    }
}
