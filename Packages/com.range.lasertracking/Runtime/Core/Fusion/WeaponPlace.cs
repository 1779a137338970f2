using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// Where somebody's weapon would be if a dot were theirs is known from their line and their reach, and camera 1's picture shows whether something is
    /// there. A weapon that the tracker has not found is hidden behind something, or shown and overlooked; where the picture goes on behind
    /// that place, there is none. Bounded, without allocation.
    /// </summary>
    internal sealed class WeaponPlace
    {
        private enum Sight
        {
            /// <summary>The picture shows what is behind.</summary>
            Free,

            /// <summary>Something stands before it, or nothing was measured.</summary>
            Covered,

            /// <summary>Something is there.</summary>
            Filled,
        }

        /// <summary>Places along the weapon that are looked at: from a little behind the muzzle to behind the fist.</summary>
        private const int Places = 7;
        private const double FirstMm = 30;
        private const double StepMm = 20;

        /// <summary>That many of them tell.</summary>
        private const int FreePlaces = 5;
        private const int FilledPlaces = 3;

        /// <summary>What is so much nearer covers the bore, what is so much farther is behind it: a slide's radius, the sensor's noise and what a line errs.</summary>
        private const double NearerMm = 70;
        private const double FartherMm = 50;

        /// <summary>How far beside its place a weapon still fills it.</summary>
        private const double BesideM = 0.035;

        /// <summary>Probability that the tracker overlooks a weapon that is shown. With it 68 % of those not found are filled places with four shooters, 7 to 12 behind somebody, as seen.</summary>
        private const double OverlookedShare = 0.05;

        /// <summary>Probability of a free place although a weapon is there: somebody stepped aside, a clock is off.</summary>
        private const double WrongShare = 0.02;

        /// <summary>
        /// Other dots, to tell how much of what somebody may aim at lies behind something: columns and rows so far apart, metres, on either side. Over an arm's
        /// length the next one is 0.25 m off: where the arm that aims at this one hardly is.
        /// </summary>
        private const double AsideM = 0.9;
        private const double AboveM = 0.6;
        private const int Columns = 2;
        private const int Rows = 1;

        private readonly HandCamera _camera;
        private readonly SightLines _sights;

        /// <summary>From one of those dots to the next, camera space, mm.</summary>
        private readonly Vector3D _asideMm;
        private readonly Vector3D _aboveMm;

        public WeaponPlace(HandCamera camera, SightLines sights)
        {
            _camera = camera;
            _sights = sights;
            Vector3D origin = camera.ToCameraMm(default);
            _asideMm = camera.ToCameraMm(new Vector3D(AsideM, 0, 0)) - origin;
            _aboveMm = camera.ToCameraMm(new Vector3D(0, AboveM, 0)) - origin;
        }

        /// <summary>
        /// How many times likelier the picture is if a dot is this person's, whose weapon was not found, than if it is not; 1 where nothing tells.
        /// </summary>
        public double Factor(int personId, Vector3D dotM, SeenDepth depth)
        {
            if (!_sights.TryReach(personId, out Vector3D pivot, out double reach, out _)
                || !_sights.TryPivot(personId, dotM - pivot, out _, out double sigma, out _))
                return 1;
            double known = 1 - Math.Exp(-BesideM * BesideM / (2 * sigma * sigma));
            Vector3D pivotMm = _camera.ToCameraMm(pivot), dotMm = _camera.ToCameraMm(dotM);
            double reachMm = reach / Axes.MetresPerMillimetre;
            Sight here = Look(depth, pivotMm, dotMm, reachMm);
            Elsewhere(depth, pivotMm, dotMm, reachMm, out double covered, out double filled);
            double unseen = OverlookedShare * (1 - covered) + covered;
            double factor = here == Sight.Covered ? 1 / unseen
                : here == Sight.Filled ? OverlookedShare * (1 - covered) / (unseen * filled)
                : WrongShare / (1 - covered - filled);
            return known * factor + (1 - known);
        }

        /// <summary>Shares of other places in which the picture shows something before, or there. Neither is ever excluded.</summary>
        private void Elsewhere(SeenDepth depth, Vector3D pivotMm, Vector3D dotMm, double reachMm, out double covered, out double filled)
        {
            int all = 0, near = 0, at = 0;
            for (int row = -Rows; row <= Rows; row++)
            {
                for (int column = -Columns; column <= Columns; column++)
                {
                    if (column == 0)
                        continue;
                    Sight sight = Look(depth, pivotMm, dotMm + _asideMm * column + _aboveMm * row, reachMm);
                    all++;
                    near += sight == Sight.Covered ? 1 : 0;
                    at += sight == Sight.Filled ? 1 : 0;
                }
            }

            covered = (near + 0.5) / (all + 1.5);
            filled = (at + 0.5) / (all + 1.5);
        }

        private static Sight Look(SeenDepth depth, Vector3D pivotMm, Vector3D dotMm, double reachMm)
        {
            Vector3D aim = (dotMm - pivotMm).Normalized, place = pivotMm + aim * (reachMm - FirstMm), step = aim * StepMm;
            int free = 0, filled = 0;
            for (int i = 0; i < Places; i++, place -= step)
            {
                int seen = depth.TowardsMm(place);
                if (seen > place.Z + FartherMm)
                {
                    if (++free == FreePlaces)
                        return Sight.Free;
                }
                else if (seen >= place.Z - NearerMm && seen > 0)
                {
                    filled++;
                }
            }

            return filled >= FilledPlaces ? Sight.Filled : Sight.Covered;
        }
    }
}
