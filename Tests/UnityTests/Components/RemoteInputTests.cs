using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Threading;
using LaserTracking.Geometry;
using LaserTracking.Remote;
using LaserTracking.Scoring;
using LaserTracking.Session;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    public sealed class RemoteInputTests : StandInTests
    {
        private readonly List<ShotEvent> _shots = new List<ShotEvent>();

        private RemoteInput Create(string address = "127.0.0.1")
        {
            _shots.Clear();
            var owner = new GameObject("remote");
            owner.SetActive(false);
            RemoteInput input = owner.AddComponent<RemoteInput>();
            SerializedFields.Set(input, "_port", 0);
            SerializedFields.Set(input, "_address", address);
            SerializedFields.Set(input, "_hitLayers", 1 << 8);
            SerializedFields.Set(input, "_screen", new GameObject("screen").AddComponent<ScreenSurface>());
            var eye = new GameObject("eye");
            eye.transform.position = new Vector3(0, 0, -3);
            SerializedFields.Set(input, "_viewpoint", eye.transform);
            input.ShotFired += shot => _shots.Add(shot);
            return input;
        }

        private static void Send(IPEndPoint to, string text)
        {
            using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
            socket.SendTo(Encoding.UTF8.GetBytes(text), to);
        }

        private static string Shot(int id, string screenM) =>
            "{\"v\":1,\"stream\":5,\"counter\":" + id + ",\"sent_us\":" + (DateTime.UtcNow - DateTime.UnixEpoch).Ticks / 10 + ",\"type\":\"shot\",\"id\":" + id
            + ",\"time_us\":1,\"confidence\":0.9,\"screen_m\":" + screenM + ",\"screen_cov_mm2\":[1,0,1]}";

        private sealed class WallClock : IClock
        {
            public long NowUs => (DateTime.UtcNow - DateTime.UnixEpoch).Ticks / 10;
        }

        private static void Play(Func<bool> until, int most = 500)
        {
            for (int i = 0; i < most && !until(); i++)
            {
                Thread.Sleep(10);
                PlayerLoop.Step(1 / 60.0);
            }
        }

        [Test]
        public void RemoteInput_Shot_HitsTheTargetBehindTheScreen()
        {
            LaserTarget plate = RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.5f);
            plate.gameObject.SetActive(true);
            int reported = 0;
            plate.Hit += _ => reported++;
            RemoteInput input = Create();
            input.gameObject.SetActive(true);
            Send(input.EndPoint!, Shot(1, "[1.865,1.13]"));
            Send(input.EndPoint!, Shot(2, "[0.1,0.1]"));
            Play(() => _shots.Count == 2);
            Assert.That(_shots.Select(shot => (shot.Shot.Id, shot.HasHit)), Is.EqualTo(new[] { (1, true), (2, false) }));
            Assert.That((_shots[0].Hit.Target, _shots[0].Hit.Points, reported), Is.EqualTo(("plate", 5, 1)));
        }

        [Test]
        public void RemoteInput_PublishedShot_IsPlacedByFlipFromCameraZeroAndHits()
        {
            RangeRig.AddPlate("plate", new Vector3(1, 0.6f, 4), 0.3f).gameObject.SetActive(true);
            RemoteInput input = Create();
            SerializedFields.Set(input, "_aim", AimRay.Muzzle);
            var camera = new GameObject("camera 0");
            camera.transform.position = new Vector3(0.2f, 0.1f, -2.5f);
            SerializedFields.Set(input, "_camera", camera.transform);
            input.gameObject.SetActive(true);

            // In the scene the muzzle is at (0.2, -0.3, -2) and points at the plate's middle; y is down in the message.
            Vector3D muzzle = new Vector3D(0.2, -0.3, -2), along = (new Vector3D(1, 0.6, 4) - muzzle).Normalized;
            string text = FormattableString.Invariant($"{{\"timestamp\":7.5,\"muzzle\":[0,400,500],\"direction\":[{along.X},{-along.Y},{along.Z}],\"confidence\":0.9,\"shot\":true}}");
            Send(input.EndPoint!, text);
            Play(() => _shots.Count == 1);
            Assert.That((_shots[0].HasHit, _shots[0].Hit.Target), Is.EqualTo((true, "plate")));
            Assert.That(_shots[0].Hit.LocalPointM.Length, Is.LessThan(0.002));
            Assert.That(_shots[0].ScreenM.X - 3.73 / 2, Is.EqualTo(0.2 + along.X / along.Z * 2).Within(1e-4), "through the screen's plane");
            Assert.That(input.TryGetAim(out Ray ray), Is.True);
            Assert.That((ray.origin - muzzle.ToUnity()).magnitude, Is.LessThan(1e-4f));
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void RemoteInput_PublishedShotWithoutCamera_SaysSoOnce()
        {
            RemoteInput input = Create();
            input.gameObject.SetActive(true);
            for (int i = 0; i < 3; i++)
                Send(input.EndPoint!, "{\"timestamp\":" + (7 + i) + ",\"muzzle\":[0,0,0],\"direction\":[0,0,1],\"shot\":true}");
            Play(() => _shots.Count == 3);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.Contain("where camera 0 stands is not known"));
            Assert.That(_shots.Any(shot => shot.HasHit), Is.False);
        }

        [Test]
        public void RemoteInput_ShotThatWasUnderWay_MeetsTheTargetWhereItWasThen()
        {
            LaserTarget plate = RangeRig.AddPlate("runner", new Vector3(0, 0, 4), 0.4f);
            TargetMotion motion = plate.gameObject.AddComponent<TargetMotion>();
            SerializedFields.Set(motion, "_kind", MotionKind.PingPong);
            SerializedFields.Set(motion, "_travelM", new Vector3(10, 0, 0));
            SerializedFields.Set(motion, "_periodS", 20f);
            plate.gameObject.SetActive(true);
            RemoteInput input = Create();
            SerializedFields.Set(input, "_latencyS", 2f);
            PlayerLoop.Step(2);
            input.gameObject.SetActive(true);
            Send(input.EndPoint!, Shot(1, "[1.865,1.13]"));
            Play(() => _shots.Count == 1);
            Assert.That(plate.transform.position.x, Is.GreaterThan(1.9f), "one metre a second");
            Assert.That((_shots[0].HasHit, _shots[0].Hit.Target), Is.EqualTo((true, "runner")));
        }

        [TestCase(1.5f, true)]
        [TestCase(0f, false)]
        public void RemoteInput_ScreenAndEyeMovedSince_ShotGoesThroughThemAsTheyStood(float latencyS, bool hits)
        {
            RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.4f).gameObject.SetActive(true);
            RemoteInput input = Create();
            SerializedFields.Set(input, "_latencyS", latencyS);
            input.gameObject.SetActive(true);
            PlayerLoop.Step(1);
            PlayerLoop.Step(0.01);
            input.Screen!.transform.position += new Vector3(3, 0, 0);
            input.Viewpoint!.position += new Vector3(3, 0, 0);
            // Far enough for what a busy machine needs to bring a packet.
            PlayerLoop.Step(0.5);
            PlayerLoop.Step(0.5);
            Send(input.EndPoint!, Shot(1, "[1.865,1.13]"));
            Play(() => _shots.Count == 1, 20);
            Assert.That(_shots.Select(shot => shot.HasHit), Is.EqualTo(new[] { hits }));
        }

        [Test]
        public void RemoteInput_File_BringsEveryShotOnceAndNoPort()
        {
            LaserTarget plate = RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.5f);
            plate.gameObject.SetActive(true);
            string folder = Directory.CreateTempSubdirectory("remote-file-").FullName;
            try
            {
                RemoteInput input = Create();
                SerializedFields.Set(input, "_file", Path.Combine(folder, "detector.json"));
                input.gameObject.SetActive(true);
                Assert.That(input.EndPoint, Is.Null);
                using (var sender = new RemoteFileSender(Path.Combine(folder, "detector.json"), new WallClock()))
                {
                    for (int id = 1; id <= 3; id++)
                    {
                        ShotEvent shot = default;
                        shot.Shot.Id = id;
                        shot.Shot.Dot.Confidence = 1;
                        shot.HasScreenPosition = true;
                        shot.ScreenM = new Vector2D(1.865, 1.13);
                        sender.SendShot(shot);
                        Play(() => _shots.Count == id);
                    }
                }

                Play(() => false, 5);
                Assert.That(_shots.Select(shot => (shot.Shot.Id, shot.HasHit)), Is.EqualTo(new[] { (1, true), (2, true), (3, true) }));
                input.enabled = false;
                Assert.That(input.Inbox, Is.Null);
                Assert.That(ConsoleLog.Entries, Is.Empty);
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }

        [Test]
        public void RemoteInput_Garbage_IsOneWarning()
        {
            RemoteInput input = Create();
            input.gameObject.SetActive(true);
            Send(input.EndPoint!, "hello");
            Send(input.EndPoint!, "hello");
            Play(() => input.Inbox!.Dropped(RemoteDrop.NotJson) == 2);
            PlayerLoop.Step(1 / 60.0);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.StartWith("remote input: a packet is not a JSON object"));
        }

        [Test]
        public void RemoteInput_HostilePackets_AreOneMessageEachAndTheGenuineShotComesThrough()
        {
            const string KeyText = "00112233445566778899aabbccddeeff";
            string file = Path.GetTempFileName();
            File.WriteAllText(file, KeyText);
            try
            {
                RemoteInput input = Create();
                SerializedFields.Set(input, "_keyFile", file);
                var told = new List<string>();
                input.HealthChanged += health => told.Add(health.Text);
                input.gameObject.SetActive(true);
                byte[] genuine = Sign(Shot(1, "[1.865,1.13]"), KeyText), forged = (byte[])genuine.Clone();
                forged[^1] = (byte)(forged[^1] == '0' ? '1' : '0');
                byte[] stale = Sign(System.Text.RegularExpressions.Regex.Replace(Shot(2, "[1,1]"), "\"sent_us\":[0-9]+", "\"sent_us\":1700000000000000"), KeyText), notUtf8 = Sign("{\"v\":1,\"\u00e9\":1}", KeyText, Encoding.Latin1);
                byte[][] hostile = { forged, Encoding.UTF8.GetBytes(Shot(3, "[1,1]")), stale, notUtf8, new byte[3000], Sign(Shot(4, "[NaN,1]"), KeyText), Sign(Shot(5, "[1e9,1]"), KeyText) };
                SendAll(input.EndPoint!, genuine);
                Play(() => _shots.Count == 1);
                for (int i = 0; i < 3; i++)
                {
                    SendAll(input.EndPoint!, genuine);
                    SendAll(input.EndPoint!, hostile);
                }

                SendAll(input.EndPoint!, Sign(Shot(6, "[1.865,1.13]"), KeyText));
                Play(() => _shots.Count == 2);
                PlayerLoop.Step(1 / 60.0);
                RemoteDrop[] reasons = { RemoteDrop.Replayed, RemoteDrop.Forged, RemoteDrop.Unsigned, RemoteDrop.Stale, RemoteDrop.NotUtf8, RemoteDrop.Oversized, RemoteDrop.NotJson, RemoteDrop.OutOfRange };
                Assert.That(reasons.Select(reason => input.Inbox!.Dropped(reason)), Is.All.EqualTo(3));
                Assert.That(_shots.Select(shot => shot.Shot.Id), Is.EqualTo(new[] { 1, 6 }));
                Assert.That(told, Has.Count.EqualTo(reasons.Length).And.Unique);
                Assert.That(ConsoleLog.Entries.Select(entry => entry.Message), Is.EquivalentTo(told));
            }
            finally
            {
                File.Delete(file);
            }
        }

        private static byte[] Sign(string text, string key, Encoding? encoding = null)
        {
            byte[] body = (encoding ?? Encoding.UTF8).GetBytes(text);
            string signature = Convert.ToHexStringLower(System.Security.Cryptography.HMACSHA256.HashData(Convert.FromHexString(key), body));
            return body.Append((byte)'\n').Concat(Encoding.ASCII.GetBytes(signature)).ToArray();
        }

        private static void SendAll(IPEndPoint to, params byte[][] packets)
        {
            using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
            foreach (byte[] packet in packets)
                socket.SendTo(packet, to);
        }

        [Test]
        public void RemoteInput_Disabled_ClosesItsPortAndListensAnewWhenEnabled()
        {
            RemoteInput input = Create();
            input.gameObject.SetActive(true);
            SerializedFields.Set(input, "_port", input.EndPoint!.Port);
            input.enabled = false;
            Assert.That(input.EndPoint, Is.Null);
            input.enabled = true;
            Send(input.EndPoint!, Shot(1, "[1,1]"));
            Play(() => _shots.Count == 1);
            Assert.That(_shots, Has.Count.EqualTo(1));
        }

        [TestCase("0.0.0.0", "give it a key")]
        [TestCase("here", "this is no address")]
        public void RemoteInput_WrongSetting_IsOneMessageAndNothingElse(string address, string words)
        {
            RemoteInput input = Create(address);
            input.gameObject.SetActive(true);
            PlayerLoop.Step(0.1);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.StartWith("RemoteInput remote: ").And.Contain(words));
        }
    }
}
