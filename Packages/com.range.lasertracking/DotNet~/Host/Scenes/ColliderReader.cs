using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Host.Scenes
{
    /// <summary>Reads collider components.</summary>
    internal static class ColliderReader
    {
        private const long BuiltInQuad = 10210;
        private const string BuiltInMeshes = "0000000000000000e000000000000000";

        /// <summary>False for a disabled collider. Refuses a shape that the headless raycaster could not answer for as Unity does.</summary>
        public static bool TryRead(UnityComponent component, UnityGameObject owner, out SceneCollider collider)
        {
            UnityFields fields = component.Fields;
            collider = default;
            if (!fields.Flag("m_Enabled"))
                return false;
            if (owner.IsSheared)
                throw fields.Problem("is sheared: a rotated child of an unevenly scaled parent", "give the parent the scale 1 1 1");
            Vector3D scale = owner.Scale;
            if (scale.X == 0 || scale.Y == 0 || scale.Z == 0)
                throw owner.Fields.Problem("has a collider but a scale of zero", "give it a scale");
            bool isTrigger = fields.Flag("m_IsTrigger");
            switch (component.ClassId)
            {
                case UnityClass.BoxCollider:
                    Vector3D size = fields.Vector3("m_Size");
                    if (!(size.X > 0 && size.Y > 0 && size.Z > 0))
                        throw fields.Problem("field m_Size is not above zero in every direction");
                    collider = SceneCollider.Box(fields.Vector3("m_Center"), size, isTrigger);
                    return true;
                case UnityClass.SphereCollider:
                    if (!(Near(scale.X, scale.Y) && Near(scale.X, scale.Z)))
                        throw fields.Problem("a sphere under an uneven scale: what is seen would not be what is hit", "scale it evenly or use a capsule or box");
                    collider = SceneCollider.Sphere(fields.Vector3("m_Center"), Positive(fields, "m_Radius"), isTrigger);
                    return true;
                case UnityClass.CapsuleCollider:
                    int axis = fields.Integer("m_Direction");
                    if (axis is < 0 or > 2)
                        throw fields.Problem($"field m_Direction is {axis}", "use 0 (x), 1 (y) or 2 (z)");
                    collider = SceneCollider.Capsule(fields.Vector3("m_Center"), Positive(fields, "m_Radius"), Positive(fields, "m_Height"), axis, isTrigger);
                    return true;
                default:
                    UnityReference mesh = fields.Reference("m_Mesh");
                    if (mesh.FileId != BuiltInQuad || mesh.Guid != BuiltInMeshes || fields.Flag("m_Convex"))
                        throw fields.Problem("only the built-in Quad, not convex, is read as a mesh", "use box, sphere or capsule colliders");
                    collider = SceneCollider.Quad();
                    return true;
            }
        }

        private static double Positive(UnityFields fields, string field)
        {
            double value = fields.Number(field);
            return value > 0 ? value : throw fields.Problem($"field {field} is not above zero");
        }

        private static bool Near(double a, double b) => System.Math.Abs(System.Math.Abs(a) - System.Math.Abs(b)) <= 1e-4 * System.Math.Abs(a);
    }
}
