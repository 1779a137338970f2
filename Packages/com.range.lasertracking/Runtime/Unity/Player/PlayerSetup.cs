using System;
using LaserTracking.Geometry;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Lets the trainer choose scene, calibration and sources on the player's command line (<see cref="PlayerArguments"/>). In every scene of
    /// the player; without arguments it does nothing.
    /// </summary>
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(-200)]
    [RequireComponent(typeof(LaserRange))]
    [AddComponentMenu("Laser Tracking/Player Setup")]
    public sealed class PlayerSetup : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Sources that -range-source and -range-hand-source may name.")]
        private FrameSourceAsset[] _sources = Array.Empty<FrameSourceAsset>();

        private void Start()
        {
            if (!PlayerArguments.TryParse(Environment.GetCommandLineArgs(), out PlayerArguments arguments, out string problem))
                ShotEmitters.Report(this, problem, true);
            else
                Apply(arguments);
        }

        internal void Apply(PlayerArguments arguments)
        {
            if (arguments.Scene.Length > 0 && arguments.Scene != gameObject.scene.name)
            {
                SceneManager.LoadScene(arguments.Scene);
                return;
            }

            LaserRange range = GetComponent<LaserRange>();
            if (arguments.Source.Length > 0 && Find("-range-source", arguments.Source) is FrameSourceAsset source)
                range.Source = source;
            if (arguments.HandSource.Length > 0 && Find("-range-hand-source", arguments.HandSource) is FrameSourceAsset handSource)
                range.HandSource = handSource;
            if (arguments.Calibration.Length > 0)
                UseCalibration(range, arguments.Calibration);
        }

        private FrameSourceAsset? Find(string argument, string name)
        {
            FrameSourceAsset? source = Array.Find(_sources, candidate => candidate != null && candidate.name == name);
            if (source == null)
                ShotEmitters.Report(this, argument + " " + name + ": there is no such source; name one of these: " + string.Join(", ", Array.ConvertAll(_sources, there => there == null ? "" : there.name)), true);
            return source;
        }

        private void UseCalibration(LaserRange range, string file)
        {
            ScreenSurface? screen = range.Screen;
            if (screen == null)
            {
                ShotEmitters.Report(this, "-range-calibration: the range has no screen to calibrate", true);
                return;
            }

            try
            {
                RangeCalibration calibration = RangeCalibrationFile.Read(file);
                screen.Use(calibration);
                range.Restart();
            }
            catch (InputException problem)
            {
                ShotEmitters.Report(this, problem.Message, true);
            }
        }
    }
}
