using LaserTracking.Geometry;
using LaserTracking.Scoring;
using LaserTracking.Session;
using UnityEngine;
using Pose = LaserTracking.Geometry.Pose;
using RaycastHit = LaserTracking.Scoring.RaycastHit;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Casts shots that have a place on the screen into the scene, and keeps what is needed to draw them. The only place where a shot
    /// becomes a hit, whatever it came from. Main thread.
    /// </summary>
    internal sealed class ShotCaster
    {
        private readonly ScreenSurface _screen;
        private readonly Transform _viewpoint;
        private readonly PhysicsRaycaster _raycaster;
        private readonly ShotScorerSettings _settings;
        private ShotScorer? _scorer;
        private Pose _surface;
        private Vector2D _sizeM;
        private Vector3D _eye;

        public ShotCaster(ScreenSurface screen, Transform viewpoint, LayerMask hitLayers, AimRay aim)
        {
            _screen = screen;
            _viewpoint = viewpoint;
            _raycaster = new PhysicsRaycaster(hitLayers);
            _settings = new ShotScorerSettings(aim);
        }

        /// <summary>Completes the shot and says how it flew.</summary>
        /// <param name="shot">With a place on the screen.</param>
        /// <param name="sceneTimeS">When the light left, on the scene's clock.</param>
        public ShotTrace Cast(ref ShotEvent shot, double sceneTimeS)
        {
            ShotScorer scorer = CurrentScorer();
            Vector3D? muzzleM = shot.HasMuzzle ? shot.MuzzleM : (Vector3D?)null;
            _raycaster.Forget();
            shot.HasHit = scorer.TryScore(shot.ScreenM, shot.ScreenCovarianceMm2, shot.Shot.Dot.Confidence, muzzleM, sceneTimeS, out shot.Hit);

            Vector3D dot = _screen.ScreenToWorld(new Vector3D(shot.ScreenM.X, shot.ScreenM.Y, 0));
            Vector3D muzzle = muzzleM is Vector3D known ? _screen.ScreenToWorld(known) : _eye;
            Vector3D origin = _settings.Aim == AimRay.Muzzle ? muzzle : _eye;
            var trace = new ShotTrace { Shot = shot, From = muzzle.ToUnity(), OnScreen = dot.ToUnity() };
            if (_raycaster.TryGetLast(out RaycastHit met, out GameObject? owner, out LaserTarget? target))
            {
                trace.End = met.PointM.ToUnity();
                trace.Met = owner!.transform;
                trace.LocalEnd = met.LocalPointM.ToUnity();
                trace.LocalNormal = met.ObjectPose.InverseTransformDirection(met.Normal).ToUnity();
                trace.Target = shot.HasHit ? target : null;
            }
            else
            {
                trace.End = new Ray3D(dot, dot - origin).At(_settings.MaxDistanceM).ToUnity();
            }

            return trace;
        }

        /// <summary>Screen and eye may be moved while it runs; a shot counts as they stand when it is cast.</summary>
        private ShotScorer CurrentScorer()
        {
            Pose surface = _screen.Pose;
            Vector2D sizeM = _screen.SizeM;
            Vector3D eye = _viewpoint.position.ToCore();
            if (_scorer != null && surface.Position.Equals(_surface.Position) && Same(surface.Rotation, _surface.Rotation) && sizeM.Equals(_sizeM) && eye.Equals(_eye))
                return _scorer;
            _surface = surface;
            _sizeM = sizeM;
            _eye = eye;
            return _scorer = new ShotScorer(_raycaster, surface, sizeM, eye, null, _settings);
        }

        private static bool Same(Rotation3D a, Rotation3D b) => a.X == b.X && a.Y == b.Y && a.Z == b.Z && a.W == b.W;
    }
}
