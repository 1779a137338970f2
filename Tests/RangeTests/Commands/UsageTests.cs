using LaserTracking.Host;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class UsageTests
    {
        [TestCase("foo: there is no such command", "foo")]
        [TestCase("--foo: there is no such option", "--foo")]
        [TestCase("replay: INPUT is missing", "replay")]
        [TestCase("b: one word too many", "replay", "a", "b")]
        [TestCase("--foo: there is no such option", "replay", "a", "--foo")]
        [TestCase("--events: its value is missing", "replay", "a", "--events")]
        [TestCase("--hand-offset-us: \"x\" is not a whole number", "replay", "a", "--hand-offset-us", "x")]
        [TestCase("--detector: there is no detector \"foo\"", "replay", "a", "--detector", "foo")]
        [TestCase("--exposure-us, --row-us: ExposureUs is -5", "replay", "a", "--exposure-us", "-5")]
        [TestCase("--exposure-us, --row-us: RowUs is 5000", "replay", "a", "--row-us", "5000")]
        [TestCase("--exposure-us: \"x\" is not a number", "replay", "a", "--exposure-us", "x")]
        [TestCase("--seed: \"text\" is not a whole number", "demo", "--seed", "text")]
        [TestCase("--seed: \"99999999999\" is not a whole number up to", "demo", "--seed", "99999999999")]
        [TestCase("--out: must be given; './range help extract'", "extract", "a")]
        [TestCase("--captures: \"5..2\"", "extract", "a", "--out", "b", "--captures", "5..2")]
        [TestCase("--captures: \"-1..2\"", "extract", "a", "--out", "b", "--captures", "-1..2")]
        [TestCase("--captures: \"99999999999..2\"", "extract", "a", "--out", "b", "--captures", "99999999999..2")]
        [TestCase("foo: there is no such benchmark", "bench", "foo")]
        [TestCase("foo: there is no such command", "help", "foo")]
        [TestCase("calibrate foo: there is no such command", "help", "calibrate", "foo")]
        [TestCase("--size: must be given; './range help calibrate screen'", "calibrate", "screen")]
        public void Usage_WrongLine_IsOneLineThatNamesTheWord(string words, params string[] arguments) =>
            Assert.That(CommandLine.AssertRefused(words, arguments), Does.StartWith("range: "));

        [TestCase("Commands:", "help")]
        [TestCase("--calibration <FILE>", "help", "replay")]
        [TestCase("--corners <X,Y>", "help", "calibrate", "screen")]
        [TestCase("detect-1080p", "help", "bench")]
        public void Help_OfACommand_ExplainsIt(string words, params string[] arguments)
        {
            (int exitCode, string output, string error) = CommandLine.Run(arguments);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(error, Is.Empty);
            Assert.That(output, Does.Contain(words));
        }
    }
}
