using LaserTracking.Session;

namespace LaserTracking.Remote
{
    /// <summary>Lets a pipeline send what it finds: every shot, and the newest of each frame's hands. The sender stays the caller's.</summary>
    public sealed class RemoteEventSink : IEventSink
    {
        private readonly IRemoteSender _sender;

        public RemoteEventSink(IRemoteSender sender)
        {
            _sender = sender;
        }

        public void OnShot(in ShotEvent shot) => _sender.SendShot(shot);

        public void OnHand(in HandEvent hand) => _sender.SendHand(hand);

        public void Begin(SessionHeader header)
        {
        }

        public void OnDot(in DotEvent dot)
        {
        }

        public void OnRejected(in RejectedEvent rejected)
        {
        }

        public void OnHealth(in HealthEvent health)
        {
        }

        public void OnTimePassed(long timeUs)
        {
        }

        public void End(in SessionEnd end)
        {
        }
    }
}
