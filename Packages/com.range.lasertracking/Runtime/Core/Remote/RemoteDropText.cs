namespace LaserTracking.Remote
{
    /// <summary>For people: what each kind of dropped packet means and what to do.</summary>
    internal static class RemoteDropText
    {
        private static readonly string[] Texts =
        {
            "packets are used",
            "a packet is longer than allowed: send one message a packet, without extra fields",
            "a packet came from an address that is not on the list of senders: add it if it is yours",
            "a packet is not signed: give the sender this receiver's key",
            "a packet's signature does not fit: sender and receiver need the same key; if they have it, somebody forges packets",
            "a packet is signed but there is no key here: give this receiver the sender's key",
            "a packet is not UTF-8: the sender, or something else that uses this port, does not speak this protocol",
            "a packet is not a JSON object: the sender, or something else that uses this port, does not speak this protocol",
            "a packet lacks a field, has one twice or of the wrong kind: compare the sender with the protocol's description",
            "a packet holds a number outside its range, or one that is not finite: check the sender's units and calibration",
            "a packet's type of message is not known here: an older or newer sender",
            "a packet is too old or from the future: set both machines' clocks by the same time server",
            "a packet came a second time: the network doubles packets, or somebody replays recorded ones",
            "a sender sends more packets a second than allowed: slow it down",
            "more senders at once than there is room for: stop those that are not needed",
            "more shots waited than there is room for and some were lost: the program does not fetch them",
            "the remote input's network or file failed: check cable, firewall and rights",
        };

        public static int Count => Texts.Length;

        public static string Of(RemoteDrop drop) => "remote input: " + Texts[(int)drop];
    }
}
