using System;
using LaserTracking.Geometry;
using LaserTracking.Session;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// From a dot on the screen to what it hit in the scene and what that is worth. The ray comes from the viewpoint (or muzzle)
    /// through the dot, begins 1 cm behind the screen and reaches 100 m; scenery stops it, a target stops it where one of its zones
    /// holds the point, and beside every outline it goes on, so that the corner of a silhouette's box shields nothing.
    /// Threading: as the raycaster allows. No allocation per shot.
    /// </summary>
    public sealed class ShotScorer
    {
        // Flatter than this against the target's plane the uncertainty along the plane has no meaning.
        private const double LeastSlope = 1e-3;

        private readonly IRaycaster _raycaster;
        private readonly SceneModel? _scene;
        private readonly ScreenView _view;
        private readonly IScoringRule _rule;
        private readonly ShotScorerSettings _settings;

        /// <param name="raycaster">Into the same scene that the picture shows.</param>
        /// <param name="view">Screen and eye, where they stay.</param>
        /// <param name="rule">Null for <see cref="ZoneScoringRule"/> with its defaults.</param>
        /// <param name="settings">Null for the defaults.</param>
        public ShotScorer(IRaycaster raycaster, ScreenView view, IScoringRule? rule = null, ShotScorerSettings? settings = null)
        {
            _raycaster = raycaster;
            _view = view;
            _rule = rule ?? new ZoneScoringRule();
            _settings = settings ?? new ShotScorerSettings();
        }

        /// <summary>For a headless scene, whose screen and eye may move.</summary>
        public ShotScorer(SceneModel scene, IScoringRule? rule = null, ShotScorerSettings? settings = null)
            : this(new AnalyticRaycaster(scene), default, rule, settings)
        {
            _scene = scene;
        }

        /// <summary>False when the shot meets no zone of any target.</summary>
        /// <param name="screenM">The dot in screen space, metres.</param>
        /// <param name="screenCovarianceMm2">Its uncertainty.</param>
        /// <param name="confidence">The shot's, 0…1.</param>
        /// <param name="muzzleM">The muzzle in screen space, metres, when it is known; only used with <see cref="AimRay.Muzzle"/>.</param>
        /// <param name="sceneTimeS">The shot's photon time on the scene's clock: screen, eye and targets stand where they stood then.</param>
        /// <param name="hit">Complete, score included.</param>
        public bool TryScore(Vector2D screenM, Covariance2D screenCovarianceMm2, double confidence, Vector3D? muzzleM, double sceneTimeS,
            out ScoredHit hit) =>
            TryScore(_scene == null ? _view : _scene.ViewAt(sceneTimeS), screenM, screenCovarianceMm2, confidence, muzzleM, sceneTimeS, out hit);

        /// <summary>The same through a screen and an eye whose place at that time the caller knows.</summary>
        public bool TryScore(in ScreenView view, Vector2D screenM, Covariance2D screenCovarianceMm2, double confidence, Vector3D? muzzleM, double sceneTimeS,
            out ScoredHit hit)
        {
            hit = default;
            if (!TryAim(view, screenM, muzzleM, out Vector3D eye, out Vector3D dot))
                return false;
            var aim = new Ray3D(dot, dot - eye);
            double travelled = 0;
            Vector3D start = aim.At(_settings.StartBehindScreenM);
            for (int pass = 0; pass < _settings.MaxPasses; pass++)
            {
                var ray = new Ray3D(start + aim.Direction * travelled, aim.Direction);
                if (!_raycaster.TryRaycast(ray, _settings.MaxDistanceM - travelled, sceneTimeS, out RaycastHit met)
                    || !_raycaster.TryGetTarget(met.ObjectIndex, out string name, out TargetDefinition? target) || target == null)
                    return false;
                travelled += met.DistanceM;
                var local = new Vector2D(met.LocalPointM.X, met.LocalPointM.Y);
                int zone = target.ZoneAt(local);
                if (zone >= 0)
                {
                    hit.Target = name;
                    hit.Zone = target.Zones[zone].Name;
                    hit.Points = target.Zones[zone].Points;
                    hit.PointM = met.PointM;
                    hit.LocalPointM = local;
                    hit.DistanceM = travelled;
                    Covariance2D covariance = ToTarget(view.Surface, screenCovarianceMm2, eye, dot, met);
                    hit.ZoneProbability = ZoneProbability.Of(target, zone, local, covariance);
                    hit.Score = _rule.Score(hit, target, confidence);
                    return true;
                }

                travelled += _settings.PassStepM;
            }

            return false;
        }

        /// <summary>Eye and dot in the scene; false when there is no ray that crosses the screen from its front.</summary>
        private bool TryAim(in ScreenView view, Vector2D screenM, Vector3D? muzzleM, out Vector3D eye, out Vector3D dot)
        {
            dot = view.ScreenToScene(new Vector3D(screenM.X, screenM.Y, 0));
            eye = view.Viewpoint;
            if (_settings.Aim == AimRay.Muzzle && muzzleM is Vector3D muzzle)
                eye = view.ScreenToScene(muzzle);
            return dot.IsFinite && eye.IsFinite && view.Surface.InverseTransformPoint(eye).Z < 0;
        }

        /// <summary>
        /// The covariance (mm²) on the screen carried to the plane of the target through the hit point, in m²: linearised, as the
        /// ray's foot moves when the dot moves and the eye stays.
        /// </summary>
        private static Covariance2D ToTarget(Pose surface, Covariance2D screenMm2, Vector3D eye, Vector3D dot, in RaycastHit met)
        {
            Rotation3D rotation = met.ObjectPose.Rotation;
            if (rotation.X == 0 && rotation.Y == 0 && rotation.Z == 0 && rotation.W == 0)
                throw new InvalidOperationException("the raycaster did not fill RaycastHit.ObjectPose");
            Vector3D along = met.ObjectPose.InverseTransformDirection(dot - eye);
            Vector3D reach = met.ObjectPose.InverseTransformDirection(met.PointM - eye);
            double slope = along.Z;
            if (Math.Abs(slope) < LeastSlope * along.Length)
                slope = slope < 0 ? -LeastSlope * along.Length : LeastSlope * along.Length;

            // P(d) = eye + d · (h / dz) with dz = d.z, h = the plane's distance from the eye: dP/du = h/dz · (u − d · u.z / dz).
            Vector3D right = met.ObjectPose.InverseTransformDirection(surface.TransformDirection(new Vector3D(1, 0, 0)));
            Vector3D down = met.ObjectPose.InverseTransformDirection(surface.TransformDirection(new Vector3D(0, -1, 0)));
            double magnification = reach.Length / along.Length;
            Vector3D byRight = (right - along * (right.Z / slope)) * magnification;
            Vector3D byDown = (down - along * (down.Z / slope)) * magnification;
            const double M = Axes.MetresPerMillimetre;
            return screenMm2.Transform(byRight.X * M, byDown.X * M, byRight.Y * M, byDown.Y * M);
        }
    }
}
