using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// Where one shooter points on the screen as a function of time: on each shot's mark around the shot, swinging smoothly in
    /// between, lowered when nothing is due for long. Tremor and sway are added on top.
    /// </summary>
    internal sealed class AimPath
    {
        private const double SettleS = 0.15;
        private const double FollowThroughS = 0.04;
        private const double SwingS = 0.55;
        private const double RestS = 2.5;

        private readonly SceneView _view;
        private readonly PlannedShot[] _shots;
        private readonly Tremor _tremor;
        private readonly double _distanceM;
        private readonly double _shownDelayS;
        private readonly Vector2D _restM;

        /// <param name="view">The scene as drawn.</param>
        /// <param name="shots">This shooter's, in order of time, not overlapping.</param>
        /// <param name="tremor">This shooter's.</param>
        /// <param name="distanceM">From the weapon to the screen: turns angles into metres.</param>
        /// <param name="shownDelayS">How long ago the scene was as the shooter sees it.</param>
        /// <param name="restM">Point of the screen's plane the lowered weapon points at.</param>
        public AimPath(SceneView view, List<PlannedShot> shots, Tremor tremor, double distanceM, double shownDelayS, Vector2D restM)
        {
            _view = view;
            _shots = shots.ToArray();
            _tremor = tremor;
            _distanceM = distanceM;
            _shownDelayS = shownDelayS;
            _restM = restM;
        }

        /// <summary>Where the light would meet the screen's plane, m in screen space, whether it is on or not.</summary>
        public Vector2D PointM(double timeS) => Steady(timeS) + _tremor.AngleRad(timeS) * _distanceM;

        private Vector2D Steady(double timeS)
        {
            int next = 0;
            while (next < _shots.Length && HoldEnd(next) <= timeS)
                next++;
            if (next < _shots.Length && timeS >= HoldBegin(next))
                return Mark(_shots[next], timeS);

            bool hasLast = next > 0, hasNext = next < _shots.Length;
            double since = hasLast ? timeS - HoldEnd(next - 1) : double.PositiveInfinity;
            double until = hasNext ? HoldBegin(next) - timeS : double.PositiveInfinity;
            if (since + until <= RestS)
            {
                double swing = Math.Min(SwingS, since + until);
                return Blend(Mark(_shots[next - 1], timeS), Mark(_shots[next], timeS), swing > 0 ? 1 - until / swing : 1);
            }

            if (hasNext && until < SwingS)
                return Blend(_restM, Mark(_shots[next], timeS), 1 - until / SwingS);
            return hasLast && since < SwingS + 0.4 ? Blend(Mark(_shots[next - 1], timeS), _restM, (since - 0.4) / SwingS) : _restM;
        }

        private double HoldEnd(int i) => _shots[i].EndS + FollowThroughS;

        private double HoldBegin(int i)
        {
            double begin = _shots[i].StartS - SettleS;
            return i > 0 ? Math.Min(_shots[i].StartS, Math.Max(begin, HoldEnd(i - 1))) : begin;
        }

        private Vector2D Mark(PlannedShot shot, double timeS)
        {
            double sinceStart = Math.Max(-FollowThroughS, Math.Min(shot.EndS - shot.StartS + FollowThroughS, timeS - shot.StartS));
            Vector2D point = shot.Target < 0
                ? shot.PointM
                : _view.TargetToScreen(shot.Target, timeS - _shownDelayS).Map(shot.PointM);
            return point + shot.SweepMPerS * sinceStart;
        }

        // Minimum-jerk: the way a hand goes from one rest to another (Flash and Hogan 1985).
        private static Vector2D Blend(Vector2D from, Vector2D to, double part)
        {
            double t = Math.Max(0, Math.Min(1, part));
            return from + (to - from) * (t * t * t * (10 + t * (-15 + 6 * t)));
        }
    }
}
