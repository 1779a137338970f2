using System;
using System.Linq;
using LaserTracking.Unity;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace LaserTracking.Editor
{
    /// <summary>What a scene and a project have of all that a range needs.</summary>
    public sealed class SetupFacts
    {
        public int Ranges { get; set; }

        public bool HasScreen { get; set; }

        public bool HasScreenSize { get; set; }

        /// <summary>The screen's own, or the source brings one.</summary>
        public bool HasCalibration { get; set; }

        /// <summary>What is wrong with the calibration; empty: nothing.</summary>
        public string CalibrationProblem { get; set; } = "";

        public bool HasViewpoint { get; set; }

        /// <summary>Name of the source of camera 0; empty: none.</summary>
        public string Source { get; set; } = "";

        public bool HasHandCamera { get; set; }

        public int Targets { get; set; }

        /// <summary>Names of targets that no shot can hit, for want of a collider.</summary>
        public string[] TargetsWithoutCollider { get; set; } = Array.Empty<string>();

        /// <summary>Symbols that are set without their library, one line each: nothing compiles.</summary>
        public string[] LibraryProblems { get; set; } = Array.Empty<string>();

        public bool IsKinectAwake { get; set; }

        public bool IsOpenCvAwake { get; set; }

        public bool IsMathNetAwake { get; set; }

        /// <summary>Looks at the first LaserRange of a scene, and at what this editor has compiled.</summary>
        public static SetupFacts Of(Scene scene)
        {
            GameObject[] roots = scene.GetRootGameObjects();
            LaserRange[] ranges = roots.SelectMany(root => root.GetComponentsInChildren<LaserRange>(true)).ToArray();
            LaserTarget[] targets = roots.SelectMany(root => root.GetComponentsInChildren<LaserTarget>(true)).ToArray();
            var facts = new SetupFacts
            {
                Ranges = ranges.Length,
                Targets = targets.Length,
                TargetsWithoutCollider = targets.Where(target => target.GetComponentsInChildren<Collider>(true).Length == 0).Select(target => target.name).ToArray(),
                LibraryProblems = LibraryWatch.Problems().ToArray(),
                IsKinectAwake = IsAwake("Range.LaserTracking.Kinect"),
                IsOpenCvAwake = IsAwake("Range.LaserTracking.OpenCv"),
                IsMathNetAwake = IsAwake("Range.LaserTracking.Calibration"),
            };
            if (ranges.Length > 0)
                facts.Look(ranges[0]);
            return facts;
        }

        private void Look(LaserRange range)
        {
            HasViewpoint = range.Viewpoint != null;
            Source = range.Source == null ? "" : range.Source.name;
            bool bringsCalibration = range.Source is SimulationSource || range.Source is MouseSource;
            HasHandCamera = range.HandSource != null || range.Source is SimulationSource;
            ScreenSurface? screen = range.Screen;
            HasScreen = screen != null;
            if (screen == null)
                return;
            HasScreenSize = screen.HasSize;
            try
            {
                HasCalibration = screen.ReadCalibration() != null || bringsCalibration;
            }
            catch (InputException problem)
            {
                CalibrationProblem = problem.Message;
            }
        }

        private static bool IsAwake(string assembly) => AppDomain.CurrentDomain.GetAssemblies().Any(loaded => loaded.GetName().Name == assembly);
    }
}
