using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Session
{
    /// <summary>A recorded session prepared for drawing: shots in order of time, who fired, what was hit, sums. All lists in a fixed order.</summary>
    internal sealed class ReportData
    {
        private readonly List<ReportTotals> _shooters = new List<ReportTotals>();
        private readonly List<ReportTotals> _targets = new List<ReportTotals>();

        public ReportData(SessionRecorder session, ReportOptions options)
        {
            Session = session;
            Options = options;
            ZeroTimeUs = options.SceneZeroTimeUs ?? session.StartTimeUs;
            ShotEvent[] events = session.ShotsByTime();
            Shots = new ReportShot[events.Length];
            for (int i = 0; i < events.Length; i++)
                Shots[i] = Prepare(events[i]);
            AddShooters();
            AddTargets();
            foreach (ReportShot shot in Shots)
                All.Add(shot);
            ScreenSizeM = options.Scene?.ScreenSizeM ?? options.ScreenSizeM;
            HasScreen = ScreenSizeM.HasValue || Array.Exists(Shots, shot => shot.Event.HasScreenPosition);
            IsScored = options.Scene != null || Array.Exists(Shots, shot => shot.Event.HasHit);
            PictureTimeS = options.PictureTimeS ?? (Shots.Length > 0 ? SceneTimeS(Shots[0]) : 0);
        }

        public SessionRecorder Session { get; }

        public ReportOptions Options { get; }

        public ReportShot[] Shots { get; }

        public ReportTotals All { get; } = new ReportTotals("All", 0);

        /// <summary>Those who fired, by number; unknown last.</summary>
        public IReadOnlyList<ReportTotals> Shooters => _shooters;

        /// <summary>The scene's targets in its order, then what else was hit, by first hit.</summary>
        public IReadOnlyList<ReportTotals> Targets => _targets;

        /// <summary>Size of the picture in metres, if known.</summary>
        public Vector2D? ScreenSizeM { get; }

        /// <summary>Shots have, or could have, places on the screen; otherwise they are drawn in camera pixels.</summary>
        public bool HasScreen { get; }

        /// <summary>There was something to hit; otherwise no shot is a miss.</summary>
        public bool IsScored { get; }

        public double PictureTimeS { get; }

        private long ZeroTimeUs { get; }

        /// <summary>The scene's clock when the shot's light left.</summary>
        public double SceneTimeS(ReportShot shot) => (shot.Event.Shot.TimeUs - ZeroTimeUs) * 1e-6;

        public string ShooterName(ReportShot shot) => _shooters[shot.ShooterIndex].Name;

        /// <summary>Class that gives a shooter's colour; eight colours, then again.</summary>
        public static string ColorClass(int shooter) => shooter <= 0 ? "s0" : "s" + (char)('1' + (shooter - 1) % 8);

        /// <summary>Classes of a shot's mark, after its shooter's.</summary>
        public string MarkClass(ReportShot shot) => shot.IsMistake ? " mistake" : shot.Event.HasHit || !IsScored ? "" : " miss";

        private ReportShot Prepare(in ShotEvent shot)
        {
            var prepared = new ReportShot(shot) { TimeS = (shot.Shot.TimeUs - Session.StartTimeUs) * 1e-6 };
            SceneModel? scene = Options.Scene;
            if (scene == null || !shot.HasHit)
                return prepared;
            for (int i = 0; i < scene.Objects.Count; i++)
            {
                if (scene.Objects[i].Target == null || scene.Objects[i].Name != shot.Hit.Target)
                    continue;
                prepared.ObjectIndex = i;
                prepared.Definition = scene.Objects[i].Target;
                break;
            }

            return prepared;
        }

        private void AddShooters()
        {
            var numbers = new List<int>();
            foreach (ReportShot shot in Shots)
            {
                if (!numbers.Contains(shot.Event.Shooter))
                    numbers.Add(shot.Event.Shooter);
            }

            numbers.Sort((a, b) => (a <= 0 ? int.MaxValue : a).CompareTo(b <= 0 ? int.MaxValue : b));
            foreach (int number in numbers)
                _shooters.Add(new ReportTotals(NameOf(number, numbers.Count), number));
            var last = new ReportShot?[numbers.Count];
            foreach (ReportShot shot in Shots)
            {
                int index = numbers.IndexOf(shot.Event.Shooter);
                shot.ShooterIndex = index;
                if (last[index] is ReportShot before)
                {
                    shot.IntervalS = shot.TimeS - before.TimeS;
                    shot.IsTransition = shot.TargetName != before.TargetName;
                }

                last[index] = shot;
                _shooters[index].Add(shot);
            }
        }

        private string NameOf(int number, int shooters)
        {
            if (number <= 0)
                return shooters == 1 ? "All shots" : "Unknown";
            return number <= Options.ShooterNames.Count ? Options.ShooterNames[number - 1] : "Shooter " + number;
        }

        private void AddTargets()
        {
            if (Options.Scene != null)
            {
                for (int i = 0; i < Options.Scene.Objects.Count; i++)
                {
                    if (Options.Scene.Objects[i].Target != null)
                        _targets.Add(new ReportTotals(Options.Scene.Objects[i].Name, i));
                }
            }

            foreach (ReportShot shot in Shots)
            {
                if (!shot.Event.HasHit)
                    continue;
                ReportTotals? totals = _targets.Find(t => t.Number == shot.ObjectIndex && t.Name == shot.TargetName);
                if (totals == null)
                    _targets.Add(totals = new ReportTotals(shot.Event.Hit.Target, -1));
                totals.Add(shot);
            }
        }
    }
}
