using System.Globalization;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using LaserTracking.Remote;

namespace LaserTracking.Host.Remote
{
    /// <summary>What the command line says about where to send: HOST:PORT and a key file.</summary>
    internal static class SendTarget
    {
        /// <param name="option">Names the text.</param>
        /// <param name="text">A host's name or address, with a port or without.</param>
        /// <param name="lowestPort">0 where any free port will do.</param>
        /// <exception cref="InputException">The text is no HOST:PORT, or the host is not known.</exception>
        public static IPEndPoint Parse(string option, string text, int lowestPort = 1)
        {
            int colon = text.LastIndexOf(':');
            string host = colon < 0 ? text : text[..colon].Trim('[', ']');
            int port = RemoteSettings.DefaultPort;
            bool hasPort = colon < 0 || (int.TryParse(text[(colon + 1)..], NumberStyles.None, CultureInfo.InvariantCulture, out port) && port >= lowestPort && port < 65536);
            if (host.Length == 0 || !hasPort)
                throw new InputException(option, $"\"{text}\" is no HOST:PORT", "write it like 127.0.0.1:9997");
            if (IPAddress.TryParse(host, out IPAddress? address))
                return new IPEndPoint(address, port);
            try
            {
                return new IPEndPoint(Dns.GetHostAddresses(host).First(known => known.AddressFamily == AddressFamily.InterNetwork), port);
            }
            catch (System.Exception problem) when (problem is SocketException or System.InvalidOperationException or System.ArgumentException)
            {
                throw new InputException(option, $"there is no host \"{host}\"", "give its address");
            }
        }

        /// <summary>Over the network or through a file.</summary>
        /// <param name="option">Names the target.</param>
        /// <param name="target">HOST:PORT.</param>
        /// <param name="keyFile">The receiver's key, or null.</param>
        /// <param name="file">A file in place of the network, or null.</param>
        /// <exception cref="InputException">There is no way there, or the file cannot be written.</exception>
        public static IRemoteSender Open(string option, string target, string? keyFile, string? file)
        {
            if (file == null)
                return Open(option, target, keyFile);
            if (keyFile != null)
                throw new InputException("--key-file", "what goes through a file is not signed", "leave it out");
            return new RemoteFileSender(file, new WallClock());
        }

        /// <exception cref="InputException">No way there, no key in the file, or a key missing on the way to another machine.</exception>
        private static RemoteSender Open(string option, string target, string? keyFile)
        {
            IPEndPoint receiver = Parse(option, target);
            if (keyFile == null && !IPAddress.IsLoopback(receiver.Address))
                throw new InputException(target, "another machine takes only signed packets", "add --key-file FILE");
            return new RemoteSender(receiver, keyFile == null ? null : RemoteKey.ReadFile(keyFile), new WallClock());
        }
    }
}
