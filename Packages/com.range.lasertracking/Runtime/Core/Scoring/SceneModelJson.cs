using System;
using System.Linq;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// A scene as JSON, every number to its last bit, so that a session can be scored again without the project that it was played in.
    /// Poses are [x, y, z, qx, qy, qz, qw], metres, Unity's axes.
    /// </summary>
    internal static class SceneModelJson
    {
        public static JObject Format(SceneModel scene) => new JObject
        {
            ["v"] = CalibrationJson.Version,
            ["kind"] = "scene",
            ["name"] = scene.Name,
            ["surface"] = List(scene.Surface),
            ["screen_m"] = List(scene.ScreenSizeM),
            ["viewpoint_m"] = List(scene.Viewpoint),
            ["layers"] = scene.LayerMask,
            ["objects"] = new JArray(scene.Objects.Select(Format)),
        };

        /// <exception cref="InputException">Another kind, a newer version, or a field that is absent or impossible.</exception>
        public static SceneModel Parse(JObject root, string name)
        {
            CalibrationJson.CheckVersion(root, name);
            try
            {
                if (Text(root, "kind") != "scene")
                    throw new FormatException("it is of another kind");
                return new SceneModel(Text(root, "name"), Pose(root, "surface"), Plane(root, "screen_m"), Space(root, "viewpoint_m"), (int)Number(root, "layers"), Objects(root, "objects").Select(ParseObject).ToArray());
            }
            catch (Exception problem) when (problem is FormatException || problem is ArgumentException || problem is InvalidCastException || problem is OverflowException)
            {
                throw new InputException(name, "the scene cannot be used (" + problem.Message.Split('\n')[0].TrimEnd('.', '\r') + ")", "take the file as it was recorded");
            }
        }

        private static JObject Format(SceneObject item) => new JObject
        {
            ["name"] = item.Name,
            ["layer"] = item.Layer,
            ["rest"] = List(item.RestPose),
            ["scale"] = List(item.Scale),
            ["parent_rotation"] = List(item.ParentRotation),
            ["motion"] = item.Motion.Kind.ToString(),
            ["travel_m"] = List(item.Motion.TravelM),
            ["period_s"] = item.Motion.PeriodS,
            ["phase_s"] = item.Motion.PhaseS,
            ["colliders"] = new JArray(item.Colliders.Select(Format)),
            ["target"] = item.Target == null ? null : Format(item.Target),
        };

        private static SceneObject ParseObject(JObject item)
        {
            var motion = new MotionPath(Word<MotionKind>(item, "motion"), Space(item, "travel_m"), Number(item, "period_s"), Number(item, "phase_s"));
            TargetDefinition? target = item["target"] is JObject definition ? ParseTarget(definition) : null;
            return new SceneObject(Text(item, "name"), (int)Number(item, "layer"), Pose(item, "rest"), Space(item, "scale"), Rotation(item, "parent_rotation"), motion,
                Objects(item, "colliders").Select(ParseCollider).ToArray(), target);
        }

        private static JObject Format(SceneCollider collider)
        {
            var content = new JObject { ["shape"] = collider.Shape.ToString(), ["center_m"] = List(collider.Center), ["size_m"] = List(collider.Size), ["radius_m"] = collider.Radius, ["height_m"] = collider.Height, ["axis"] = collider.Axis, ["trigger"] = collider.IsTrigger };
            if (collider.IsOnChild)
                content["child"] = new JObject { ["pose"] = List(collider.ChildPose), ["scale"] = List(collider.ChildScale), ["layer"] = collider.ChildLayer };
            return content;
        }

        private static SceneCollider ParseCollider(JObject item)
        {
            bool isTrigger = item["trigger"] is JValue { Value: bool flag } && flag;
            SceneCollider collider = Word<ColliderShape>(item, "shape") switch
            {
                ColliderShape.Box => SceneCollider.Box(Space(item, "center_m"), Space(item, "size_m"), isTrigger),
                ColliderShape.Sphere => SceneCollider.Sphere(Space(item, "center_m"), Number(item, "radius_m"), isTrigger),
                ColliderShape.Capsule => SceneCollider.Capsule(Space(item, "center_m"), Number(item, "radius_m"), Number(item, "height_m"), (int)Number(item, "axis"), isTrigger),
                _ => SceneCollider.Quad(),
            };
            return item["child"] is JObject child ? collider.OnChild(Pose(child, "pose"), Space(child, "scale"), (int)Number(child, "layer")) : collider;
        }

        private static JObject Format(TargetDefinition target) => new JObject
        {
            ["name"] = target.Name,
            ["kind"] = target.Kind.ToString(),
            ["size_m"] = List(target.SizeM),
            ["zones"] = new JArray(target.Zones.Select(zone => new JObject
            {
                ["name"] = zone.Name,
                ["points"] = zone.Points,
                ["shape"] = zone.Shape.ToString(),
                ["center_m"] = List(zone.CenterM),
                ["size_m"] = List(zone.SizeM),
                ["corners_m"] = new JArray(zone.CornersM.Select(List)),
            })),
        };

        private static TargetDefinition ParseTarget(JObject item)
        {
            TargetZone[] zones = Objects(item, "zones").Select(zone => new TargetZone(Text(zone, "name"), (int)Number(zone, "points"), Word<ZoneShape>(zone, "shape"),
                Plane(zone, "center_m"), Plane(zone, "size_m"), Corners(zone))).ToArray();
            return new TargetDefinition(Text(item, "name"), Word<TargetKind>(item, "kind"), Plane(item, "size_m"), zones);
        }

        private static Vector2D[] Corners(JObject zone) =>
            (zone["corners_m"] as JArray ?? throw new FormatException("field corners_m is missing")).Select(corner => Plane(Numbers(corner, 2, "corners_m"))).ToArray();

        private static JArray List(Vector2D v) => new JArray(v.X, v.Y);

        private static JArray List(Vector3D v) => new JArray(v.X, v.Y, v.Z);

        private static JArray List(Rotation3D r) => new JArray(r.X, r.Y, r.Z, r.W);

        private static JArray List(Pose pose) => new JArray(List(pose.Position).Concat(List(pose.Rotation)));

        private static Vector2D Plane(double[] n) => new Vector2D(n[0], n[1]);

        private static Vector2D Plane(JObject item, string field) => Plane(Numbers(item[field], 2, field));

        private static Vector3D Space(JObject item, string field)
        {
            double[] n = Numbers(item[field], 3, field);
            return new Vector3D(n[0], n[1], n[2]);
        }

        private static Rotation3D Rotation(JObject item, string field)
        {
            double[] n = Numbers(item[field], 4, field);
            return new Rotation3D(n[0], n[1], n[2], n[3]);
        }

        private static Pose Pose(JObject item, string field) => ParsePose(item[field], field);

        /// <summary>Seven finite numbers, the last four a rotation.</summary>
        public static Pose ParsePose(JToken? token, string field)
        {
            double[] n = Numbers(token, 7, field);
            return new Pose(new Vector3D(n[0], n[1], n[2]), new Rotation3D(n[3], n[4], n[5], n[6]));
        }

        private static double Number(JObject item, string field) => Numbers(new JArray(item[field] ?? throw new FormatException("field " + field + " is missing")), 1, field)[0];

        private static double[] Numbers(JToken? token, int count, string field) => CalibrationJson.Numbers(token, count, "scene", field);

        private static string Text(JObject item, string field) => (item[field] as JValue)?.Value as string ?? throw new FormatException("field " + field + " is no text");

        private static T Word<T>(JObject item, string field)
            where T : struct, Enum =>
            Enum.TryParse(Text(item, field), out T value) && Enum.IsDefined(typeof(T), value) ? value : throw new FormatException("field " + field + " is no " + typeof(T).Name);

        private static JObject[] Objects(JObject item, string field) =>
            (item[field] as JArray)?.Select(entry => entry as JObject ?? throw new FormatException("field " + field + " holds something else than objects")).ToArray()
            ?? throw new FormatException("field " + field + " is missing");
    }
}
