using System.Net;
using System.Text;

namespace LaserTracking.Remote
{
    /// <summary>Packets and addresses for tests.</summary>
    internal static class RemoteExamples
    {
        public const string KeyText = "000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f";
        public const string Published = "{\"timestamp\":1717.25,\"muzzle\":[100,-50,1500],\"target\":[400,350,1500],\"confidence\":0.8}";

        public static readonly IPEndPoint Sender = new IPEndPoint(IPAddress.Loopback, 40000);

        public static RemoteKey Key => RemoteKey.Parse(KeyText, "key");

        public static byte[] Bytes(string text) => Encoding.UTF8.GetBytes(text);

        /// <summary>The least that makes a shot.</summary>
        public static string Shot(int id, long counter, long sentUs, long stream = 77, string more = "") =>
            "{\"v\":1,\"stream\":" + stream + ",\"counter\":" + counter + ",\"sent_us\":" + sentUs + ",\"type\":\"shot\",\"id\":" + id +
            ",\"time_us\":1000,\"confidence\":0.9,\"screen_m\":[1.5,0.5]" + more + "}";

        public static string Hand(long counter, long sentUs, long stream = 77, int track = 1, string muzzle = "[1.1,1.2,-2.3]") =>
            "{\"v\":1,\"stream\":" + stream + ",\"counter\":" + counter + ",\"sent_us\":" + sentUs + ",\"type\":\"hand\",\"time_us\":1000,\"track\":" + track +
            ",\"palm_m\":[1,1.25,-2.5],\"muzzle_m\":" + muzzle + "}";

        public static byte[] Sign(string text, RemoteKey key)
        {
            byte[] message = Bytes(text);
            var packet = new byte[message.Length + PacketSignature.Length];
            message.CopyTo(packet, 0);
            using (var signature = new PacketSignature(key))
                signature.Write(message, new System.Span<byte>(packet, message.Length, PacketSignature.Length));
            return packet;
        }
    }
}
