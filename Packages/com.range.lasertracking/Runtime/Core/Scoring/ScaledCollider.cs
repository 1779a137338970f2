using System;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// A collider after its object's scale, in the object's axes and in metres, and where a ray in those axes enters it. The rules
    /// of scale are Unity's: a sphere takes the largest component, a capsule the larger of the two across its axis.
    /// </summary>
    internal readonly struct ScaledCollider
    {
        private readonly ColliderShape _shape;
        private readonly Vector3D _center;

        // Box: half edges. Quad: half edges in x and y, z the sign of its front normal. Capsule: see _axis.
        private readonly Vector3D _half;
        private readonly double _radius;
        private readonly double _halfSegment;
        private readonly int _axis;
        private readonly bool _isOnChild;
        private readonly Pose _child;

        public ScaledCollider(in SceneCollider collider, Vector3D objectScale, int objectIndex)
        {
            ObjectIndex = objectIndex;
            _isOnChild = collider.IsOnChild;
            _child = collider.ChildPose;
            Vector3D scale = _isOnChild ? collider.ChildScale : objectScale;
            _shape = collider.Shape;
            _axis = collider.Axis;
            _center = Vector3D.Scale(collider.Center, scale);
            var absolute = new Vector3D(Math.Abs(scale.X), Math.Abs(scale.Y), Math.Abs(scale.Z));
            _half = Vector3D.Scale(collider.Size, absolute) * 0.5;
            _radius = 0;
            _halfSegment = 0;
            switch (_shape)
            {
                case ColliderShape.Sphere:
                    _radius = collider.Radius * Math.Max(absolute.X, Math.Max(absolute.Y, absolute.Z));
                    break;
                case ColliderShape.Capsule:
                    Vector3D turned = AxisToY(absolute, _axis);
                    _radius = collider.Radius * Math.Max(turned.X, turned.Z);
                    _halfSegment = Math.Max(0, collider.Height * turned.Y / 2 - _radius);
                    break;
                case ColliderShape.Quad:
                    // A mirrored depth turns the front round, mirrored width or height do not: normals go with the inverse scale.
                    _half = new Vector3D(absolute.X / 2, absolute.Y / 2, scale.Z < 0 ? 1 : -1);
                    break;
            }
        }

        public int ObjectIndex { get; }

        /// <summary>True when the ray enters from outside at a distance above zero; the direction is a unit vector.</summary>
        public bool TryRaycast(Vector3D origin, Vector3D direction, out double distance, out Vector3D normal)
        {
            if (!_isOnChild)
                return TryRaycastOwn(origin, direction, out distance, out normal);
            bool found = TryRaycastOwn(_child.InverseTransformPoint(origin), _child.InverseTransformDirection(direction), out distance, out normal);
            normal = _child.TransformDirection(normal);
            return found;
        }

        private bool TryRaycastOwn(Vector3D origin, Vector3D direction, out double distance, out Vector3D normal)
        {
            Vector3D from = origin - _center;
            switch (_shape)
            {
                case ColliderShape.Box:
                    return TryBox(from, direction, out distance, out normal);
                case ColliderShape.Sphere:
                    normal = default;
                    if (!TrySphere(from, direction, _radius, out distance))
                        return false;
                    normal = (from + direction * distance).Normalized;
                    return true;
                case ColliderShape.Capsule:
                    return TryCapsule(from, direction, out distance, out normal);
                default:
                    return TryQuad(from, direction, out distance, out normal);
            }
        }

        private bool TryBox(Vector3D from, Vector3D direction, out double distance, out Vector3D normal)
        {
            double enter = double.NegativeInfinity, exit = double.PositiveInfinity;
            normal = default;
            distance = 0;
            if (!Slab(from.X, direction.X, _half.X, new Vector3D(1, 0, 0), ref enter, ref exit, ref normal)
                || !Slab(from.Y, direction.Y, _half.Y, new Vector3D(0, 1, 0), ref enter, ref exit, ref normal)
                || !Slab(from.Z, direction.Z, _half.Z, new Vector3D(0, 0, 1), ref enter, ref exit, ref normal))
                return false;
            distance = enter;
            return enter <= exit && enter > 0;
        }

        private static bool Slab(double from, double direction, double half, Vector3D axis, ref double enter, ref double exit, ref Vector3D normal)
        {
            if (direction == 0)
                return Math.Abs(from) <= half;
            double near = (-half - from) / direction, far = (half - from) / direction;
            if (direction < 0)
                (near, far) = (far, near);
            if (near > enter)
            {
                enter = near;
                normal = axis * (direction > 0 ? -1 : 1);
            }

            exit = Math.Min(exit, far);
            return true;
        }

        private static bool TrySphere(Vector3D from, Vector3D direction, double radius, out double distance)
        {
            // From the foot of the perpendicular: no difference of large squares when the sphere is far away.
            double along = -Vector3D.Dot(from, direction);
            double chord = radius * radius - (from + direction * along).LengthSquared;
            distance = 0;
            if (chord < 0 || from.LengthSquared <= radius * radius)
                return false;
            distance = along - Math.Sqrt(chord);
            return distance > 0;
        }

        private bool TryCapsule(Vector3D from, Vector3D direction, out double distance, out Vector3D normal)
        {
            Vector3D o = AxisToY(from, _axis), d = AxisToY(direction, _axis);
            distance = double.PositiveInfinity;
            normal = default;
            double insideY = o.Y - Math.Max(-_halfSegment, Math.Min(_halfSegment, o.Y));
            if (o.X * o.X + insideY * insideY + o.Z * o.Z <= _radius * _radius)
                return false;

            double across = d.X * d.X + d.Z * d.Z;
            if (across > 0)
            {
                double along = -(o.X * d.X + o.Z * d.Z) / across;
                double x = o.X + d.X * along, z = o.Z + d.Z * along;
                double chord = (_radius * _radius - x * x - z * z) / across;
                double t = chord >= 0 ? along - Math.Sqrt(chord) : -1;
                if (t > 0 && Math.Abs(o.Y + d.Y * t) <= _halfSegment)
                    distance = t;
            }

            for (int end = -1; end <= 1; end += 2)
            {
                var cap = new Vector3D(o.X, o.Y - end * _halfSegment, o.Z);
                if (TrySphere(cap, d, _radius, out double t) && end * (cap.Y + d.Y * t) >= 0)
                    distance = Math.Min(distance, t);
            }

            if (double.IsPositiveInfinity(distance))
                return false;
            Vector3D point = o + d * distance;
            double nearestY = Math.Max(-_halfSegment, Math.Min(_halfSegment, point.Y));
            normal = YToAxis(new Vector3D(point.X, point.Y - nearestY, point.Z).Normalized, _axis);
            return true;
        }

        private bool TryQuad(Vector3D from, Vector3D direction, out double distance, out Vector3D normal)
        {
            normal = new Vector3D(0, 0, _half.Z);
            distance = 0;
            if (direction.Z * _half.Z >= 0)
                return false;
            distance = -from.Z / direction.Z;
            return distance > 0 && Math.Abs(from.X + direction.X * distance) <= _half.X
                && Math.Abs(from.Y + direction.Y * distance) <= _half.Y;
        }

        // Cyclic, so that no axis is mirrored.
        private static Vector3D AxisToY(Vector3D v, int axis) =>
            axis == 0 ? new Vector3D(v.Z, v.X, v.Y) : axis == 1 ? v : new Vector3D(v.Y, v.Z, v.X);

        private static Vector3D YToAxis(Vector3D v, int axis) =>
            axis == 0 ? new Vector3D(v.Y, v.Z, v.X) : axis == 1 ? v : new Vector3D(v.Z, v.X, v.Y);
    }
}
