using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class ReportBuilderTests
    {
        [Test]
        public void Build_FullSession_IsWellFormedAndSelfContained()
        {
            var example = new ReportExample();
            string text = Build(example.Record(), new ReportOptions { Scene = example.Scene, BackgroundPng = new byte[] { 1, 2, 3 } });
            XDocument page = XDocument.Parse(text);
            Assert.That(text, Does.StartWith("<!DOCTYPE html>"));
            foreach (XElement element in page.Descendants())
            {
                Assert.That(element.Name.LocalName, Is.Not.EqualTo("link").And.Not.EqualTo("iframe"));
                Assert.That(element.Attribute("src"), Is.Null);
                string href = (string?)element.Attribute("href") ?? "#";
                Assert.That(href.StartsWith("#", StringComparison.Ordinal) || href.StartsWith("data:image/png;base64,", StringComparison.Ordinal), Is.True, href);
            }

            Assert.That(text, Does.Not.Contain("http://").And.Not.Contain("https://").And.Not.Contain("NaN").And.Not.Contain("Infinity").And.Not.Contain("url(d"));
        }

        [Test]
        public void Build_FullSession_LinksEveryHoleWithItsRow()
        {
            var example = new ReportExample();
            XDocument page = XDocument.Parse(Build(example.Record(), new ReportOptions { Scene = example.Scene }));
            List<string> ids = page.Descendants().Select(e => (string?)e.Attribute("id")).OfType<string>().ToList();
            Assert.That(ids, Is.Unique);
            for (int shot = 1; shot <= 20; shot++)
                Assert.That(ids, Has.Member("shot-" + shot).And.Member("hole-" + shot));
            foreach (string href in page.Descendants("a").Select(e => (string)e.Attribute("href")!))
                Assert.That(ids, Has.Member(href.Substring(1)));
        }

        [Test]
        public void Build_ShotTable_HoldsTheSessionsNumbers()
        {
            var example = new ReportExample();
            SessionRecorder session = example.Record();
            XDocument page = XDocument.Parse(Build(session, new ReportOptions { Scene = example.Scene }));
            foreach (ShotEvent shot in session.Shots)
            {
                XElement row = page.Descendants("tr").Single(e => (string?)e.Attribute("id") == "shot-" + shot.Shot.Id);
                string[] cells = row.Elements().Select(cell => cell.Value).ToArray();
                Assert.That(cells[1], Is.EqualTo(((shot.Shot.TimeUs - 1234571) * 1e-6).ToString("F2", CultureInfo.InvariantCulture)));
                Assert.That(cells[cells.Length - 1], Is.EqualTo(shot.ScreenCovarianceMm2.Sigma.ToString("F1", CultureInfo.InvariantCulture)));
                if (!shot.HasHit)
                    continue;
                Assert.That(cells[4], Does.StartWith(shot.Hit.Target));
                Assert.That(cells[5], Is.EqualTo(shot.Hit.Zone));
                Assert.That(cells[6], Is.EqualTo(shot.Hit.Points.ToString(CultureInfo.InvariantCulture).Replace('-', '−')));
                Assert.That(cells[7], Is.EqualTo(shot.Hit.Score.ToString("F2", CultureInfo.InvariantCulture).Replace('-', '−')));
            }
        }

        [Test]
        public void Build_Splits_AreWithinAShooterAndMarkTransitions()
        {
            var example = new ReportExample();
            XDocument page = XDocument.Parse(Build(example.Record(), new ReportOptions { Scene = example.Scene }));
            Assert.That(Cells(page, 1)[2], Is.EqualTo("–"));
            Assert.That(Cells(page, 2)[2], Is.EqualTo("0.26"));
            Assert.That(Cells(page, 3)[2], Is.EqualTo("–"), "the other shooter's first");
            Assert.That(Cells(page, 5)[2], Is.EqualTo("→ 0.58"));
        }

        [Test]
        public void Build_Totals_AreTheSums()
        {
            var example = new ReportExample();
            SessionRecorder session = example.Record();
            XDocument page = XDocument.Parse(Build(session, new ReportOptions { Scene = example.Scene }));
            Dictionary<string, string> tiles = page.Descendants("dl").First().Elements("div").ToDictionary(e => e.Element("dt")!.Value, e => e.Element("dd")!.Value);
            Assert.That(tiles["Shots"], Is.EqualTo("20"));
            Assert.That(tiles["Hits"], Is.EqualTo("17 85 %"));
            Assert.That(tiles["Misses"], Is.EqualTo("2"));
            Assert.That(tiles["No-shoot hits"], Is.EqualTo("1"));
            Assert.That(tiles["Points"], Is.EqualTo(session.Shots.Sum(shot => shot.Hit.Points).ToString(CultureInfo.InvariantCulture)));
            XElement mistake = page.Descendants("tr").Single(e => (string?)e.Attribute("id") == "shot-13");
            Assert.That(mistake.Value, Does.Contain("no-shoot hit"), "not told by colour alone");
        }

        [Test]
        public void Build_Hole_LiesWhereTheShotLanded()
        {
            var example = new ReportExample();
            SessionRecorder session = example.Record();
            XDocument page = XDocument.Parse(Build(session, new ReportOptions { Scene = example.Scene }));
            foreach (ShotEvent shot in session.Shots)
            {
                XElement hole = page.Descendants("a").Single(e => (string?)e.Attribute("id") == "hole-" + shot.Shot.Id);
                string place = (string)hole.Elements("g").Single().Attribute("transform")!;
                double scale = 1000 / ReportExample.ScreenSizeM.X;
                Match numbers = Regex.Match(place, @"^translate\((\S+) (\S+)\)$");
                Assert.That(double.Parse(numbers.Groups[1].Value, CultureInfo.InvariantCulture), Is.EqualTo(shot.ScreenM.X * scale).Within(0.051));
                Assert.That(double.Parse(numbers.Groups[2].Value, CultureInfo.InvariantCulture), Is.EqualTo(shot.ScreenM.Y * scale).Within(0.051));
            }
        }

        [Test]
        public void Build_HostileNames_AreEscaped()
        {
            const string evil = "</script><img src=x onerror=\"alert('1')\">&\u0000\u001b\uD800";
            ShotEvent shot = EventExamples.FullShot();
            shot.Hit.Target = shot.Hit.Zone = evil;
            var session = new SessionRecorder();
            session.Begin(new SessionHeader(evil, new[] { new SessionInput(evil, evil) }, evil, evil, null));
            session.OnShot(shot);
            HealthEvent health = EventExamples.Health(1, 1);
            health.Text = evil;
            session.OnHealth(health);
            session.End(EventExamples.End());
            string text = Build(session, new ReportOptions { Title = evil, ScoringRule = evil, ShooterNames = new[] { "a", evil } });
            XDocument page = XDocument.Parse(text);
            Assert.That(page.Descendants("img"), Is.Empty);
            Assert.That(page.Descendants("script").Count(), Is.EqualTo(1));
            Assert.That(text.Split(new[] { "</script>" }, StringSplitOptions.None).Length, Is.EqualTo(2));
            Assert.That(page.Descendants("h1").Single().Value, Does.StartWith("</script><img src=x onerror=\"alert('1')\">&"));
        }

        [Test]
        public void Build_NothingRecorded_SaysSo()
        {
            string text = Build(new SessionRecorder(), new ReportOptions());
            XDocument.Parse(text);
            Assert.That(text, Does.Contain("No shots were fired.").And.Contain("interrupted").And.Contain("No problems were noticed."));
        }

        [Test]
        public void Build_WithoutCalibration_DrawsPixelsAndScoresNothing()
        {
            var session = new SessionRecorder();
            session.Begin(EventExamples.Header());
            session.OnShot(EventExamples.PlainShot(1, 1000000));
            session.End(EventExamples.End());
            XDocument page = XDocument.Parse(Build(session, new ReportOptions { ImageSizePx = new Vector2D(640, 480) }));
            XElement hole = page.Descendants("a").Single(e => (string?)e.Attribute("id") == "hole-1");
            Assert.That((string?)hole.Elements("g").Single().Attribute("transform"), Is.EqualTo("translate(471 450.2)"));
            Assert.That(page.Root!.Value, Does.Contain("no screen calibration").And.Not.Contain("Zone sure, "));
            Assert.That(page.Descendants("dt").Select(e => e.Value), Has.No.Member("Misses"));
        }

        [Test]
        public void Build_Twice_GivesTheSameTextInAnyCulture()
        {
            var example = new ReportExample();
            var options = new ReportOptions { Scene = example.Scene };
            SessionRecorder session = example.Record();
            string expected = Build(session, options);
            CultureInfo before = CultureInfo.CurrentCulture;
            try
            {
                var german = (CultureInfo)CultureInfo.InvariantCulture.Clone();
                german.NumberFormat.NumberDecimalSeparator = ",";
                german.NumberFormat.NegativeSign = "~";
                CultureInfo.CurrentCulture = german;
                Assert.That(Build(new ReportExample().Record(), options), Is.EqualTo(expected));
            }
            finally
            {
                CultureInfo.CurrentCulture = before;
            }
        }

        [Test]
        public void Build_ProcessingTimes_OnlyWhenAskedFor()
        {
            SessionRecorder session = new ReportExample().Record();
            Assert.That(Build(session, new ReportOptions()), Does.Not.Contain("Time a frame"));
            Assert.That(Build(session, new ReportOptions { ShowProcessingTimes = true }), Does.Contain("Time a frame"));
        }

        [Test]
        public void Build_ShotsWithNumbersOutOfRange_StaysWellFormed()
        {
            var session = new SessionRecorder();
            session.Begin(EventExamples.Header());
            var random = new Random(3);
            double[] odd = { double.NaN, double.PositiveInfinity, -1e300, 1e300, 0, -5 };
            for (int i = 0; i < 200; i++)
            {
                ShotEvent shot = EventExamples.FullShot();
                shot.Shot.Id = i + 1;
                shot.Shot.TimeUs = random.Next(3) == 0 ? long.MaxValue / 2 : random.Next();
                shot.ScreenM = new Vector2D(odd[random.Next(6)], odd[random.Next(6)]);
                shot.ScreenCovarianceMm2 = new Covariance2D(odd[random.Next(6)], odd[random.Next(6)], odd[random.Next(6)]);
                shot.Hit.LocalPointM = new Vector2D(odd[random.Next(6)], odd[random.Next(6)]);
                shot.Hit.Score = odd[random.Next(6)];
                shot.Shooter = random.Next(-1, 30);
                session.OnShot(shot);
            }

            session.End(EventExamples.End());
            XDocument page = XDocument.Parse(Build(session, new ReportOptions { Scene = new ReportExample().Scene }));
            Assert.That(page.Descendants("tr").Count(e => e.Attribute("data-shot") != null), Is.EqualTo(200));
        }

        private static string[] Cells(XDocument page, int shot) =>
            page.Descendants("tr").Single(e => (string?)e.Attribute("id") == "shot-" + shot).Elements().Select(cell => cell.Value).ToArray();

        private static string Build(SessionRecorder session, ReportOptions options) => ReportBuilder.Build(session, options);
    }
}
