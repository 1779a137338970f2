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
        /// <summary>Two seconds at 60 pictures a second, as for what moves.</summary>
        private const int HistoryLength = 128;

        private readonly ScreenSurface _screen;
        private readonly Transform _viewpoint;
        private readonly PhysicsRaycaster _raycaster;
        private readonly ShotScorerSettings _settings;
        private readonly ShotScorer _scorer;
        private readonly PoseHistory _surfaces = new PoseHistory(HistoryLength);
        private readonly PoseHistory _eyes = new PoseHistory(HistoryLength);

        public ShotCaster(ScreenSurface screen, Transform viewpoint, LayerMask hitLayers, AimRay aim)
        {
            _screen = screen;
            _viewpoint = viewpoint;
            _raycaster = new PhysicsRaycaster(hitLayers);
            _settings = new ShotScorerSettings(aim);
            _scorer = new ShotScorer(_raycaster, default, null, _settings);
        }

        /// <summary>Screen and eye may be moved while it runs: a shot goes through them as they stood when its light left.</summary>
        /// <param name="sceneTimeS">Now, on the scene's clock.</param>
        public void RememberView(double sceneTimeS)
        {
            _surfaces.Add(sceneTimeS, _screen.Pose);
            _eyes.Add(sceneTimeS, new Pose(Eye, Rotation3D.Identity));
        }

        /// <summary>Completes the shot and says how it flew.</summary>
        /// <param name="shot">With a place on the screen.</param>
        /// <param name="sceneTimeS">When the light left, on the scene's clock.</param>
        public ShotTrace Cast(ref ShotEvent shot, double sceneTimeS)
        {
            ScreenView view = ViewAt(sceneTimeS);
            Vector3D? muzzleM = shot.HasMuzzle ? shot.MuzzleM : (Vector3D?)null;
            _raycaster.Forget();
            shot.HasHit = _scorer.TryScore(view, shot.ScreenM, shot.ScreenCovarianceMm2, shot.Shot.Dot.Confidence, muzzleM, sceneTimeS, out shot.Hit);

            Vector3D dot = view.ScreenToScene(new Vector3D(shot.ScreenM.X, shot.ScreenM.Y, 0));
            Vector3D muzzle = muzzleM is Vector3D known ? view.ScreenToScene(known) : view.Viewpoint;
            Vector3D origin = _settings.Aim == AimRay.Muzzle ? muzzle : view.Viewpoint;
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

        private Vector3D Eye => _viewpoint.position.ToCore();

        private ScreenView ViewAt(double sceneTimeS)
        {
            Pose surface = _surfaces.TryGetPoseAt(sceneTimeS, out Pose then) ? then : _screen.Pose;
            return new ScreenView(surface, _screen.SizeM, _eyes.TryGetPoseAt(sceneTimeS, out Pose eye) ? eye.Position : Eye);
        }
    }
}
