using System;
using System.CommandLine;
using System.Diagnostics;
using System.Linq;
using System.Net;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Host.Remote;
using LaserTracking.Host.Sessions;
using LaserTracking.Remote;
using LaserTracking.Session;

namespace LaserTracking.Host.Commands
{
    /// <summary>range receive: what a remote input gets, as events.jsonl.</summary>
    internal static class ReceiveCommand
    {
        private const int LookMs = 5;

        public static Command Create()
        {
            var listen = new Option<string>("--listen") { HelpName = "ADDRESS:PORT", Description = "Where to listen, port 0: any free one; anything but this machine's own address needs --key-file and --allow.", DefaultValueFactory = _ => "127.0.0.1:9997" };
            var fromFile = new Option<string?>("--from-file") { HelpName = "FILE", Description = "Watches a file that a detector on this machine replaces, in place of the network; it may appear later." };
            var key = new Option<string?>("--key-file") { HelpName = "FILE", Description = "The senders' key, 32 to 128 hexadecimal digits." };
            var allow = new Option<string[]>("--allow") { HelpName = "ADDRESS", Description = "A sender's address that is believed; may be given again.", DefaultValueFactory = _ => [] };
            var events = new Option<string>("--events") { HelpName = "FILE", Description = "Writes events.jsonl there; - is standard output.", DefaultValueFactory = _ => "-" };
            var shots = new Option<int>("--shots") { HelpName = "N", Description = "Ends after so many shots. Left out: at Ctrl-C." };
            var seconds = new Option<double>("--seconds") { HelpName = "S", Description = "Ends after so many seconds; exit code 1 when fewer shots came than --shots asks for." };
            var command = new Command("receive", "Shows what a remote input gets: shots and hands from another program, over the network or through a file.") { listen, fromFile, key, allow, events, shots, seconds };
            command.SetAction((parsed, interrupted) =>
            {
                int asked = parsed.GetValue(shots);
                double limitS = parsed.GetValue(seconds);
                if (asked < 0)
                    throw new InputException("--shots", "must be 1 or more", "leave it out to go on until Ctrl-C");
                if (!(limitS >= 0 && limitS <= 1e6))
                    throw new InputException("--seconds", "must lie in 0…1000000", "leave it out to go on until Ctrl-C");
                string? file = parsed.GetValue(fromFile);
                if (file != null && (!parsed.GetResult(listen)!.Implicit || parsed.GetValue(key) != null || parsed.GetValue(allow)!.Length > 0))
                    throw new InputException("--from-file", "--listen, --key-file and --allow belong to the network", "leave them out");
                if (file != null)
                    ResultFile.CheckNotRead(parsed.GetValue(events), file);
                using var result = new ResultFile(parsed.GetValue(events)!);
                if (file != null)
                {
                    using var watcher = new RemoteFileReceiver(file, new RemoteSettings(), new WallClock());
                    return Task.FromResult(Receive(watcher.Inbox, file, result, asked, limitS, interrupted));
                }

                IPEndPoint at = SendTarget.Parse("--listen", parsed.GetValue(listen)!, 0);
                var settings = new RemoteSettings
                {
                    Address = at.Address,
                    Port = at.Port,
                    Key = parsed.GetValue(key) is { } keyName ? RemoteKey.ReadFile(keyName) : null,
                    AllowedSenders = parsed.GetValue(allow)!.Select(text => IPAddress.TryParse(text, out IPAddress? address) ? address : throw new InputException("--allow", $"\"{text}\" is no address", "write it like 192.168.7.20")).ToArray(),
                };
                using var receiver = new RemoteReceiver(settings, new WallClock());
                return Task.FromResult(Receive(receiver.Inbox, receiver.EndPoint.ToString(), result, asked, limitS, interrupted));
            });
            return command;
        }

        private static int Receive(RemoteInbox inbox, string from, ResultFile result, int asked, double limitS, CancellationToken interrupted)
        {
            Console.Error.WriteLine($"range: waiting for shots from {from}");
            var sink = new JsonLinesSink(result.Stream);
            var received = new ReceivedEvents(inbox, sink);
            sink.Begin(new SessionHeader(RangeSession.Version, [new SessionInput(from, null)], null, "remote", null));
            var watch = Stopwatch.StartNew();
            bool isOver = false;
            while (!isOver && !interrupted.IsCancellationRequested)
            {
                isOver = (asked > 0 && received.Shots >= asked) || (limitS > 0 && watch.Elapsed.TotalSeconds >= limitS);
                received.Drain();
                interrupted.WaitHandle.WaitOne(isOver ? 0 : LookMs);
            }

            double seconds = watch.Elapsed.TotalSeconds;
            sink.End(new SessionEnd { SecondsMedia = seconds, SecondsWall = seconds });
            result.Commit();
            Console.Error.WriteLine(FormattableString.Invariant($"range: {from}: {received.Shots} shots, {received.Hands} hands, {received.Rays} published rays"));
            return !isOver ? ExitCodes.Interrupted : received.Shots < asked ? ExitCodes.CheckFailed : ExitCodes.Done;
        }
    }
}
