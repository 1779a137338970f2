using System.Linq;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class ScoreSheetTests
    {
        [Test]
        public void ScoreSheet_ShotsOfSeveral_AreSummedForEachAndForAll()
        {
            var sheet = new ScoreSheet();
            sheet.Add(Shot(2, 1.0, "A", 5));
            sheet.Add(Shot(1, 1.2, "A", 3));
            sheet.Add(Shot(0, 1.3, null, 0));
            sheet.Add(Shot(2, 1.5, "A", 5));
            sheet.Add(Shot(2, 2.25, "B", -2));
            Assert.That(sheet.Shooters.Select(row => row.Number), Is.EqualTo(new[] { 1, 2, 0 }));
            ReportTotals second = sheet.Shooters[1];
            Assert.That((second.Shots, second.Hits, second.Mistakes, second.Misses, second.Score), Is.EqualTo((3, 2, 1, 0, 8.0)));
            Assert.That((second.Splits, second.BestSplitS, second.Transitions), Is.EqualTo((1, 0.5, 1)));
            Assert.That((sheet.Total.Shots, sheet.Total.Score, sheet.Total.Misses), Is.EqualTo((5, 11.0, 1)));
            Assert.That(sheet.LastIntervalS, Is.EqualTo(0.75).Within(1e-12));
            Assert.That(sheet.Last.Hit.Target, Is.EqualTo("B"));
        }

        [Test]
        public void ScoreSheet_Cleared_IsNew()
        {
            var sheet = new ScoreSheet();
            sheet.Add(Shot(1, 1, "A", 5));
            sheet.Clear();
            Assert.That(sheet.Shooters, Is.Empty);
            sheet.Add(Shot(1, 9, "A", 5));
            Assert.That((sheet.Total.Shots, sheet.LastIntervalS), Is.EqualTo((1, double.NaN)));
        }

        private static ShotEvent Shot(int shooter, double timeS, string? target, int points)
        {
            var shot = new ShotEvent { Shooter = shooter, HasHit = target != null };
            shot.Shot.TimeUs = (long)(timeS * 1e6 + 0.5);
            if (target != null)
                shot.Hit = new ScoredHit { Target = target, Points = points, Score = points };
            return shot;
        }
    }
}
