using System;
using System.Threading.Tasks;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Patterns;
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.UIElements;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Calibrates the screen while it runs: projects the patterns over the whole window, lets the range's own camera look at them, computes
    /// in the background, shows the error map, and puts a calibration that holds into the range's <see cref="ScreenSurface"/> and its file.
    /// </summary>
    [DisallowMultipleComponent]
    [RequireComponent(typeof(UIDocument))]
    [AddComponentMenu("Laser Tracking/Calibration Screen")]
    public sealed class CalibrationScreen : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Whose screen and camera. Empty: the LaserRange on this object or above.")]
        private LaserRange? _range;

        [SerializeField]
        [Min(0.2f)]
        [Tooltip("Seconds for which each of the four pictures is shown.")]
        private float _pictureS = 0.8f;

        [SerializeField]
        [Min(0.1f)]
        [Tooltip("Largest error on points that the fit has not seen, mm; above it a calibration is refused.")]
        private float _limitMm = 5;

        [SerializeField]
        [Min(0)]
        [Tooltip("Seconds for which the error map is shown.")]
        private float _mapS = 8;

        [SerializeField]
        [Tooltip("Begins by itself.")]
        private bool _beginsAtStart;

        [SerializeField]
        [Tooltip("Called with the verdict: true where the calibration holds.")]
        private UnityEvent<bool> _finished = new UnityEvent<bool>();

        private readonly object _lookLock = new object();
        private ScreenPatternFinder? _finder;
        private int _framesSeen;
        private LaserRange? _looking;
        private LaserRange? _calibrated;
        private Task<ScreenCalibration>? _work;
        private PatternTexture? _pattern;
        private VisualElement? _sheet;
        private RangeCalibration? _before;
        private bool _isDue;
        private int _picture;
        private double _untilS;

        /// <summary>Raised on the main thread with the result, accepted or refused.</summary>
        public event Action<ScreenCalibration>? Finished;

        public CalibrationState State { get; private set; }

        /// <summary>One sentence for people; empty before the first result.</summary>
        public string Verdict { get; private set; } = "";

        /// <summary>What is projected now; null when it is no pattern.</summary>
        public Texture2D? Shown => _pattern?.Texture;

        /// <summary>Starts, or starts anew. Says why it cannot.</summary>
        public void Begin()
        {
            Cancel();
            LaserRange? range = Range;
            UIDocument document = GetComponent<UIDocument>();
            VisualElement? root = document.rootVisualElement;
            int display = root == null ? 0 : document.panelSettings.targetDisplay;
            OutputDisplay.GetSize(display, out int width, out int height);
            string problem = range == null ? "has no LaserRange to calibrate; drag one in"
                : range.Screen == null || !range.Screen.HasSize ? "finds no screen with a size at its LaserRange; give it a ScreenSurface of the picture's size in metres"
                : root == null ? "cannot be seen: its UIDocument has no panel settings; drag RangePanel in"
                : !range.IsRunning ? "gets no pictures: the source of its LaserRange does not play; start the camera first"
                : range.Camera is Camera camera && camera.targetDisplay != display ? "draws on display " + (display + 1) + ", the camera that draws the range's picture on " + (camera.targetDisplay + 1) + "; give its panel settings a copy with that Target Display"
                : !OutputDisplay.TrySwitchOn(display) ? "draws on display " + (display + 1) + ", which is not plugged in; plug the projector in and start anew, or set Target Display of its panel settings"
                : !ScreenPattern.CanDraw(width, height) ? "needs a window between 16:6 and 16:14, 160 pixels wide or more; make it fill the projector's picture"
                : "";
            if (problem.Length > 0)
            {
                ShotEmitters.Report(this, "CalibrationScreen " + name + " " + problem, true);
                return;
            }

            _before = CalibrationBefore(range!.Screen!);
            _pattern = new PatternTexture(width, height);
            _sheet = PanelElements.Box(root!, "calibration", Color.black, 0);
            PanelElements.Fill(_sheet);
            _sheet.style.backgroundImage = _pattern.Texture;
            lock (_lookLock)
            {
                _finder = new ScreenPatternFinder();
                _framesSeen = 0;
            }

            _looking = range;
            range.SetLook(Look);
            State = CalibrationState.Showing;
            Show(0);
        }

        /// <summary>Takes pattern or map away; what is half done is forgotten.</summary>
        public void Cancel()
        {
            StopLooking()?.Dispose();
            _sheet?.RemoveFromHierarchy();
            _sheet = null;
            _pattern?.Dispose();
            _pattern = null;
            _work = null;
            State = CalibrationState.Idle;
        }

        private LaserRange? Range => _range != null ? _range : GetComponentInParent<LaserRange>();

        private void Start() => _isDue = _beginsAtStart;

        private void OnDisable() => Cancel();

        private void Update()
        {
            if (_isDue && Range != null && Range.IsRunning)
            {
                _isDue = false;
                Begin();
            }
            else if (State == CalibrationState.Computing)
            {
                if (_work!.IsCompleted)
                    Finish(_work);
            }
            else if (State != CalibrationState.Idle && Time.timeAsDouble >= _untilS)
            {
                if (State != CalibrationState.Showing)
                    Cancel();
                else if (_picture + 1 < ScreenPattern.Pictures)
                    Show(_picture + 1);
                else
                    Compute();
            }
        }

        private void Show(int picture)
        {
            _picture = picture;
            _pattern!.Draw(picture);
            _untilS = Time.timeAsDouble + _pictureS;
        }

        /// <summary>On the detector's thread, which has nothing else to do meanwhile.</summary>
        private void Look(Frame frame)
        {
            lock (_lookLock)
            {
                if (_finder != null && frame.Color.IsPresent && _finder.Add(frame.Color))
                    _framesSeen++;
            }
        }

        private ScreenPatternFinder? StopLooking()
        {
            if (_looking != null)
                _looking.SetLook(null);
            _looking = null;
            lock (_lookLock)
            {
                ScreenPatternFinder? finder = _finder;
                _finder = null;
                return finder;
            }
        }

        private void Compute()
        {
            LaserRange range = _looking!;
            ScreenPatternFinder finder = StopLooking()!;
            _sheet!.style.backgroundImage = default(StyleBackground);
            _pattern!.Dispose();
            _pattern = null;
            if (_framesSeen == 0)
            {
                finder.Dispose();
                Cancel();
                ShotEmitters.Report(this, "CalibrationScreen " + name + ": no picture came from the camera of " + range.name + " while the pattern was shown; check that it runs", true);
                return;
            }

            Vector2D sizeM = range.Screen!.SizeM;
            double limitMm = _limitMm;
            LensCamera? lens = _before?.Screen.Camera;
            _calibrated = range;
            State = CalibrationState.Computing;
            _work = Task.Run(() =>
            {
                using (finder)
                {
                    ScreenPatternView view = finder.Find();
                    bool fits = lens != null && (view.ImageWidth, view.ImageHeight) == (lens.Pinhole.Width, lens.Pinhole.Height);
                    return new ScreenCalibrator(sizeM, limitMm, fits ? lens : null).Calibrate(view);
                }
            });
        }

        private void Finish(Task<ScreenCalibration> work)
        {
            _work = null;
            if (work.Exception != null || _calibrated == null || _calibrated.Screen == null)
            {
                if (work.Exception != null)
                    Debug.LogException(work.Exception.InnerException, this);
                Cancel();
                return;
            }

            ScreenCalibration found = work.Result;
            Verdict = CalibrationMap.Verdict(found);
            State = found.IsAccepted ? CalibrationState.Accepted : CalibrationState.Refused;
            if (found.IsAccepted)
                Store(_calibrated, new RangeCalibration(found.Screen!, found.View.ImageWidth, found.View.ImageHeight, _before?.HandCamera, false, found.Residuals()));
            else
                ShotEmitters.Report(this, "calibration " + Verdict, false);
            CalibrationMap.Show(_sheet!, found, _limitMm);
            _untilS = Time.timeAsDouble + _mapS;
            ShotEmitter.Raise(this, Finished, null, found);
            ShotEmitter.Raise(this, null, _finished, found.IsAccepted);
        }

        private void Store(LaserRange range, RangeCalibration calibration)
        {
            ScreenSurface screen = range.Screen!;
            if (screen.TryUse(calibration, out string problem))
                Debug.Log("calibration " + Verdict + (screen.CalibrationPath is string path ? "; kept in " + path : ""), this);
            else
                ShotEmitters.Report(this, "calibration " + Verdict + ", but it cannot be kept: " + problem, false);
            range.Restart();
        }

        /// <summary>Its lens and camera 1's place stay as they are; one that cannot be read is about to be replaced.</summary>
        private static RangeCalibration? CalibrationBefore(ScreenSurface screen)
        {
            try
            {
                return screen.ReadCalibration();
            }
            catch (InputException)
            {
                return null;
            }
        }
    }
}
