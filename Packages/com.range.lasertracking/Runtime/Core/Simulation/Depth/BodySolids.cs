using System;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>One shooter as solids in camera 1's space: torso, head, arms, hands, legs and the weapon.</summary>
    internal static class BodySolids
    {
        /// <summary>Solids of one body.</summary>
        public const int Count = 12;

        /// <summary>Share of pixels lost on the weapon: dark steel returns little light.</summary>
        private const float WeaponLost = 0.25f;

        /// <summary>Fills the solids; handLost is the share of pixels lost on the weapon hand in this frame.</summary>
        public static void Build(in BodyPose body, Vector3D feetM, double side, HandCamera camera, float handLost, Span<DepthSolid> solids)
        {
            var x = new Vector3D(1, 0, 0);
            var y = new Vector3D(0, 1, 0);
            var z = new Vector3D(0, 0, 1);
            TrueHand hand = body.Weapon;
            Vector3D trunk = (body.NeckM + body.HipM) * 0.5, up = (body.NeckM - body.HipM).Normalized;
            double half = (body.NeckM - body.HipM).Length / 2 + 0.08;
            Vector3D across = (body.ShoulderAxis - up * Vector3D.Dot(body.ShoulderAxis, up)).Normalized;
            Vector3D deep = Vector3D.Cross(across, up);
            int n = 0;
            solids[n++] = Ellipsoid(camera, trunk, across * 0.215, up * half, deep * 0.13, 0);
            solids[n++] = Ellipsoid(camera, body.HeadM, x * 0.078, y * 0.12, z * 0.1, 0);
            solids[n++] = Capsule(camera, body.SupportShoulderM, hand.ShoulderM, 0.055);
            solids[n++] = Capsule(camera, hand.ShoulderM, hand.ElbowM, 0.05);
            solids[n++] = Capsule(camera, hand.ElbowM, hand.WristM, 0.037);
            solids[n++] = Capsule(camera, body.SupportShoulderM, body.SupportElbowM, 0.05);
            solids[n++] = Capsule(camera, body.SupportElbowM, body.SupportWristM, 0.037);
            solids[n++] = Capsule(camera, body.HipM + new Vector3D(0.1, 0.05, 0), feetM + new Vector3D(0.14, 0, 0), 0.075);
            solids[n++] = Capsule(camera, body.HipM + new Vector3D(-0.1, 0.05, 0), feetM + new Vector3D(-0.14, 0, 0), 0.075);
            solids[n++] = Hand(camera, hand.WristM, hand.PalmM, handLost);
            solids[n++] = Hand(camera, body.SupportWristM, body.SupportPalmM, 0);
            // The slide: its front face is the muzzle.
            Vector3D barrel = hand.BarrelDirection;
            Vector3D right = Vector3D.Cross(y, barrel).Normalized, down = Vector3D.Cross(barrel, right);
            solids[n] = Box(camera, hand.MuzzleM - barrel * 0.095 + down * 0.004, right * 0.014, down * 0.018, barrel * 0.095);
        }

        private static DepthSolid Hand(HandCamera camera, Vector3D wrist, Vector3D palm, float lost)
        {
            Vector3D along = (palm - wrist).Normalized;
            Vector3D across = Vector3D.Cross(new Vector3D(0, 1, 0), along);
            across = across.Length > 1e-6 ? across.Normalized : new Vector3D(1, 0, 0);
            return Ellipsoid(camera, palm, along * 0.072, across * 0.042, Vector3D.Cross(along, across) * 0.05, lost);
        }

        private static DepthSolid Capsule(HandCamera camera, Vector3D a, Vector3D b, double radiusM) =>
            DepthSolid.Capsule(camera.ToCameraMm(a), camera.ToCameraMm(b), radiusM * 1000);

        private static DepthSolid Ellipsoid(HandCamera camera, Vector3D center, Vector3D halfX, Vector3D halfY, Vector3D halfZ, float lost) =>
            DepthSolid.Ellipsoid(camera.ToCameraMm(center), Turn(camera, halfX), Turn(camera, halfY), Turn(camera, halfZ), lost);

        private static DepthSolid Box(HandCamera camera, Vector3D center, Vector3D halfX, Vector3D halfY, Vector3D halfZ) =>
            DepthSolid.Box(camera.ToCameraMm(center), Turn(camera, halfX), Turn(camera, halfY), Turn(camera, halfZ), WeaponLost);

        private static Vector3D Turn(HandCamera camera, Vector3D m) => camera.PoseInScreenMm.InverseTransformDirection(m) * 1000;
    }
}
