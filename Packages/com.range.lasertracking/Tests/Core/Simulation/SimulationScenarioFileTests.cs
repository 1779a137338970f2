using System.Globalization;
using System.Threading;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Simulation
{
    public sealed class SimulationScenarioFileTests
    {
        [Test]
        public void SimulationScenarioFile_RoundTrip_KeepsEverySetting()
        {
            SimulationScenario scenario = SimulationExamples.Small(3);
            scenario.ColorCamera.Format = PixelFormat.Nv12;
            scenario.ColorCamera.PositionM = new Vector3D(1.5, 0.25, -3.125);
            scenario.Shooters[0].Laser.Color = LaserColor.Red;
            scenario.Shots.Add(new ShotSettings { TimeS = 0.1, ScreenM = new Vector2D(0.3, 0.7), SweepMPerS = new Vector2D(1, -2) });
            scenario.Nudges.Add(new NudgeSettings { TimeS = 1, ShiftPx = new Vector2D(1.5, 0) });
            scenario.Generator.ShotsPerMinute = 12.5;
            string json = SimulationScenarioFile.ToJson(scenario);
            SimulationScenario back = SimulationScenarioFile.Parse(json, "test");
            Assert.That(SimulationScenarioFile.ToJson(back), Is.EqualTo(json));
            Assert.That(back.ColorCamera.Format, Is.EqualTo(PixelFormat.Nv12));
            Assert.That(back.ColorCamera.PositionM, Is.EqualTo(new Vector3D(1.5, 0.25, -3.125)));
            Assert.That(back.Shooters[0].Laser.Color, Is.EqualTo(LaserColor.Red));
            Assert.That(back.Shots[0].SweepMPerS, Is.EqualTo(new Vector2D(1, -2)));
            Assert.That(json, Does.Contain("\"exposure_us\": 16670"));
        }

        [Test]
        public void SimulationScenarioFile_EmptyObject_GivesTheDefaults()
        {
            string defaults = SimulationScenarioFile.ToJson(new SimulationScenario());
            Assert.That(SimulationScenarioFile.ToJson(SimulationScenarioFile.Parse("{}", "test")), Is.EqualTo(defaults));
        }

        [Test]
        public void SimulationScenarioFile_CommaCulture_ReadsAndWritesPoints()
        {
            CultureInfo before = Thread.CurrentThread.CurrentCulture;
            try
            {
                Thread.CurrentThread.CurrentCulture = (CultureInfo)CultureInfo.InvariantCulture.Clone();
                Thread.CurrentThread.CurrentCulture.NumberFormat.NumberDecimalSeparator = ",";
                SimulationScenario scenario = SimulationScenarioFile.Parse("{\"duration_s\": 2.5}", "test");
                Assert.That(scenario.DurationS, Is.EqualTo(2.5));
                Assert.That(SimulationScenarioFile.ToJson(scenario), Does.Contain("\"duration_s\": 2.5"));
            }
            finally
            {
                Thread.CurrentThread.CurrentCulture = before;
            }
        }

        [TestCase("{\n \"sed\": 1\n}", "line 2: sed is no known setting")]
        [TestCase("{\n\n \"room\": { \"colour\": 1 }\n}", "line 3: room.colour is no known setting")]
        [TestCase("{\n \"seed\": \"x\"\n}", "line 2: seed is \"x\"; give a number from 0 to 2147483647")]
        [TestCase("{\n \"seed\": 1.5\n}", "line 2: seed is not a whole number")]
        [TestCase("{\n \"seed\": null\n}", "line 2: seed is null")]
        [TestCase("{\n \"duration_s\": NaN\n}", "line 2: duration_s is NaN")]
        [TestCase("{\n \"duration_s\": Infinity\n}", "line 2: duration_s is Infinity")]
        [TestCase("{\n \"duration_s\": 0\n}", "line 2: duration_s is 0; give a number from 0.1 to 36000")]
        [TestCase("{ \"seed\": 123456789012345678901234567890 }", "line 1: seed is Infinity")]
        [TestCase("{ \"color_camera\": {\n \"width\": 321 } }", "line 2: color_camera.width is odd")]
        [TestCase("{ \"color_camera\": {\n \"exposure_us\": 40000 } }", "line 2: color_camera.exposure_us is longer than a frame")]
        [TestCase("{ \"color_camera\": {\n \"format\": \"depth16\" } }", "line 2: color_camera.format is no colour format")]
        [TestCase("{ \"color_camera\": {\n \"format\": \"1\" } }", "line 2: color_camera.format is \"1\"; give one of")]
        [TestCase("{ \"color_camera\": {\n \"position_m\": [1, 2] } }", "line 2: color_camera.position_m is array; give a list of 3 numbers")]
        [TestCase("{ \"color_camera\": {\n \"position_m\": [1, 2, 3] } }", "line 2: color_camera.position_m is not in front of the screen")]
        [TestCase("{ \"color_camera\": {\n \"jpeg_quality\": 80 } }", "line 2: color_camera.jpeg_quality needs a YUV format")]
        [TestCase("{ \"color_camera\": [1] }", "line 1: color_camera is array; give an object")]
        [TestCase("{ \"depth_camera\": {\n \"enabled\": 1 } }", "line 2: depth_camera.enabled is 1; give true or false")]
        [TestCase("{ \"shooters\": {} }", "line 1: shooters is object; give a list")]
        [TestCase("{ \"shooters\": [\n 3 ] }", "line 2: shooters[0] is 3; give an object")]
        [TestCase("{ \"shooters\": [{},\n { \"laser\": { \"color\": \"blue\" } } ] }", "line 2: shooters[1].laser.color is \"blue\"; give one of unknown, green, red, infrared")]
        [TestCase("{ \"shots\": [\n { \"target\": \"A\" } ] }", "line 2: shots[0].shooter is 1; give the number of a shooter, 1 to 0")]
        [TestCase("{ \"shooters\": [{}], \"shots\": [\n {\"time_s\": 1} ] }", "line 2: shots[0].target is missing")]
        [TestCase("{ \"shooters\": [{}], \"shots\": [\n {\"time_s\": 99, \"target\": \"A\"} ] }", "line 2: shots[0].time_s lies after the end")]
        [TestCase("{ \"shooters\": [{}], \"shots\": [{\"time_s\": 1, \"target\": \"A\"},\n {\"time_s\": 1.02, \"target\": \"A\"} ] }", "line 2: shots[1].time_s falls into an earlier shot")]
        [TestCase("{\n \"seed\": 1,\n \"seed\": 2 }", "is not")]
        [TestCase("{\n \"seed\": ", "line 2: is not valid JSON")]
        [TestCase("", "is not valid JSON")]
        [TestCase("[]", "is not valid JSON")]
        [TestCase("{}\n{}", "line 2: is not valid JSON")]
        public void SimulationScenarioFile_BadValue_IsRefusedWithItsLine(string json, string complaint)
        {
            var e = Assert.Throws<InputException>(() => SimulationScenarioFile.Parse(json, "my.json"));
            Assert.That(e!.Message, Does.StartWith("my.json: ").And.Contain(complaint));
            Assert.That(e.Message, Does.Not.Contain("\n"));
        }
    }
}
