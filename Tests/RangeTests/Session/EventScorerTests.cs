using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using LaserTracking.Host.Scoring;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class EventScorerTests
    {
        private const string Truth =
            "{\"clips\":[{\"file\":\"a.mp4\",\"width\":640,\"shots\":[" +
            "{\"id\":\"a1\",\"color\":\"green\",\"first_visible_frame\":10,\"last_visible_frame\":12,\"x_px\":100,\"y_px\":100,\"path\":[[10,100,100],[11,104,100]]}," +
            "{\"id\":\"a2\",\"color\":\"red\",\"first_visible_frame\":11,\"last_visible_frame\":11,\"x_px\":105,\"y_px\":100,\"path\":[]}," +
            "{\"id\":\"a3\",\"color\":\"red\",\"first_visible_frame\":50,\"last_visible_frame\":50,\"x_px\":10,\"y_px\":20}]}," +
            "{\"file\":\"b.mp4\",\"width\":1280,\"shots\":[{\"id\":\"b1\",\"color\":\"red\",\"first_visible_frame\":1,\"last_visible_frame\":1,\"x_px\":10,\"y_px\":10}]}]}";

        [Test]
        public void Scorer_HandMadeCase_CountsFoundMissedAndFalse()
        {
            // One event near both a1 and a2, one near a1's path only: most shots are found when the first goes to a2.
            string events = Shot(12, 104.5, 100, "red") + Shot(10, 98, 100, "green") + Shot(53, 10, 20, "red") + Shot(50, 13.1, 20, "red");
            JsonElement result = Score(events, Truth, "a.mp4");
            Assert.That(result.GetProperty("total").GetRawText().Replace("\n", "").Replace(" ", ""),
                Is.EqualTo("{\"shots\":3,\"found\":2,\"false\":2,\"color_ok\":2,\"error_px_median\":2,\"error_px_p95\":0.5}"));
            JsonElement clip = result.GetProperty("clips")[0];
            Assert.That(clip.GetProperty("missed").EnumerateArray().Select(id => id.GetString()), Is.EqualTo(new[] { "a3" }));
            Assert.That(clip.GetProperty("false_at").GetArrayLength(), Is.EqualTo(2));
        }

        [Test]
        public void Scorer_WidePicture_ScalesTheTolerance()
        {
            Assert.That(Found(Score(Shot(3, 15.9, 10, "red"), Truth, "b.mp4")), Is.EqualTo(1));
            Assert.That(Found(Score(Shot(3, 16.1, 10, "red"), Truth, "b.mp4")), Is.EqualTo(0));
            Assert.That(Found(Score(Shot(4, 10, 10, "red"), Truth, "b.mp4")), Is.EqualTo(0));
        }

        [Test]
        public void Scorer_WithoutClip_TakesTheOneTheHeaderNames()
        {
            string header = "{\"type\":\"header\",\"inputs\":[{\"path\":\"some/where/b.mp4\"}]}\n";
            Assert.That(Score(header, Truth, null).GetProperty("clips")[0].GetProperty("clip").GetString(), Is.EqualTo("b.mp4"));
            Assert.That(() => Score("", Truth, null), Throws.TypeOf<InputException>().With.Message.Contain("--clip"));
            Assert.That(() => Score("", Truth, "c.mp4"), Throws.TypeOf<InputException>().With.Message.Contain("no clip"));
        }

        [Test]
        public void Scorer_TruthByFrames_IsUnderstood()
        {
            const string truth =
                "{\"file\":\"r.mkv\",\"color\":{\"width\":1280},\"dot_model\":{\"additive_peak_rgb\":[140,1400,220]}," +
                "\"shots\":[{\"id\":\"s1\",\"first_frame\":4,\"frames\":2}]," +
                "\"frames\":[{\"dots\":[]},{\"index\":4,\"dots\":[{\"id\":\"s1\",\"x\":412.3,\"y\":233.75}]},{\"index\":5,\"dots\":[{\"id\":\"s1\",\"x\":430,\"y\":233}]}]}";
            JsonElement total = Score(Shot(7, 431, 233, "green") + Shot(8, 431, 233, "green"), truth, null).GetProperty("total");
            Assert.That(total.GetProperty("found").GetInt32(), Is.EqualTo(1));
            Assert.That(total.GetProperty("false").GetInt32(), Is.EqualTo(1));
            Assert.That(total.GetProperty("color_ok").GetInt32(), Is.EqualTo(1));
            Assert.That(total.GetProperty("error_px_median").GetDouble(), Is.EqualTo(1));
        }

        [Test]
        public void Scorer_TruthOfARecording_FindsItsOwnDots()
        {
            string path = TestFiles.Reference("k4a", "rec_laser_720p_mjpg.truth.json");
            var events = new StringBuilder();
            foreach (TruthShot shot in TruthFile.Read(path)[0].Shots)
                events.Append(Shot(shot.FirstVisibleFrame, shot.PlacesPx[0].X, shot.PlacesPx[0].Y, "green"));
            using var files = new EventFiles();
            JsonElement total = JsonDocument.Parse(EventScorer.Score(files.Write("e.jsonl", events.ToString()), path, null)).RootElement.GetProperty("total");
            Assert.That(total.GetProperty("found").GetInt32(), Is.EqualTo(4));
            Assert.That(total.GetProperty("color_ok").GetInt32(), Is.EqualTo(4));
            Assert.That(total.GetProperty("false").GetInt32(), Is.EqualTo(0));
        }

        [TestCase("nonsense", "{\"clips\":[]}", "line 1 is no JSON")]
        [TestCase("{\"type\":\"shot\",\"frame\":1,\"y_px\":2}\n", Truth, "line 1: field \"x_px\"")]
        [TestCase("{\"type\":\"shot\",\"frame\":\"1\",\"x_px\":2,\"y_px\":2}\n", Truth, "line 1: field \"frame\"")]
        [TestCase("", "{\"clips\":[{\"file\":\"a\"", "is no JSON, at line 1")]
        [TestCase("", "{}", "neither")]
        [TestCase("", "[]", "no JSON object")]
        [TestCase("", "{\"clips\":[{\"file\":\"a\",\"shots\":[]}]}", "a.width is missing")]
        [TestCase("", "{\"clips\":[{\"file\":\"a\",\"width\":640,\"shots\":[{\"first_visible_frame\":1,\"last_visible_frame\":1,\"x_px\":\"1\",\"y_px\":2}]}]}", "a.shots[0].x_px is no number")]
        [TestCase("", "{\"clips\":[{\"file\":\"a\",\"width\":640,\"shots\":[3]}]}", "a.shots[0] is no object")]
        public void Scorer_WrongInput_SaysWhereInOneLine(string events, string truth, string expected)
        {
            Assert.That(() => Score(events, truth, "a.mp4"), Throws.TypeOf<InputException>().With.Message.Contain(expected).And.Message.Not.Contain("\n"));
        }

        [Test]
        public void Scorer_FabricatedEvents_AgreesWithTheReferenceTool()
        {
            string tool = Path.GetFullPath(Path.Combine(TestFiles.Data, "..", "tools", "score_shots.py"));
            if (!File.Exists(tool))
                Assert.Ignore("reference tool not there: " + tool);
            var random = new Random(5);
            using var files = new EventFiles();
            for (int round = 0; round < 6; round++)
            {
                string truth = files.Write("t.json", RandomTruth(random)), events = files.Write("e.jsonl", RandomEvents(random));
                JsonElement expected = RunPython(tool, truth, "c.mp4=" + events, "--json");
                JsonElement actual = JsonDocument.Parse(EventScorer.Score(events, truth, "c.mp4")).RootElement;
                AssertSame(expected.GetProperty("total"), actual.GetProperty("total"), "round " + round);
                AssertSame(expected.GetProperty("clips")[0], actual.GetProperty("clips")[0], "round " + round);
            }
        }

        private static void AssertSame(JsonElement expected, JsonElement actual, string where)
        {
            foreach (JsonProperty member in expected.EnumerateObject())
            {
                JsonElement value = actual.GetProperty(member.Name);
                if (member.Value.ValueKind == JsonValueKind.Number)
                    Assert.That(value.GetDouble(), Is.EqualTo(member.Value.GetDouble()).Within(1e-6), where + " " + member.Name);
                else
                    Assert.That(Compact(value), Is.EqualTo(Compact(member.Value)), where + " " + member.Name);
            }
        }

        private static string Compact(JsonElement value) =>
            value.ValueKind == JsonValueKind.Array ? "[" + string.Join(",", value.EnumerateArray().Select(Compact)) + "]"
            : value.ValueKind == JsonValueKind.Number ? value.GetDouble().ToString("R", CultureInfo.InvariantCulture) : value.ToString();

        private static string RandomTruth(Random random)
        {
            IEnumerable<string> shots = Enumerable.Range(0, 60).Select(i =>
            {
                int first = random.Next(40), x = random.Next(60), y = random.Next(20);
                return Invariant($"{{\"id\":\"s{i}\",\"color\":\"{(i % 2 == 0 ? "red" : "green")}\",\"first_visible_frame\":{first},\"last_visible_frame\":{first + random.Next(4)},\"x_px\":{x}.5,\"y_px\":{y},\"path\":[[{first},{x},{y}.25],[{first + 1},{x + 2},{y}]]}}");
            });
            return "{\"clips\":[{\"file\":\"c.mp4\",\"width\":640,\"shots\":[" + string.Join(",", shots) + "]}]}";
        }

        private static string RandomEvents(Random random) => string.Concat(Enumerable.Range(0, 70).Select(i =>
            Shot(random.Next(44), Math.Round(random.NextDouble() * 60, 3), Math.Round(random.NextDouble() * 20, 3), i % 3 == 0 ? "green" : "red")));

        private static JsonElement RunPython(params string[] arguments)
        {
            var start = new ProcessStartInfo("python3") { RedirectStandardOutput = true };
            foreach (string argument in arguments)
                start.ArgumentList.Add(argument);
            try
            {
                using Process process = Process.Start(start)!;
                string text = process.StandardOutput.ReadToEnd();
                process.WaitForExit();
                Assert.That(process.ExitCode, Is.EqualTo(0));
                return JsonDocument.Parse(text).RootElement;
            }
            catch (System.ComponentModel.Win32Exception)
            {
                Assert.Ignore("python3 is not there");
                throw;
            }
        }

        private static int Found(JsonElement result) => result.GetProperty("total").GetProperty("found").GetInt32();

        private static JsonElement Score(string events, string truth, string? clip)
        {
            using var files = new EventFiles();
            return JsonDocument.Parse(EventScorer.Score(files.Write("e.jsonl", events), files.Write("t.json", truth), clip)).RootElement;
        }

        private static string Shot(int frame, double x, double y, string color) =>
            Invariant($"{{\"type\":\"shot\",\"frame\":{frame},\"x_px\":{x},\"y_px\":{y},\"color\":\"{color}\"}}\n");

        private static string Invariant(FormattableString text) => FormattableString.Invariant(text);
    }
}
