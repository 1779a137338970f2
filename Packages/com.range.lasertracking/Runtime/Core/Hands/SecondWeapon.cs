using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Another weapon within what the grid shows as one arm: arms of neighbours that cross touch in the picture and are one part there.
    /// Looks for what reaches out farthest besides the arm already found and is a weapon by its pixels.
    /// </summary>
    internal static class SecondWeapon
    {
        /// <summary>So near the line of the arm already found it is that arm.</summary>
        private const double ClearMm = 110;

        /// <summary>How far behind its palm that arm goes on.</summary>
        private const double ArmMm = 450;

        /// <summary>How many places that reach out are looked at, and what belongs to one of them.</summary>
        private const int Candidates = 4;
        private const double DismissedMm = 60;

        /// <summary>False where there is none.</summary>
        /// <param name="grid">Of the frame.</param>
        /// <param name="cells">Of the part.</param>
        /// <param name="first">The arm already found in it.</param>
        /// <param name="people">Who stands where.</param>
        /// <param name="upright">Where the screen is.</param>
        /// <param name="settings">Sizes.</param>
        /// <param name="fit">Its muzzle, and its palm as of a pistol that is aimed.</param>
        public static bool TryFind(DepthGrid grid, ReadOnlySpan<int> cells, in ArmFit first, PersonSet people, UprightFrame upright, DepthHandSettings settings, out ArmFit fit)
        {
            fit = default;
            Span<Vector3D> dismissed = stackalloc Vector3D[Candidates];
            for (int i = 0; i < Candidates; i++)
            {
                if (!TryForemost(grid, cells, first, upright, dismissed.Slice(0, i), out Vector3D end))
                    return false;
                dismissed[i] = end;
                if (people.TryReach(end, first.PersonId, out int person, out Vector3D eye)
                    && WeaponTip.TryRefine(grid, (end - eye).Normalized, ref end, out double spread) && spread < settings.MaxWeaponSpreadMm
                    && Distance(end, first.MuzzleMm, first.PalmMm) >= ClearMm)
                {
                    Vector3D direction = WeaponTip.Direction(grid, end);
                    if (direction.LengthSquared > 0 && people.TryOwner(end, direction, person, out int owner, out Vector3D ownEye))
                        (person, eye) = (owner, ownEye);
                    fit.MuzzleMm = end;
                    GiveTo(person, eye, upright, settings, ref fit);
                    fit.WeaponDirection = direction;
                    return true;
                }
            }

            return false;
        }

        private static bool TryForemost(DepthGrid grid, ReadOnlySpan<int> cells, in ArmFit first, UprightFrame upright, ReadOnlySpan<Vector3D> dismissed, out Vector3D end)
        {
            Vector3D back = first.Axis.LengthSquared > 0 ? first.PalmMm - first.Axis * ArmMm : first.PalmMm;
            end = default;
            double nearest = double.MaxValue;
            for (int i = 0; i < cells.Length; i++)
            {
                Vector3D point = grid.Point(cells[i]);
                double away = Vector3D.Dot(point, upright.Away);
                if (away >= nearest || Distance(point, first.MuzzleMm, first.PalmMm) < ClearMm || Distance(point, first.PalmMm, back) < ClearMm
                    || IsNear(point, dismissed))
                    continue;
                nearest = away;
                end = point;
            }

            return nearest < double.MaxValue;
        }

        private static bool IsNear(Vector3D point, ReadOnlySpan<Vector3D> others)
        {
            foreach (Vector3D other in others)
            {
                if ((point - other).LengthSquared < DismissedMm * DismissedMm)
                    return true;
            }

            return false;
        }

        /// <summary>All but the muzzle: as of whoever aims over it.</summary>
        public static void GiveTo(int person, Vector3D eye, UprightFrame upright, DepthHandSettings settings, ref ArmFit fit)
        {
            Vector3D aim = (fit.MuzzleMm - eye).Normalized;
            fit.HasWeapon = true;
            fit.MuzzleSigmaMm = settings.SeenMuzzleSigmaMm;
            Vector3D up = (upright.Up - aim * Vector3D.Dot(upright.Up, aim)).Normalized;
            fit.PalmMm = fit.SurfaceMm = fit.MuzzleMm - aim * settings.GripToMuzzleMm - up * settings.BoreAboveGripMm;
            fit.PalmSigmaMm = 2 * settings.PalmSigmaMm;
            fit.AxisSigmaRad = settings.TwoArmsSigmaRad;
            fit.Sight = aim;
            fit.PersonId = person;
        }

        private static double Distance(Vector3D point, Vector3D a, Vector3D b)
        {
            Vector3D along = b - a;
            double t = along.LengthSquared > 0 ? Math.Max(0, Math.Min(1, Vector3D.Dot(point - a, along) / along.LengthSquared)) : 0;
            return (point - a - along * t).Length;
        }
    }
}
