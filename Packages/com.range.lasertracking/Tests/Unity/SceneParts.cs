using System;
using System.Collections.Generic;
using System.Reflection;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using UnityEngine;
using Object = UnityEngine.Object;
using Pose = LaserTracking.Geometry.Pose;

namespace LaserTracking.Unity
{
    /// <summary>Builds the same thing twice: as Unity objects and as what the headless scene makes of them.</summary>
    internal sealed class SceneParts
    {
        private readonly List<GameObject> _created = new List<GameObject>();
        private readonly List<SceneObject> _objects = new List<SceneObject>();

        /// <summary>A primitive below a parent (or none), with local pose and scale, on a layer.</summary>
        public GameObject Add(PrimitiveType type, Transform? parent, Vector3 position, Vector3 euler, Vector3 scale, int layer)
        {
            GameObject created = GameObject.CreatePrimitive(type);
            _created.Add(created);
            created.name = type + " " + _objects.Count;
            created.layer = layer;
            created.transform.SetParent(parent, false);
            created.transform.localPosition = position;
            created.transform.localRotation = Quaternion.Euler(euler);
            created.transform.localScale = scale;
            _objects.Add(Describe(created, ColliderOf(type), default));
            return created;
        }

        /// <summary>Lets the last primitive move.</summary>
        public TargetMotion Move(MotionKind kind, Vector3 travelM, float periodS, float phaseS)
        {
            GameObject last = _created[_created.Count - 1];
            last.SetActive(false);
            TargetMotion motion = last.AddComponent<TargetMotion>();
            SetField(motion, "_kind", kind);
            SetField(motion, "_travelM", travelM);
            SetField(motion, "_periodS", periodS);
            SetField(motion, "_phaseS", phaseS);
            last.SetActive(true);
            var path = new MotionPath(kind, Vector3D.Scale(travelM.ToCore(), ParentScale(last)), periodS, phaseS);
            _objects[_objects.Count - 1] = Describe(last, _objects[_objects.Count - 1].Colliders[0], path);
            return motion;
        }

        public void MakeLastATrigger()
        {
            GameObject last = _created[_created.Count - 1];
            last.GetComponent<BoxCollider>().isTrigger = true;
            _objects[_objects.Count - 1] = Describe(last, SceneCollider.Box(default, new Vector3D(1, 1, 1), true), default);
        }

        public SceneModel Model(int layerMask) =>
            new SceneModel("parts", Pose.Identity, new Vector2D(1, 1), new Vector3D(0, 0, -1), layerMask, _objects.ToArray());

        public void DestroyAll()
        {
            foreach (GameObject created in _created)
                Object.DestroyImmediate(created);
        }

        /// <summary>Sets what Unity would read from a scene file.</summary>
        public static void SetField(object target, string name, object value)
        {
            FieldInfo? field = target.GetType().GetField(name, BindingFlags.Instance | BindingFlags.NonPublic);
            if (field == null)
                throw new ArgumentException(target.GetType().Name + " has no field " + name);
            field.SetValue(target, value);
        }

        private static SceneObject Describe(GameObject from, SceneCollider collider, MotionPath motion)
        {
            Transform? parent = from.transform.parent;
            Rotation3D parentRotation = parent == null ? Rotation3D.Identity : parent.rotation.ToCore();
            return new SceneObject(from.name, from.layer, from.transform.WorldPose(), from.transform.lossyScale.ToCore(), parentRotation, motion,
                new[] { collider }, null);
        }

        private static Vector3D ParentScale(GameObject from)
        {
            Transform? parent = from.transform.parent;
            return parent == null ? new Vector3D(1, 1, 1) : parent.lossyScale.ToCore();
        }

        private static SceneCollider ColliderOf(PrimitiveType type)
        {
            switch (type)
            {
                case PrimitiveType.Cube: return SceneCollider.Box(default, new Vector3D(1, 1, 1));
                case PrimitiveType.Sphere: return SceneCollider.Sphere(default, 0.5);
                case PrimitiveType.Capsule: return SceneCollider.Capsule(default, 0.5, 2, 1);
                case PrimitiveType.Quad: return SceneCollider.Quad();
                default: throw new ArgumentException("no collider for " + type);
            }
        }
    }
}
