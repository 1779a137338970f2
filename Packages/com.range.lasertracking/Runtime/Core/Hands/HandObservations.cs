using System;

namespace LaserTracking.Hands
{
    /// <summary>The hands of one frame of camera 1. Fixed room, used again for every frame.</summary>
    public sealed class HandObservations
    {
        private readonly HandObservation[] _hands;
        private readonly PersonObservation[] _people;
        private int _count;
        private int _peopleCount;

        public HandObservations(int capacity = 16)
        {
            _hands = new HandObservation[capacity];
            _people = new PersonObservation[capacity];
        }

        /// <summary>How far camera 1 saw in this frame; not present where the tracker keeps no depth.</summary>
        public SeenDepth Depth { get; } = new SeenDepth();

        public int FrameIndex { get; private set; }

        /// <summary>Mid-exposure of the depth picture, microseconds on camera 1's clock.</summary>
        public long TimeUs { get; private set; }

        public ReadOnlySpan<HandObservation> Hands => new ReadOnlySpan<HandObservation>(_hands, 0, _count);

        /// <summary>Everybody whose head is known, with or without a hand in this frame.</summary>
        public ReadOnlySpan<PersonObservation> People => new ReadOnlySpan<PersonObservation>(_people, 0, _peopleCount);

        public void Begin(int frameIndex, long timeUs)
        {
            FrameIndex = frameIndex;
            TimeUs = timeUs;
            _count = 0;
            _peopleCount = 0;
            Depth.Clear();
        }

        /// <summary>False when there is no room left.</summary>
        public bool Add(in HandObservation hand)
        {
            if (_count == _hands.Length)
                return false;
            _hands[_count++] = hand;
            return true;
        }

        /// <summary>False when there is no room left.</summary>
        public bool Add(in PersonObservation person)
        {
            if (_peopleCount == _people.Length)
                return false;
            _people[_peopleCount++] = person;
            return true;
        }
    }
}
