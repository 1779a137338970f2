using System;

namespace LaserTracking.Session
{
    /// <summary>The types of lines between header and end of events.jsonl. Their order decides between lines of the same time.</summary>
    [Flags]
    public enum EventTypes
    {
        None = 0,
        Shots = 1,
        Dots = 2,
        Hands = 4,
        Rejected = 8,
        Health = 16,

        /// <summary>What events.jsonl holds unless told otherwise: everything but the dots of every frame.</summary>
        Default = Shots | Hands | Rejected | Health,

        All = Default | Dots,
    }
}
