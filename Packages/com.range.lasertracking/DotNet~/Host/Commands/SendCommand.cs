using System;
using System.CommandLine;
using System.Globalization;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Host.Events;
using LaserTracking.Host.Remote;
using LaserTracking.Remote;
using LaserTracking.Session;

namespace LaserTracking.Host.Commands
{
    /// <summary>range send: plays a session's events, or one test message, to a remote input.</summary>
    internal static class SendCommand
    {
        private const double TestDistanceM = 2.5;

        public static Command Create()
        {
            var input = new Argument<string?>("EVENTS") { Arity = ArgumentArity.ZeroOrOne, Description = "An events.jsonl: its shots and hands are sent." };
            var to = new Option<string>("--to") { HelpName = "HOST:PORT", Description = "Where the remote input listens.", DefaultValueFactory = _ => "127.0.0.1:9997" };
            var key = new Option<string?>("--key-file") { HelpName = "FILE", Description = "The receiver's key, 32 to 128 hexadecimal digits; needed on a network." };
            var toFile = new Option<string?>("--to-file") { HelpName = "FILE", Description = "Through a file that the receiver watches, in place of the network." };
            var shot = new Option<string?>("--shot") { HelpName = "X,Y", Description = "Sends one test shot there: metres from the screen's top-left corner." };
            var hand = new Option<string?>("--hand") { HelpName = "X,Y,Z", Description = "Sends one test pose: a muzzle there, screen space, metres." };
            var published = new Option<bool>("--published") { Description = "Sends one published message: a ray straight ahead, 1.5 m beside camera 0." };
            var speed = new Option<double>("--speed") { HelpName = "FACTOR", Description = "1: as fast as it happened; 2: twice as fast.", DefaultValueFactory = _ => 1 };
            var command = new Command("send", "Sends shots and hands to a remote input, from a session's events or as single test messages.") { input, to, key, toFile, shot, hand, published, speed };
            command.SetAction((parsed, interrupted) =>
            {
                string? events = parsed.GetValue(input);
                double factor = parsed.GetValue(speed);
                if (!(factor >= 0.01 && factor <= 100))
                    throw new InputException("--speed", "must lie in 0.01…100", "1 is the speed at which it happened");
                double[]? shotM = Numbers("--shot", parsed.GetValue(shot), 2), handM = Numbers("--hand", parsed.GetValue(hand), 3);
                bool isTest = shotM != null || handM != null || parsed.GetValue(published);
                if (isTest == (events != null))
                    throw new InputException("send", "needs either a file of events or a test message", "give an events.jsonl, or --shot, --hand or --published");
                string? file = parsed.GetValue(toFile);
                if (file != null && !parsed.GetResult(to)!.Implicit)
                    throw new InputException("--to-file", "--to names another way", "give one of the two");
                using IRemoteSender sender = SendTarget.Open("--to", parsed.GetValue(to)!, parsed.GetValue(key), file);
                if (events != null)
                    return Task.FromResult(Play(events, sender, factor, interrupted));
                SendTests(sender, shotM, handM, parsed.GetValue(published));
                return Task.FromResult(Report(sender, "sent"));
            });
            return command;
        }

        private static int Play(string events, IRemoteSender sender, double speed, CancellationToken interrupted)
        {
            var paced = new PacedSink(new RemoteEventSink(sender), speed, interrupted);
            EventReader.Read(events, paced);
            int code = Report(sender, FormattableString.Invariant($"{paced.Shots} shots, {paced.Hands} hands sent"));
            return interrupted.IsCancellationRequested ? ExitCodes.Interrupted : code;
        }

        private static void SendTests(IRemoteSender sender, double[]? shotM, double[]? handM, bool published)
        {
            long nowUs = new WallClock().NowUs;
            var nowhere = new Vector3D(double.NaN, double.NaN, double.NaN);
            if (shotM != null)
            {
                ShotEvent shot = default;
                shot.Shot.Id = 1;
                shot.Shot.TimeUs = nowUs;
                shot.Shot.Dot = new Dot { PositionPx = new Vector2D(double.NaN, double.NaN), Confidence = 1 };
                shot.HasScreenPosition = true;
                shot.ScreenM = new Vector2D(shotM[0], shotM[1]);
                sender.SendShot(shot);
            }

            if (handM != null)
                sender.SendHand(new HandEvent { TimeUs = nowUs, PalmM = nowhere, MuzzleM = new Vector3D(handM[0], handM[1], handM[2]), DepthSource = DepthSource.Assumed });
            if (!published)
                return;
            double mm = TestDistanceM * 1000;
            sender.SendPublished(new RemotePose { TimeUs = nowUs, Muzzle = new Vector3D(1500, 0, 0), Target = new Vector3D(1500, 0, mm), Direction = new Vector3D(0, 0, 1), Confidence = 1 }, false);
        }

        private static int Report(IRemoteSender sender, string what)
        {
            // What still waits is sent now; only then is it known what became of it.
            sender.Dispose();
            Console.WriteLine(what);
            if (sender.Failures + sender.LostShots == 0)
                return ExitCodes.Done;
            string doing = sender is RemoteFileSender ? "the file could not be replaced; check folder, rights and disk" : "nobody listens there; start the receiver first";
            Console.Error.WriteLine(FormattableString.Invariant($"range: send: {sender.Failures} messages were refused and {sender.LostShots} shots given up: {doing}"));
            return ExitCodes.CheckFailed;
        }

        private static double[]? Numbers(string option, string? text, int count)
        {
            if (text == null)
                return null;
            string[] parts = text.Split(',');
            var numbers = new double[count];
            bool areNumbers = parts.Length == count;
            for (int i = 0; areNumbers && i < count; i++)
                areNumbers = double.TryParse(parts[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]) && Math.Abs(numbers[i]) <= 100;
            return areNumbers ? numbers : throw new InputException(option, $"\"{text}\" is not {count} numbers of metres", count == 2 ? "write it like 1.5,0.8" : "write it like 1.1,1.2,-2.3");
        }
    }
}
