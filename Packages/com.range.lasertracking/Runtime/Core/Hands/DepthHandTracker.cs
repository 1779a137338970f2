using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Finds the hands of several people in depth alone, moving or not: connected surfaces within the gate, in each the parts that
    /// stand out before the torso, of each its axis, hand and muzzle. Bridges a hand whose depth is lost from its outline, its
    /// forearm and its motion, and marks it. Needs a depth picture of camera 1, which looks at the trainees from the screen.
    /// </summary>
    public sealed class DepthHandTracker : IHandTracker
    {
        /// <summary>Heads looked at over one arm: its own and a neighbour's on either side.</summary>
        private const int MaxHeads = 3;

        private readonly DepthGrid _grid;
        private readonly BodySegmenter _segmenter;
        private readonly ArmFitter _fitter;
        private readonly GripFinder _grips;
        private readonly HeadFinder _heads;
        private readonly PersonSet _people;
        private readonly HandTrackSet _tracks;
        private readonly ArmFit[] _fits;
        private readonly UprightFrame _upright;
        private readonly DepthHandSettings _settings;

        /// <param name="camera">Of the depth picture; for a smaller or larger picture of the same view it is scaled.</param>
        /// <param name="settings">Null: the defaults. Read once, here.</param>
        /// <param name="kernels">What runs the heavy kernels; this thread when absent.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public DepthHandTracker(PinholeCamera camera, DepthHandSettings? settings = null, KernelRunner? kernels = null)
            : this(camera, UprightFrame.Level, settings, kernels)
        {
        }

        /// <param name="camera">Its place tells where up is, which finds heads also when the camera looks up or down.</param>
        /// <param name="settings">Null: the defaults. Read once, here.</param>
        /// <param name="kernels">What runs the heavy kernels; this thread when absent.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public DepthHandTracker(HandCamera camera, DepthHandSettings? settings = null, KernelRunner? kernels = null)
            : this(camera.Intrinsics, UprightFrame.Of(camera), settings, kernels)
        {
        }

        private DepthHandTracker(PinholeCamera camera, UprightFrame upright, DepthHandSettings? settings, KernelRunner? kernels)
        {
            DepthHandSettings used = settings ?? new DepthHandSettings();
            used.Validate();
            _settings = used;
            _upright = upright;
            kernels ??= KernelRunner.Plain;
            _grid = new DepthGrid(camera, used, kernels);
            _segmenter = new BodySegmenter(used, kernels);
            _fitter = new ArmFitter(used, upright);
            _grips = new GripFinder(used, upright);
            _heads = new HeadFinder(used, upright);
            _people = new PersonSet(used, upright);
            _tracks = new HandTrackSet(used);
            _fits = new ArmFit[_segmenter.Arms.Length];
        }

        public void Process(Frame frame, HandObservations observations)
        {
            Image depth = frame.Depth;
            bool usable = depth.IsPresent && depth.Format == PixelFormat.Depth16;
            observations.Begin(frame.Index, usable ? depth.TimeUs : frame.TimeUs);
            if (!usable)
                return;
            _grid.Fill(depth);
            observations.Depth.Fill(_grid);
            _segmenter.Segment(_grid);
            FindPeople(depth.TimeUs);
            int count = 0;
            for (int i = 0; i < _segmenter.ArmCount; i++)
            {
                ref readonly ArmPart arm = ref _segmenter.Arms[i];
                if (arm.IsShallow && _people.IsHead(arm.MiddleMm))
                    continue;
                if (count == _fits.Length || !_fitter.TryFit(_grid, _segmenter.CellsOf(arm), arm, out ArmFit fit))
                    continue;
                if (fit.WeaponDirection.LengthSquared > 0 && _people.TryOwner(fit.MuzzleMm, fit.WeaponDirection, arm.PersonId, out int owner, out Vector3D eye))
                    GiveTo(owner, eye, arm, ref fit);
                int seems = fit.PersonId;
                if (TryOtherHolder(fit, depth.TimeUs, out owner, out eye))
                    GiveTo(owner, eye, arm, ref fit);
                fit.SeemsId = seems;
                _fits[count++] = fit;
                if (!fit.HasWeapon || count == _fits.Length || !SecondWeapon.TryFind(_grid, _segmenter.CellsOf(arm), fit, _people, _upright, _settings, out ArmFit second))
                    continue;
                second.SeemsId = second.PersonId;
                if (TryOtherHolder(second, depth.TimeUs, out owner, out eye))
                    SecondWeapon.GiveTo(owner, eye, _upright, _settings, ref second);
                _fits[count++] = second;
            }

            for (int i = 0; i < count; i++)
                _grips.Find(_people, ref _fits[i]);
            _tracks.Update(_grid, depth.TimeUs, new ReadOnlySpan<ArmFit>(_fits, 0, count), observations);
            _people.Report(observations);
        }

        public void Reset()
        {
            _tracks.Reset();
            _people.Reset();
        }

        /// <summary>Where arms cross, an arm's rear end and a weapon's bearing mislead: a weapon that was somebody's a frame ago still is.</summary>
        private bool TryOtherHolder(in ArmFit fit, long timeUs, out int personId, out Vector3D eyeMm)
        {
            eyeMm = default;
            personId = 0;
            return fit.HasWeapon && _tracks.TryHolder(fit.MuzzleMm, timeUs, out personId) && personId != fit.PersonId && _people.TryEyesOf(personId, out eyeMm);
        }

        /// <summary>Measures an arm again as somebody else's, whose eyes say where else its weapon is looked for.</summary>
        private void GiveTo(int personId, Vector3D eyeMm, in ArmPart arm, ref ArmFit fit)
        {
            ArmPart own = arm;
            own.PersonId = personId;
            own.EyeMm = eyeMm;
            own.HasEye = true;
            if (_fitter.TryFit(_grid, _segmenter.CellsOf(arm), own, out ArmFit again) && again.HasWeapon)
                fit = again;
            else
                fit.PersonId = personId;
        }

        /// <summary>First all heads, then each arm's: one that hides its own head in this frame still is its person's.</summary>
        private void FindPeople(long timeUs)
        {
            _people.Begin(timeUs);
            Span<Vector3D> eyes = stackalloc Vector3D[MaxHeads];
            for (int i = 0; i < _segmenter.ArmCount; i++)
            {
                int found = _heads.Find(_grid, _segmenter.Owner, i, _segmenter.Arms[i].RootMm, eyes);
                for (int k = 0; k < found; k++)
                    _people.See(eyes[k], timeUs);
            }

            for (int i = 0; i < _segmenter.ArmCount; i++)
            {
                ref ArmPart arm = ref _segmenter.Arms[i];
                arm.PersonId = _people.Find(arm.RootMm, out Vector3D eye, out bool isHeadHidden);
                if ((arm.PersonId == 0 || isHeadHidden) && !arm.IsShallow)
                    _people.SeeArm(arm.RootMm, timeUs);
                if (arm.PersonId == 0 || isHeadHidden)
                    continue;
                arm.HasEye = true;
                arm.EyeMm = eye;
            }
        }
    }
}
