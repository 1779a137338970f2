// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    public class BoxCollider : Collider
    {
        public Vector3 center { get; set; }

        public Vector3 size { get; set; } = Vector3.one;

        internal override bool Meets(Vector3 origin, Vector3 direction, out double distance, out Vector3 normal)
        {
            Vector3 from = Pose.ToLocal(origin) - Vector3.Scale(center, Pose.Scale), along = Pose.ToLocalDirection(direction);
            Vector3 extent = Vector3.Scale(size, Pose.Scale) / 2;
            double enter = double.NegativeInfinity, leave = double.PositiveInfinity;
            normal = default;
            distance = 0;
            for (int axis = 0; axis < 3; axis++)
            {
                double half = System.Math.Abs(extent[axis]), a = -half - from[axis], b = half - from[axis];
                if (along[axis] == 0)
                {
                    if (a > 0 || b < 0)
                        return false;
                    continue;
                }

                double near = (along[axis] > 0 ? a : b) / along[axis], far = (along[axis] > 0 ? b : a) / along[axis];
                if (near > enter)
                {
                    enter = near;
                    normal = default;
                    normal[axis] = along[axis] > 0 ? -1 : 1;
                }

                leave = System.Math.Min(leave, far);
            }

            normal = Pose.ToWorldDirection(normal);
            distance = enter;
            return enter >= 0 && enter <= leave;
        }
    }
}
