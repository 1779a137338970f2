using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Measures one arm: its axis from forearm to hand, the hand as what lies within a hand's length of the front end, the muzzle as
    /// the end of a narrow part before it or, unseen, at a fixed distance along the axis.
    /// </summary>
    internal sealed class ArmFitter
    {
        private const double BinMm = 10;
        private const int Bins = 128;

        private readonly DepthHandSettings _settings;
        private readonly double[] _binArea = new double[Bins];
        private readonly double[] _binLowA = new double[Bins];
        private readonly double[] _binHighA = new double[Bins];
        private readonly double[] _binLowB = new double[Bins];
        private readonly double[] _binHighB = new double[Bins];
        private Vector3D[] _points = Array.Empty<Vector3D>();
        private double[] _areas = Array.Empty<double>();
        private readonly UprightFrame _upright;
        private Vector3D _anchor;
        private int _count;
        private double _cellMm;

        public ArmFitter(DepthHandSettings settings, UprightFrame upright)
        {
            _settings = settings;
            _upright = upright;
        }

        /// <summary>False when the part has not the shape of an arm with a hand.</summary>
        public bool TryFit(DepthGrid grid, ReadOnlySpan<int> cells, in ArmPart part, out ArmFit fit)
        {
            fit = default;
            Load(grid, cells);
            Vector3D axis = FirstAxis(part, out bool isClear);
            double front = 0, handStart = 0, handEnd = 0;
            Vector3D hand = default, rear = default;
            bool hasRear = false, hasWeapon = false;
            for (int pass = 0; pass < 3; pass++)
            {
                front = Front(axis, out handStart);
                double weapon = front - handStart;
                hasWeapon = weapon > 3 * BinMm + _settings.HandLengthMm / 6 && weapon <= _settings.MaxWeaponMm;
                if (hasWeapon)
                {
                    // A fist: shorter than a hand.
                    handEnd = handStart - 0.6 * _settings.HandLengthMm;
                    fit.HandAreaMm2 = Mean(axis, handEnd, handStart + 1, out hand);
                }
                else
                {
                    handEnd = front - _settings.HandLengthMm;
                    fit.HandAreaMm2 = MeanAround(axis, front, out hand);
                }

                if (!(fit.HandAreaMm2 > 0))
                    return false;
                _anchor = hand;
                double rearArea = Mean(axis, handEnd - _settings.ForearmLengthMm, handEnd, out rear);
                hasRear = rearArea > _settings.MinArmAreaMm2 / 2 && (hand - rear).Length > 0.5 * _settings.HandLengthMm;
                if (!hasRear)
                    break;
                axis = (Inside(hand, default, 0.5 * _settings.MinHandWidthMm) - Inside(rear, axis, _settings.ForearmRadiusMm)).Normalized;
                isClear = true;
            }

            if (fit.HandAreaMm2 > _settings.MaxHandAreaMm2)
                return false;
            Vector3D palm = hand + hand.Normalized * _settings.HandHalfThicknessMm;
            fit.PalmMm = fit.SurfaceMm = palm;
            fit.PalmSigmaMm = _settings.PalmSigmaMm;
            fit.HasSurface = true;
            fit.HasOneRoot = part.HasOneRoot;
            fit.Axis = isClear ? axis : default;
            fit.AxisSigmaRad = hasRear ? 1.5 * _settings.PalmSigmaMm / (hand - rear).Length : 0.3;
            if (!part.HasOneRoot)
                fit.AxisSigmaRad = Math.Sqrt(Square(fit.AxisSigmaRad) + Square(_settings.TwoArmsSigmaRad));
            if (hasRear)
                FitLine(axis, handEnd - _settings.ForearmLengthMm, handEnd, rear, ref fit);
            Muzzle(grid, axis, isClear, part, ref fit);
            if (IsCut(grid, hand + axis * (front - Vector3D.Dot(hand, axis)), axis))
                fit.MuzzleSigmaMm = Math.Max(fit.MuzzleSigmaMm, _settings.CutSigmaMm);
            fit.Side = ArmSide.Of(part, _settings);
            fit.PersonId = part.PersonId;
            if (isClear && IsHole(grid, hand, axis, front, out Vector3D holeRay))
                BridgeHand(axis, front, holeRay, ref fit);
            fit.Sight = part.HasEye ? (fit.MuzzleMm - part.EyeMm).Normalized : default;
            return true;
        }

        /// <summary>
        /// From the visible surface into the limb: away from the camera, for a long limb at right angles to its axis. Without this
        /// an arm that points near the camera seems turned, because hand and forearm show different sides.
        /// </summary>
        private static Vector3D Inside(Vector3D surface, Vector3D axis, double radiusMm)
        {
            Vector3D ray = surface.Normalized;
            return surface + (ray - axis * Vector3D.Dot(ray, axis)).Normalized * radiusMm;
        }

        private void Load(DepthGrid grid, ReadOnlySpan<int> cells)
        {
            if (_points.Length < cells.Length)
            {
                _points = new Vector3D[grid.Z.Length];
                _areas = new double[grid.Z.Length];
            }

            _count = cells.Length;
            double sum = 0;
            for (int i = 0; i < cells.Length; i++)
            {
                _points[i] = grid.Point(cells[i]);
                _areas[i] = grid.Area(cells[i]);
                sum += _areas[i];
            }

            _cellMm = Math.Sqrt(sum / _count);
        }

        /// <summary>From the middle of the farthest part to the middle of the nearest: the screen, and so the hand, is on the near side.</summary>
        private Vector3D FirstAxis(in ArmPart part, out bool isClear)
        {
            double near = double.MaxValue, far = 0;
            for (int i = 0; i < _count; i++)
            {
                near = Math.Min(near, _points[i].Z);
                far = Math.Max(far, _points[i].Z);
            }

            double band = Math.Max(20, 0.15 * (far - near));
            Vector3D nearSum = default, farSum = default;
            double nearArea = 0, farArea = 0;
            for (int i = 0; i < _count; i++)
            {
                if (_points[i].Z <= near + band)
                {
                    nearSum += _points[i] * _areas[i];
                    nearArea += _areas[i];
                }

                if (_points[i].Z >= far - band)
                {
                    farSum += _points[i] * _areas[i];
                    farArea += _areas[i];
                }
            }

            _anchor = nearSum * (1 / nearArea);
            Vector3D difference = _anchor - farSum * (1 / farArea);
            // An arm across the line of sight has no end that is clearly nearer.
            isClear = far - near > 0.35 * _settings.HandLengthMm && difference.Length > 0.5 * _settings.HandLengthMm;
            return difference.Length > 1 ? difference.Normalized : new Vector3D(0, 0, -1);
        }

        /// <summary>Position along the axis of the front end, and of the place where it becomes as wide as a hand.</summary>
        private double Front(Vector3D axis, out double handStart)
        {
            double top = double.MinValue;
            for (int i = 0; i < _count; i++)
            {
                if (IsAlong(i, axis, out double s))
                    top = Math.Max(top, s);
            }

            Vector3D a = Vector3D.Cross(axis, Math.Abs(axis.Y) < 0.8 ? new Vector3D(0, 1, 0) : new Vector3D(1, 0, 0)).Normalized;
            Vector3D b = Vector3D.Cross(axis, a);
            for (int k = 0; k < Bins; k++)
            {
                _binArea[k] = 0;
                _binLowA[k] = _binLowB[k] = double.MaxValue;
                _binHighA[k] = _binHighB[k] = double.MinValue;
            }

            for (int i = 0; i < _count; i++)
            {
                if (!IsAlong(i, axis, out double s))
                    continue;
                int k = (int)((top - s) / BinMm);
                if (k >= Bins)
                    continue;
                double pa = Vector3D.Dot(_points[i], a), pb = Vector3D.Dot(_points[i], b);
                _binArea[k] += _areas[i];
                _binLowA[k] = Math.Min(_binLowA[k], pa);
                _binHighA[k] = Math.Max(_binHighA[k], pa);
                _binLowB[k] = Math.Min(_binLowB[k], pb);
                _binHighB[k] = Math.Max(_binHighB[k], pb);
            }

            // A single stray cell is not the front end.
            double needed = 1.5 * _cellMm * _cellMm, gathered = 0;
            int first = 0;
            while (first < Bins - 1 && (gathered += _binArea[first]) < needed)
                first++;
            int wide = first;
            while (wide < Bins - 1 && !(Math.Max(_binHighA[wide] - _binLowA[wide], _binHighB[wide] - _binLowB[wide]) + _cellMm
                                        >= _settings.MinHandWidthMm))
                wide++;
            handStart = top - wide * BinMm;
            return top - first * BinMm;
        }

        /// <summary>Position along the axis; false for what lies too far beside the line through the hand to be this arm.</summary>
        private bool IsAlong(int i, Vector3D axis, out double s)
        {
            s = Vector3D.Dot(_points[i], axis);
            Vector3D d = _points[i] - _anchor;
            double along = Vector3D.Dot(d, axis), limit = _settings.HandLengthMm;
            return d.LengthSquared - along * along <= limit * limit;
        }

        private double Mean(Vector3D axis, double from, double to, out Vector3D mean)
        {
            Vector3D sum = default;
            double area = 0;
            for (int i = 0; i < _count; i++)
            {
                if (!IsAlong(i, axis, out double s) || s < from || s > to)
                    continue;
                sum += _points[i] * _areas[i];
                area += _areas[i];
            }

            mean = area > 0 ? sum * (1 / area) : default;
            return area;
        }

        /// <summary>Middle of what lies within a hand's length of the tip, whichever way the hand is bent.</summary>
        private double MeanAround(Vector3D axis, double front, out Vector3D mean)
        {
            Mean(axis, front - 1.5 * BinMm, front + 1, out Vector3D tip);
            double limit = _settings.HandLengthMm * _settings.HandLengthMm;
            Vector3D sum = default;
            double area = 0;
            for (int i = 0; i < _count; i++)
            {
                if ((_points[i] - tip).LengthSquared > limit)
                    continue;
                sum += _points[i] * _areas[i];
                area += _areas[i];
            }

            mean = area > 0 ? sum * (1 / area) : default;
            return area;
        }

        /// <summary>Principal axis of the cells between two positions, by power iteration from the axis.</summary>
        private void FitLine(Vector3D axis, double from, double to, Vector3D middle, ref ArmFit fit)
        {
            double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, area = 0;
            for (int i = 0; i < _count; i++)
            {
                if (!IsAlong(i, axis, out double s) || s < from || s > to)
                    continue;
                Vector3D d = _points[i] - middle;
                double w = _areas[i];
                area += w;
                xx += w * d.X * d.X;
                xy += w * d.X * d.Y;
                xz += w * d.X * d.Z;
                yy += w * d.Y * d.Y;
                yz += w * d.Y * d.Z;
                zz += w * d.Z * d.Z;
            }

            Vector3D v = axis;
            double length = 0;
            for (int step = 0; step < 16; step++)
            {
                var next = new Vector3D(xx * v.X + xy * v.Y + xz * v.Z, xy * v.X + yy * v.Y + yz * v.Z, xz * v.X + yz * v.Y + zz * v.Z);
                length = next.Length;
                if (!(length > 0))
                    return;
                v = next * (1 / length);
            }

            if (Math.Sqrt(length / area) < 0.15 * _settings.ForearmLengthMm)
                return;
            fit.LinePointMm = middle;
            fit.LineDirection = v;
        }

        /// <summary>
        /// The end of a narrow part before the hand, or a pistol's length along the line of fire. A muzzle that is seen tells how far
        /// back the palm is, as of a fist only the front is seen, and where two hands on one weapon are seen as one between them all of it.
        /// </summary>
        private void Muzzle(DepthGrid grid, Vector3D axis, bool isClear, in ArmPart part, ref ArmFit fit)
        {
            bool hasAim = TryAim(axis, isClear, part, fit, out Vector3D aim, out double aimSigma);
            bool isSeen = TryWeapon(axis, fit.PalmMm, out Vector3D end) || (hasAim && TryWeapon(aim, fit.PalmMm, out end));
            if (isSeen || (hasAim && TryFront(aim, fit.PalmMm, out end, out _)))
            {
                // A weapon that is too few cells wide to be told from the fist is known by its pixels.
                bool isFine = WeaponTip.TryRefine(grid, hasAim ? aim : axis, ref end, out double spread);
                isSeen |= isFine && spread < _settings.MaxWeaponSpreadMm;
                fit.MuzzleSigmaMm = isFine ? _settings.SeenMuzzleSigmaMm : 2 * _settings.SeenMuzzleSigmaMm;
            }

            bool isCovered = isSeen && WeaponTip.IsCovered(grid, hasAim ? aim : axis, end);
            if (isSeen && !isCovered)
            {
                fit.MuzzleMm = end;
                fit.HasWeapon = true;
                fit.WeaponDirection = WeaponTip.Direction(grid, end);
                if (!hasAim)
                    return;
                Vector3D grip = fit.MuzzleMm - aim * _settings.GripToMuzzleMm - BoreAboveGrip(aim);
                fit.PalmMm = part.HasOneRoot ? fit.SurfaceMm + aim * Vector3D.Dot(grip - fit.SurfaceMm, aim) : grip;
                fit.PalmSigmaMm = Math.Sqrt(_settings.PalmSigmaMm * _settings.PalmSigmaMm + Square(_settings.GripToMuzzleMm * aimSigma));
                return;
            }

            double beyond = _settings.MuzzleBeyondPalmMm;
            hasAim &= Vector3D.Dot(aim, _upright.Away) < 0;
            fit.MuzzleMm = hasAim ? fit.PalmMm + aim * beyond + BoreAboveGrip(aim) : fit.PalmMm;
            fit.MuzzleSigmaMm = isCovered ? _settings.CutSigmaMm : Math.Sqrt(Square(_settings.MuzzleSigmaMm) + Square(beyond * (hasAim ? aimSigma : 1)));
        }

        /// <summary>
        /// The line of fire from what is seen of it: the forearm's axis and the line from the eyes over the weapon, weighted by their
        /// variances. Of two arms on one weapon neither points where it points.
        /// </summary>
        private bool TryAim(Vector3D axis, bool isClear, in ArmPart part, in ArmFit fit, out Vector3D aim, out double sigmaRad)
        {
            double arm = 1 / (Square(_settings.WristSigmaRad) + Square(fit.AxisSigmaRad));
            aim = axis;
            sigmaRad = fit.AxisSigmaRad;
            if (!part.HasEye)
                return isClear;
            Vector3D sight = fit.PalmMm + _upright.Up * _settings.BoreAboveGripMm - part.EyeMm;
            double eyes = Square(sight.Length / _settings.EyeSigmaMm);
            double weight = isClear && Vector3D.Dot(axis, sight) > 0 ? arm : 0;
            aim = (sight.Normalized * eyes + axis * weight).Normalized;
            sigmaRad = Math.Sqrt(1 / (eyes + weight));
            return true;
        }

        private bool TryWeapon(Vector3D axis, Vector3D palm, out Vector3D end)
        {
            bool isFront = TryFront(axis, palm, out end, out double weapon);
            // From the middle of the last 20 mm to their end, less what noise makes the foremost cell too near.
            end += axis * (0.5 * BinMm);
            return isFront && weapon > 3 * BinMm + _settings.HandLengthMm / 6 && weapon <= _settings.MaxWeaponMm;
        }

        private bool TryFront(Vector3D axis, Vector3D palm, out Vector3D end, out double weapon)
        {
            double front = Front(axis, out double handStart);
            weapon = front - handStart;
            return Mean(axis, front - 2 * BinMm, front + 1, out end) > 0 && IsBefore(end, palm);
        }

        private static double Square(double value) => value * value;

        /// <summary>Weapons point to the screen: a narrow end that is no nearer to it than the hand is an elbow or a cuff.</summary>
        private bool IsBefore(Vector3D end, Vector3D palm) => Vector3D.Dot(palm - end, _upright.Away) > 0.25 * _settings.MuzzleBeyondPalmMm;

        private Vector3D BoreAboveGrip(Vector3D axis) => (_upright.Up - axis * Vector3D.Dot(_upright.Up, axis)).Normalized * _settings.BoreAboveGripMm;

        /// <summary>True when most of what lies before the front end has no depth at all; the middle of that, as a ray (z = 1).</summary>
        private bool IsHole(DepthGrid grid, Vector3D hand, Vector3D axis, double front, out Vector3D ray)
        {
            Vector3D tip = hand + axis * (front - Vector3D.Dot(hand, axis));
            double half = _settings.HandLengthMm / 2;
            ray = default;
            if (!HoleProbe.IsHole(grid, tip + axis * (0.8 * half), 0.6 * half, _settings.LostShare))
                return false;
            return HoleProbe.Measure(grid, tip + axis * half, 1.2 * half, out _, out ray);
        }

        /// <summary>True when the front end lies at the edge of what the camera sees: the hand may well be beyond.</summary>
        private bool IsCut(DepthGrid grid, Vector3D tip, Vector3D axis)
        {
            double radius = 0.25 * _settings.HandLengthMm;
            return !HoleProbe.Measure(grid, tip + axis * radius, radius, out double share, out _) || HoleProbe.IsNearBorder(grid, tip, radius)
                || (share > _settings.LostShare && HoleProbe.Measure(grid, tip + axis * (4 * radius), 3 * radius, out double around, out _)
                    && around > _settings.LostShare);
        }

        private void BridgeHand(Vector3D axis, double front, Vector3D holeRay, ref ArmFit fit)
        {
            Mean(axis, front - _settings.ForearmLengthMm, front + 1, out Vector3D middle);
            fit.LineDirection = default;
            FitLine(axis, front - _settings.ForearmLengthMm, front + 1, middle, ref fit);
            fit.IsHandLost = true;
            Vector3D tip = middle + axis * (front - Vector3D.Dot(middle, axis));
            double z = tip.Z + axis.Z * _settings.HandLengthMm / 2;
            if (ArmFit.TryLineDepth(fit, holeRay, out double onLine))
                z = onLine;
            fit.PalmMm = fit.SurfaceMm = holeRay * (z + _settings.HandHalfThicknessMm);
            fit.MuzzleMm = fit.PalmMm + axis * _settings.MuzzleBeyondPalmMm + BoreAboveGrip(axis);
            fit.PalmSigmaMm *= 3;
            fit.MuzzleSigmaMm = Math.Sqrt(fit.MuzzleSigmaMm * fit.MuzzleSigmaMm + fit.PalmSigmaMm * fit.PalmSigmaMm);
        }
    }
}
