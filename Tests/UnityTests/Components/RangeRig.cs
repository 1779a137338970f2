using System.Collections.Generic;
using LaserTracking.Scoring;
using LaserTracking.Session;
using UnityEngine;
using UnityEngine.Events;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>
    /// A small range: screen at the origin, eye 3 m before it, and whatever targets a test puts behind. The camera sees exactly the
    /// screen, so that pixel (320, 240) is its middle.
    /// </summary>
    internal sealed class RangeRig
    {
        public const double EyeDistanceM = 3;

        public RangeRig(StubSource source, bool withCalibration = true)
        {
            Source = source;
            SourceAsset = ScriptableObject.CreateInstance<StubSourceAsset>();
            SourceAsset.Create = () => Source;
            var screen = new GameObject("screen");
            Screen = screen.AddComponent<ScreenSurface>();
            if (withCalibration)
                SerializedFields.Set(Screen, "_calibration", new TextAsset(Calibration));
            var eye = new GameObject("eye");
            eye.transform.position = new Vector3(0, 0, -(float)EyeDistanceM);
            var owner = new GameObject("range");
            owner.SetActive(false);
            Range = owner.AddComponent<LaserRange>();
            SerializedFields.Set(Range, "_screen", Screen);
            SerializedFields.Set(Range, "_viewpoint", eye.transform);
            SerializedFields.Set(Range, "_hitLayers", 1 << 8);
            SerializedFields.Set(Range, "_source", SourceAsset);
            var unityEvent = new UnityEvent<ShotEvent>();
            unityEvent.AddListener(shot => UnityEventShots.Add(shot));
            SerializedFields.Set(Range, "_shotFired", unityEvent);
            Range.ShotFired += shot => Shots.Add(shot);
            Range.HealthChanged += health => Health.Add(health);
        }

        public static string Calibration =>
            "{\"v\":1,\"kind\":\"screen\",\"image_size\":[640,480],\"screen_m\":[3.73,2.26],\"H\":[[0.005828125,0,0],[0,0.004708333333,0],[0,0,1]]}";

        public static string TwoCameraCalibration =>
            Calibration.TrimEnd('}') + ",\"hand_camera\":{\"image_size\":[640,576],\"K\":[[500,0,320],[0,500,288],[0,0,1]],\"R\":[[1,0,0],[0,1,0],[0,0,1]],\"T\":[0,0,-2000]}}";

        public StubSource Source { get; set; }

        public StubSourceAsset SourceAsset { get; }

        public ScreenSurface Screen { get; }

        public LaserRange Range { get; }

        public List<ShotEvent> Shots { get; } = new List<ShotEvent>();

        public List<HealthEvent> Health { get; } = new List<HealthEvent>();

        public List<ShotEvent> UnityEventShots { get; } = new List<ShotEvent>();

        /// <summary>A square plate with one zone of 5 points; inactive, so that more can be added.</summary>
        public static LaserTarget AddPlate(string name, Vector3 position, float sizeM)
        {
            GameObject plate = GameObject.CreatePrimitive(PrimitiveType.Cube);
            plate.SetActive(false);
            plate.name = name;
            plate.layer = 8;
            plate.transform.position = position;
            plate.transform.localScale = new Vector3(sizeM, sizeM, 0.01f);
            LaserTarget target = plate.AddComponent<LaserTarget>();
            SerializedFields.Set(target, "_definition", Definition("plate", sizeM));
            return target;
        }

        /// <summary>At the eye, looking at the screen.</summary>
        public static Camera AddMainCamera()
        {
            var owner = new GameObject("Main Camera") { tag = "MainCamera" };
            owner.transform.position = new Vector3(0, 0, -(float)EyeDistanceM);
            return owner.AddComponent<Camera>();
        }

        public static TargetDefinitionAsset Definition(string name, float sizeM)
        {
            TargetDefinitionAsset asset = ScriptableObject.CreateInstance<TargetDefinitionAsset>();
            asset.name = name;
            SerializedFields.Set(asset, "_kind", TargetKind.SteelPopper);
            SerializedFields.Set(asset, "_sizeM", new Vector2(sizeM, sizeM));
            var zone = new TargetZoneData { name = "plate", points = 5, shape = ZoneShape.Rectangle, sizeM = new Vector2(sizeM, sizeM) };
            SerializedFields.Set(asset, "_zones", new[] { zone });
            return asset;
        }

        /// <summary>One frame of the player, and whatever frames of the camera are due by then.</summary>
        public void Step(double seconds)
        {
            PlayerLoop.Step(seconds);
            Range.CompleteDueFrames();
        }

        /// <summary>Plays at 60 frames a second.</summary>
        public void Play(double seconds)
        {
            Range.gameObject.SetActive(true);
            for (int i = 0; i < seconds * 60; i++)
                Step(1 / 60.0);
        }
    }
}
