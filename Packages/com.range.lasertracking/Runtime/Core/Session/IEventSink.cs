namespace LaserTracking.Session
{
    /// <summary>
    /// Receives a session's events on the pipeline's thread, in the order of processing. Implementations copy what they keep and
    /// allocate nothing per frame. Between <see cref="Begin"/> and <see cref="End"/>, each called once.
    /// </summary>
    public interface IEventSink
    {
        void Begin(SessionHeader header);

        void OnShot(in ShotEvent shot);

        void OnDot(in DotEvent dot);

        void OnHand(in HandEvent hand);

        void OnRejected(in RejectedEvent rejected);

        void OnHealth(in HealthEvent health);

        /// <summary>
        /// No event with a time before this one can follow (microseconds): what was held back to put events in order may be written.
        /// </summary>
        void OnTimePassed(long timeUs);

        void End(in SessionEnd end);
    }
}
