using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// Hands from depth, made better by the landmark model where camera 1 has a picture to it: infrared, or colour of the depth
    /// picture's size and view. Depth says where to look, how large, and by the forearm how the hand is turned; from then on the
    /// landmarks themselves lead to the next frame's region. What the model says counts only where depth bears it out (place, palm
    /// length, wrist), because its presence stays high on what is no upright hand. Everything else, and every frame without a picture,
    /// stays as depth has it.
    /// </summary>
    public sealed class LandmarkHandTracker : IHandTracker
    {
        private const int Capacity = 16;
        private const int NeededVotes = 3;

        private static readonly int[] PalmJoints = { 0, 5, 9, 13, 17 };

        private readonly IHandTracker _depthTracker;
        private readonly PinholeCamera _camera;
        private readonly HandLandmarkNetwork _network;
        private readonly LandmarkHandSettings _settings;
        private readonly HandObservations _depthHands = new HandObservations(Capacity);
        private readonly LandmarkTrack[] _tracks = new LandmarkTrack[Capacity];
        private readonly HandLandmarks _trial = new HandLandmarks();
        private readonly HandLandmarks _best = new HandLandmarks();
        private int _runsLeft;

        /// <param name="depthTracker">Finds the hands.</param>
        /// <param name="camera">Of the depth picture, as for the depth tracker.</param>
        /// <param name="network">Not owned; used by nobody else at the same time.</param>
        /// <param name="settings">Null: the defaults. Read once, here.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public LandmarkHandTracker(IHandTracker depthTracker, PinholeCamera camera, HandLandmarkNetwork network, LandmarkHandSettings? settings = null)
        {
            _settings = settings ?? new LandmarkHandSettings();
            _settings.Validate();
            _depthTracker = depthTracker;
            _camera = camera;
            _network = network;
            for (int i = 0; i < Capacity; i++)
                _tracks[i] = new LandmarkTrack();
        }

        public void Process(Frame frame, HandObservations observations)
        {
            _depthTracker.Process(frame, _depthHands);
            observations.Begin(_depthHands.FrameIndex, _depthHands.TimeUs);
            observations.Depth.CopyFrom(_depthHands.Depth);
            foreach (LandmarkTrack track in _tracks)
                track.IsInFrame = false;
            Image? picture = PictureOf(frame);
            _runsLeft = _settings.MaxRunsPerFrame;
            foreach (HandObservation hand in _depthHands.Hands)
            {
                HandObservation refined = hand;
                if (TryTrack(hand.TrackId, out LandmarkTrack track))
                {
                    track.IsInFrame = true;
                    track.IsSeen = picture != null && hand.DepthSource == DepthSource.Measured && TrySee(picture, hand, track, _depthHands.TimeUs);
                    if (track.IsSeen)
                        refined = Refine(hand, track, picture!);
                }

                observations.Add(refined);
            }

            foreach (PersonObservation person in _depthHands.People)
                observations.Add(person);
            foreach (LandmarkTrack track in _tracks)
            {
                if (!track.IsInFrame)
                    track.Begin(0);
            }
        }

        public void Reset()
        {
            _depthTracker.Reset();
            foreach (LandmarkTrack track in _tracks)
                track.Begin(0);
        }

        /// <summary>The landmarks of a hand of the last frame; false when the model did not see it. Valid until the next frame.</summary>
        public bool TryGetLandmarks(int trackId, out HandLandmarks landmarks)
        {
            foreach (LandmarkTrack track in _tracks)
            {
                landmarks = track.Landmarks;
                if (track.TrackId == trackId && trackId != 0 && track.IsSeen)
                    return true;
            }

            landmarks = _trial;
            return false;
        }

        private static Image? PictureOf(Frame frame) => Fits(frame.Color, frame.Depth) ? frame.Color : Fits(frame.Infrared, frame.Depth) ? frame.Infrared : null;

        private static bool Fits(Image picture, Image depth) => HandLandmarkNetwork.CanRead(picture) && picture.Width == depth.Width && picture.Height == depth.Height;

        private bool TryTrack(int trackId, out LandmarkTrack track)
        {
            track = _tracks[0];
            LandmarkTrack? free = null;
            foreach (LandmarkTrack candidate in _tracks)
            {
                if (candidate.TrackId == trackId && trackId != 0)
                {
                    track = candidate;
                    return true;
                }

                if (candidate.TrackId == 0)
                    free ??= candidate;
            }

            if (free == null || trackId == 0)
                return false;
            free.Begin(trackId);
            track = free;
            return true;
        }

        /// <summary>Looks where the landmarks of the frame before lead, else where depth says; false when no hand is believed.</summary>
        private bool TrySee(Image picture, in HandObservation hand, LandmarkTrack track, long timeUs)
        {
            if (!TryRegion(picture, hand, out HandRegion expected, out bool isTurnKnown))
                return false;
            if (track.IsSeen && _runsLeft >= 1 && TryRun(picture, track.Landmarks.NextRegion, hand, expected, isTurnKnown, track))
                return true;
            if (timeUs < track.RetryUs)
                return false;

            // The first crop finds the hand, the second, from its landmarks, sees it as the model likes it.
            if (_runsLeft < (isTurnKnown ? 2 : 5))
                return false;
            Look(picture, expected, isTurnKnown ? 1 : 4);
            if (_best.Presence >= HandLandmarkNetwork.MinPresence && TryRun(picture, _best.NextRegion, hand, expected, isTurnKnown, track))
                return true;
            track.RetryUs = timeUs + _settings.RetryUs;
            return false;
        }

        /// <summary>Leaves the likeliest of the rotations in <see cref="_best"/>.</summary>
        private void Look(Image picture, HandRegion region, int rotations)
        {
            for (int turn = 0; turn < rotations; turn++)
            {
                _runsLeft--;
                _network.Run(picture, region.Turned(turn * Math.PI / 2), _trial);
                if (turn == 0 || _trial.Presence > _best.Presence)
                    _best.CopyFrom(_trial);
            }
        }

        private bool TryRun(Image picture, HandRegion region, in HandObservation hand, HandRegion expected, bool isTurnKnown, LandmarkTrack track)
        {
            if (!IsNear(region, expected))
                return false;
            _runsLeft--;
            _network.Run(picture, region, _trial);
            if (!(_trial.Presence >= HandLandmarkNetwork.MinPresence) || !IsBorneOut(_trial, hand, picture, expected, isTurnKnown))
                return false;
            track.Landmarks.CopyFrom(_trial);
            track.Vote(_trial.RightHandProbability);
            return true;
        }

        /// <summary>The square around the palm that depth asks for, upright along the forearm where that is seen from the side.</summary>
        private bool TryRegion(Image picture, in HandObservation hand, out HandRegion region, out bool isTurnKnown)
        {
            region = default;
            isTurnKnown = false;
            double scale = picture.Width / (double)_camera.Width;
            if (!_camera.TryProject(hand.PalmMm, out Vector2D palm))
                return false;
            double rotation = 0;
            Vector3D axis = hand.AimDirection;
            double inPicture = Math.Sqrt(axis.X * axis.X + axis.Y * axis.Y);
            if (inPicture >= _settings.MinAxisInPicture && _camera.TryProject(hand.PalmMm - axis * (_settings.RegionMm / 2), out Vector2D forearm))
            {
                rotation = HandRegion.UprightRotation(forearm.X, forearm.Y, palm.X, palm.Y);
                isTurnKnown = true;
            }

            // Pixels count from the corner here and from the first one's centre there.
            region = new HandRegion((palm.X + 0.5) * scale, (palm.Y + 0.5) * scale, _camera.FocalXPx * scale * _settings.RegionMm / hand.PalmMm.Z, rotation);
            return region.IsValid;
        }

        /// <summary>Twice the model's harmless shift and scale: a hand that moves is no other hand.</summary>
        private static bool IsNear(HandRegion region, HandRegion expected)
        {
            double dx = region.CenterXPx - expected.CenterXPx, dy = region.CenterYPx - expected.CenterYPx;
            return region.IsValid && dx * dx + dy * dy <= 0.25 * expected.SidePx * expected.SidePx
                && region.SidePx <= 2 * expected.SidePx && expected.SidePx <= 2.5 * region.SidePx;
        }

        private bool IsBorneOut(HandLandmarks seen, in HandObservation hand, Image picture, HandRegion expected, bool isTurnKnown)
        {
            HandRegion next = seen.NextRegion;
            if (!IsNear(next, expected))
                return false;
            if (isTurnKnown && Math.Abs(next.Turned(-expected.RotationRad).RotationRad) > _settings.MaxWristBendRad)
                return false;

            // Both as seen, without what points along the line of sight.
            double byDepth = Across(seen.PicturePx[9] - seen.PicturePx[0]) * hand.PalmMm.Z / (_camera.FocalXPx * picture.Width / _camera.Width);
            double byModel = Across(seen.WorldM[9] - seen.WorldM[0]) * 1000;
            return byDepth <= _settings.MaxScaleRatio * byModel && byModel <= _settings.MaxScaleRatio * byDepth;
        }

        private static double Across(Vector3D v) => Math.Sqrt(v.X * v.X + v.Y * v.Y);

        /// <summary>
        /// The palm across the line of sight from both, weighed by their variances; its distance stays that of depth. The side by the
        /// model once several frames agree.
        /// </summary>
        private HandObservation Refine(in HandObservation hand, LandmarkTrack track, Image picture)
        {
            Vector3D sum = default;
            foreach (int joint in PalmJoints)
                sum += track.Landmarks.PicturePx[joint];
            double scale = picture.Width / (double)_camera.Width;
            Vector3D palm = _camera.Unproject(sum.X / PalmJoints.Length / scale - 0.5, sum.Y / PalmJoints.Length / scale - 0.5, hand.PalmMm.Z);
            double depthVariance = hand.SigmaMm * hand.SigmaMm, weight = depthVariance / (depthVariance + _settings.PalmSigmaMm * _settings.PalmSigmaMm);
            HandObservation refined = hand;
            refined.PalmMm = hand.PalmMm + (palm - hand.PalmMm) * weight;
            refined.IsSideSure = Math.Abs(track.SideVotes) >= NeededVotes;
            if (refined.IsSideSure)
                refined.Side = track.SideVotes > 0 ? HandSide.Right : HandSide.Left;
            return refined;
        }
    }
}
