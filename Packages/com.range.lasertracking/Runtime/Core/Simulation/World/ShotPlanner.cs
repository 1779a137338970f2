using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>Turns a scenario's list and generator into pulses with every random choice made, in order of time.</summary>
    internal sealed class ShotPlanner
    {
        private const double BetweenShotsS = 0.3;

        private readonly SimulationScenario _scenario;
        private readonly SceneView _view;
        private readonly List<PlannedShot> _shots = new List<PlannedShot>();

        private ShotPlanner(SimulationScenario scenario, SceneView view)
        {
            _scenario = scenario;
            _view = view;
        }

        /// <exception cref="InputException">A shot names a target that the scene does not have.</exception>
        public static List<PlannedShot> Plan(SimulationScenario scenario, SceneView view)
        {
            var planner = new ShotPlanner(scenario, view);
            for (int i = 0; i < scenario.Shots.Count; i++)
                planner.AddGiven(i);
            for (int shooter = 0; shooter < scenario.Shooters.Count && scenario.Generator.ShotsPerMinute > 0; shooter++)
                planner.Generate(shooter);
            planner._shots.Sort((a, b) =>
            {
                int order = a.StartS.CompareTo(b.StartS);
                return order != 0 ? order : a.Shooter.CompareTo(b.Shooter);
            });
            return planner._shots;
        }

        private void AddGiven(int index)
        {
            ShotSettings shot = _scenario.Shots[index];
            if (shot.ScreenM is Vector2D point)
            {
                _shots.Add(new PlannedShot(shot.TimeS, shot.PulseMs / 1000, shot.Shooter - 1, -1, point, shot.SweepMPerS));
                return;
            }

            int target = _view.Find(shot.Target);
            if (target < 0)
                throw new InputException(_scenario.Name, $"shot {index + 1} aims at \"{shot.Target}\", which the scene does not have", "give the name of a target of scene " + _view.Scene.Name);
            Vector2D aim = Disturb(target, shot.OffsetM, shot.TimeS, shot.Shooter - 1, index);
            _shots.Add(new PlannedShot(shot.TimeS, shot.PulseMs / 1000, shot.Shooter - 1, target, aim, shot.SweepMPerS));
        }

        private Vector2D Disturb(int target, Vector2D localM, double timeS, int shooter, int key)
        {
            ShooterSettings settings = _scenario.Shooters[shooter];
            double sigmaM = settings.AimErrorMrad / 1000 * settings.DistanceM;
            var error = new Vector2D(CounterRandom.Gaussian(_scenario.Seed, RandomStream.AimError, key, shooter * 2),
                CounterRandom.Gaussian(_scenario.Seed, RandomStream.AimError, key, shooter * 2 + 1)) * sigmaM;
            PlaneMap toScreen = _view.TargetToScreen(target, timeS - _scenario.Projector.DelayMs / 1000);
            return toScreen.Inverse.Map(toScreen.Map(localM) + error);
        }

        private void Generate(int shooter)
        {
            ShotGeneratorSettings g = _scenario.Generator;
            double mean = Math.Max(0.05, 60 / g.ShotsPerMinute - BetweenShotsS - 0.1);
            double time = 0.5;
            bool follows = false;
            for (int n = 0; ; n++)
            {
                if (!follows)
                    time += BetweenShotsS - mean * Math.Log(1 - Random(shooter, n, 0));
                double start = follows ? time : Simultaneous(shooter, n, time);
                double pulse = Random(shooter, n, 1) < g.HeldShare ? g.HeldS
                    : g.PulseMinMs / 1000 * Math.Pow(g.PulseMaxMs / g.PulseMinMs, Random(shooter, n, 2));
                if (start + pulse > _scenario.DurationS - 0.1)
                    return;
                if (IsFree(shooter, start, start + pulse))
                    _shots.Add(follows ? Again(shooter, start, pulse) : Draw(shooter, n, start, pulse));
                follows = !follows && Random(shooter, n, 3) < g.DoubleTapShare && _shots.Count > 0 && _shots[_shots.Count - 1].Shooter == shooter;
                time = follows
                    ? Math.Max(start + g.SplitMinS + (g.SplitMaxS - g.SplitMinS) * Random(shooter, n, 4), start + pulse + 0.02)
                    : start + pulse;
            }
        }

        private PlannedShot Again(int shooter, double start, double pulse)
        {
            PlannedShot last = _shots[_shots.Count - 1];
            return new PlannedShot(start, pulse, shooter, last.Target, last.PointM, default);
        }

        private PlannedShot Draw(int shooter, int n, double start, double pulse)
        {
            ShotGeneratorSettings g = _scenario.Generator;
            Vector2D sweep = default;
            if (Random(shooter, n, 5) < g.SweepShare)
            {
                double angle = 2 * Math.PI * Random(shooter, n, 6);
                // A long pulse must not carry the dot off the screen.
                double speed = Math.Min(0.5 + 3.5 * Random(shooter, n, 7), 0.3 / pulse);
                sweep = new Vector2D(Math.Cos(angle), Math.Sin(angle)) * speed;
            }

            Vector2D size = _view.Scene.ScreenSizeM;
            if (_view.FarToNear.Length > 0 && Random(shooter, n, 8) >= g.AnywhereShare)
            {
                int target = _view.FarToNear[(int)(Random(shooter, n, 9) * _view.FarToNear.Length)];
                Vector2D extent = _view.Scene.Objects[target].Target!.SizeM;
                var local = new Vector2D((Random(shooter, n, 10) - 0.5) * 0.4 * extent.X, (Random(shooter, n, 11) - 0.5) * 0.5 * extent.Y);
                Vector2D seen = _view.TargetToScreen(target, start).Map(local);
                if (seen.X > 0.05 * size.X && seen.X < 0.95 * size.X && seen.Y > 0.05 * size.Y && seen.Y < 0.95 * size.Y)
                    return new PlannedShot(start, pulse, shooter, target, Disturb(target, local, start, shooter, 100000 + n), sweep);
            }

            var point = new Vector2D((0.06 + 0.88 * Random(shooter, n, 12)) * size.X, (0.06 + 0.88 * Random(shooter, n, 13)) * size.Y);
            return new PlannedShot(start, pulse, shooter, -1, point, sweep);
        }

        private double Simultaneous(int shooter, int n, double time)
        {
            if (shooter == 0 || Random(shooter, n, 14) >= _scenario.Generator.SimultaneousShare)
                return time;
            foreach (PlannedShot other in _shots)
            {
                if (other.Shooter != shooter && other.StartS >= time && other.StartS < time + 3)
                    return other.StartS;
            }

            return time;
        }

        private bool IsFree(int shooter, double start, double end)
        {
            foreach (PlannedShot other in _shots)
            {
                if (other.Shooter == shooter && start < other.EndS + 0.015 && other.StartS < end + 0.015)
                    return false;
            }

            return true;
        }

        private double Random(int shooter, int n, int what) =>
            CounterRandom.Uniform(_scenario.Seed, RandomStream.Generator, shooter * 1000003L + n, what);
    }
}
