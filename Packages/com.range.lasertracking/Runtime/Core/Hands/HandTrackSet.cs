using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Gives the arms of each frame their numbers: nearest to the predicted place first, one arm a track. Carries a hand over frames
    /// in which its depth is lost.
    /// </summary>
    internal sealed class HandTrackSet
    {
        private const double NominalFrameUs = 66_667;
        private const double VelocityGain = 0.7;
        private const int MaxVotes = 6;
        private const int NeededVotes = 2;

        /// <summary>A hand without a weapon is known that much worse than its surface: what is seen of it takes in the wrist when it hangs.</summary>
        private const double BareHand = 1.5;

        /// <summary>Of a grip known worse the hand's surface tells as much.</summary>
        private const double GripKnownMm = 20;

        /// <summary>A hand whose velocity is known comes so near to where it goes, and what 6 g take it off.</summary>
        private const double SteadyMm = 60;
        private const double AccelerationMmS2 = 60_000;

        /// <summary>So near to where a hand or its weapon goes it is that one, whosever the arm seems; but a hand of its own person's is sooner, up to this farther off.</summary>
        private const double SameHandMm = 25;
        private const double SameWeaponMm = 40;
        private const double MistakenMm = 50;

        /// <summary>For how many frames an arm may seem another's: half a second at 30 frames/s.</summary>
        private const int MaxPersonVotes = 15;

        /// <summary>With fewer its owner is not sure, and so is not which of the hands beside each other it is.</summary>
        private const int SureVotes = 2;

        /// <summary>A weapon is looked for where it was at most three frames at 30 frames/s ago.</summary>
        private const long SameWeaponUs = 110_000;

        private readonly DepthHandSettings _settings;
        private readonly HandTrack[] _tracks;
        private readonly bool[] _trackTaken;
        private readonly bool[] _fitTaken;
        private int _count;
        private int _nextId = 1;

        public HandTrackSet(DepthHandSettings settings)
        {
            _settings = settings;
            _tracks = new HandTrack[settings.MaxHands];
            _trackTaken = new bool[_tracks.Length];
            _fitTaken = new bool[2 * settings.MaxHands];
        }

        public void Reset()
        {
            _count = 0;
            _nextId = 1;
        }

        public void Update(DepthGrid grid, long timeUs, ReadOnlySpan<ArmFit> fits, HandObservations observations)
        {
            Forget(timeUs);
            Array.Clear(_trackTaken, 0, _trackTaken.Length);
            Array.Clear(_fitTaken, 0, _fitTaken.Length);
            while (TryNearestPair(fits, timeUs, out int track, out int fit))
            {
                _trackTaken[track] = true;
                _fitTaken[fit] = true;
                Continue(ref _tracks[track], fits[fit], timeUs, observations);
            }

            int old = _count;
            for (int i = 0; i < old; i++)
            {
                if (!_trackTaken[i])
                    Carry(ref _tracks[i], grid, timeUs, observations);
            }

            for (int i = 0; i < fits.Length; i++)
            {
                if (!_fitTaken[i] && _count < _settings.MaxHands)
                    Start(fits[i], timeUs, observations);
            }
        }

        private void Forget(long timeUs)
        {
            int kept = 0;
            for (int i = 0; i < _count; i++)
            {
                // Also when time runs backwards, after a seek.
                long age = timeUs - _tracks[i].TimeUs;
                if (age > 0 && age <= _settings.TrackMemoryUs)
                    _tracks[kept++] = _tracks[i];
            }

            _count = kept;
        }

        private bool TryNearestPair(ReadOnlySpan<ArmFit> fits, long timeUs, out int bestTrack, out int bestFit)
        {
            bestTrack = bestFit = -1;
            double best = double.MaxValue;
            for (int t = 0; t < _count; t++)
            {
                if (_trackTaken[t])
                    continue;
                Vector3D expected = _tracks[t].Predict(timeUs);
                double gate = GateMm(_tracks[t], timeUs);
                for (int f = 0; f < fits.Length; f++)
                {
                    double distance = (fits[f].PalmMm - expected).Length;
                    if (_fitTaken[f] || distance > gate || (IsAnothers(_tracks[t], fits[f]) && !IsMistaken(_tracks[t], distance)))
                        continue;

                    // Whose hand it is goes before how near it is.
                    if (IsAnothers(_tracks[t], fits[f]))
                        distance += MistakenMm;
                    else if (fits[f].PersonId == 0 || _tracks[t].PersonId == 0)
                        distance += gate;
                    if (distance >= best)
                        continue;
                    best = distance;
                    bestTrack = t;
                    bestFit = f;
                }
            }

            return bestTrack >= 0;
        }

        private double GateMm(in HandTrack track, long timeUs)
        {
            double seconds = (timeUs - track.TimeUs) * 1e-6, frames = Math.Min(3, Math.Max(1, (timeUs - track.TimeUs) / NominalFrameUs));
            double gate = _settings.TrackGateMm * Math.Sqrt(frames);
            return track.HasVelocity ? Math.Min(gate, SteadyMm + 0.5 * AccelerationMmS2 * seconds * seconds) : gate;
        }

        /// <summary>A hand's number stays with its person, however near another's hand comes.</summary>
        private static bool IsAnothers(in HandTrack track, in ArmFit fit) => track.PersonId != 0 && fit.PersonId != 0 && fit.PersonId != track.PersonId;

        /// <summary>Where two arms lie beside each other in the picture one may be taken for the other's; not for long.</summary>
        private static bool IsMistaken(in HandTrack track, double distanceMm) => distanceMm <= SameHandMm && track.HasVelocity && track.PersonVotes > 0;

        /// <summary>Whose the weapon was of which this is the muzzle; false where none was here, or where its owner is no longer sure.</summary>
        public bool TryHolder(Vector3D muzzleMm, long timeUs, out int personId)
        {
            personId = 0;
            double best = SameWeaponMm;
            for (int i = 0; i < _count; i++)
            {
                ref readonly HandTrack track = ref _tracks[i];
                double distance = (track.PredictMuzzle(timeUs) - muzzleMm).Length;
                if (track.PersonVotes <= 0 || !track.HasVelocity || track.WeaponUs != track.TimeUs || timeUs - track.TimeUs > SameWeaponUs || distance > best)
                    continue;
                best = distance;
                personId = track.PersonId;
            }

            return personId != 0;
        }

        private void Continue(ref HandTrack track, in ArmFit fit, long timeUs, HandObservations observations)
        {
            Vector3D expected = track.Predict(timeUs);
            if (fit.IsHandLost)
            {
                Bridge(ref track, fit, expected, timeUs, observations);
                return;
            }

            double seconds = (timeUs - track.TimeUs) * 1e-6;
            track.VelocityMmS = track.HasVelocity
                ? track.VelocityMmS + (fit.PalmMm - expected) * (VelocityGain / seconds)
                : (fit.PalmMm - track.PalmMm) * (1 / seconds);
            track.HasVelocity = true;
            Measure(ref track, fit, timeUs, observations);
        }

        private void Start(in ArmFit fit, long timeUs, HandObservations observations)
        {
            ref HandTrack track = ref _tracks[_count++];
            track = new HandTrack { Id = _nextId++ };
            if (!fit.IsHandLost)
            {
                Measure(ref track, fit, timeUs, observations);
                return;
            }

            Remember(ref track, fit, timeUs);
            track.MeasuredUs = timeUs;
            observations.Add(Observe(track, fit.PalmSigmaMm, fit.MuzzleSigmaMm, DepthSource.Bridged));
        }

        private void Measure(ref HandTrack track, in ArmFit fit, long timeUs, HandObservations observations)
        {
            Remember(ref track, fit, timeUs);
            track.MeasuredUs = timeUs;
            track.HasLineOffset = ArmFit.TryLineDepth(fit, fit.PalmMm, out double onLine);
            track.LineOffsetMm = fit.PalmMm.Z - onLine;
            if (fit.Side != HandSide.Unknown)
            {
                int votes = track.SideVotes + (fit.Side == HandSide.Right ? 1 : -1);
                track.SideVotes = Math.Max(-MaxVotes, Math.Min(MaxVotes, votes));
            }

            double muzzleSigma = fit.MuzzleSigmaMm;
            Vector3D weapon = fit.WeaponDirection;
            if (!fit.HasWeapon && fit.MuzzleSigmaMm < _settings.CutSigmaMm && IsWeaponKnown(track, fit.SurfaceMm, timeUs, out double moved))
            {
                track.PalmMm = fit.SurfaceMm + track.GripOffsetMm;
                track.MuzzleOffsetMm = track.WeaponOffsetMm - track.GripOffsetMm;
                weapon = track.WeaponDirection;
                muzzleSigma = Math.Sqrt(2 * _settings.PalmSigmaMm * _settings.PalmSigmaMm + 0.1 * moved * moved);
            }

            HandObservation hand = Observe(track, PalmSigmaMm(track, fit, timeUs), muzzleSigma, DepthSource.Measured);
            hand.WeaponDirection = weapon;
            if (fit.GripSigmaMm > 0 && fit.GripSigmaMm <= GripKnownMm)
                hand.PalmMm = fit.GripMm;
            observations.Add(hand);
        }

        /// <summary>
        /// With a weapon as the grip tells it; without one as of a hand that is seen whole. What is cut off, too small, of two arms, or held a weapon
        /// a moment ago that now is hidden, is hardly all of the hand.
        /// </summary>
        private double PalmSigmaMm(in HandTrack track, in ArmFit fit, long timeUs)
        {
            if (fit.SeemsId != 0 && track.PersonVotes < SureVotes)
                return Math.Max(fit.GripSigmaMm, _settings.HiddenPalmSigmaMm);
            if (fit.GripSigmaMm > 0)
                return fit.GripSigmaMm;
            if (fit.HasWeapon)
                return fit.PalmSigmaMm;
            bool isWhole = fit.HasOneRoot && fit.HandAreaMm2 >= _settings.MinPalmAreaMm2 && fit.MuzzleSigmaMm < _settings.CutSigmaMm;
            bool isWeaponHidden = track.WeaponUs > 0 && timeUs - track.WeaponUs <= _settings.WeaponKeptUs;
            return isWhole && !isWeaponHidden ? BareHand * fit.PalmSigmaMm : _settings.HiddenPalmSigmaMm;
        }

        private bool IsWeaponKnown(in HandTrack track, Vector3D surfaceMm, long timeUs, out double movedMm)
        {
            movedMm = (surfaceMm - track.WeaponSurfaceMm).Length;
            return track.WeaponUs > 0 && timeUs - track.WeaponUs <= _settings.WeaponKeptUs && movedMm <= _settings.WeaponKeptMm;
        }

        private static void Remember(ref HandTrack track, in ArmFit fit, long timeUs)
        {
            // What comes back after a gap may be another's.
            if (timeUs - track.TimeUs > SameWeaponUs)
                track.PersonVotes = 0;
            track.PalmMm = fit.PalmMm;
            track.TimeUs = timeUs;
            track.MuzzleOffsetMm = fit.MuzzleMm - fit.PalmMm;
            track.Axis = fit.Axis;
            track.AxisSigmaRad = fit.AxisSigmaRad;
            track.Sight = fit.Sight;
            if (fit.HasWeapon)
            {
                track.WeaponSurfaceMm = fit.SurfaceMm;
                track.WeaponOffsetMm = fit.MuzzleMm - fit.SurfaceMm;
                track.GripOffsetMm = fit.PalmMm - fit.SurfaceMm;
                track.WeaponDirection = fit.WeaponDirection;
                track.WeaponUs = timeUs;
            }

            if (!IsAnothers(track, fit) && fit.PersonId != 0)
                track.PersonId = fit.PersonId;
            if (fit.SeemsId != 0)
                track.PersonVotes = Math.Max(0, Math.Min(MaxPersonVotes, track.PersonVotes + (fit.SeemsId == track.PersonId ? 1 : -1)));
        }

        /// <summary>
        /// Across the line of sight half from the hole's outline (which a shadow widens to one side) and half from the motion; along
        /// it from the forearm, which still is measured, and the palm's last position relative to that.
        /// </summary>
        private void Bridge(ref HandTrack track, in ArmFit fit, Vector3D expected, long timeUs, HandObservations observations)
        {
            bool onArm = track.HasLineOffset;
            double z = (expected.Z + fit.PalmMm.Z) / 2;
            Vector3D hole = fit.PalmMm * (1 / fit.PalmMm.Z), ray = expected * (1 / expected.Z);
            if (track.HasVelocity)
                ray = (ray + hole) * 0.5;
            else
                ray = hole;
            if (onArm && ArmFit.TryLineDepth(fit, ray, out double onLine))
                z = onLine + track.LineOffsetMm;
            track.PalmMm = ray * z;
            track.TimeUs = timeUs;
            if (fit.Axis.LengthSquared > 0)
                track.Axis = fit.Axis;
            double sigma = _settings.PalmSigmaMm * 1.5;
            observations.Add(Observe(track, sigma, Math.Sqrt(sigma * sigma + _settings.MuzzleSigmaMm * _settings.MuzzleSigmaMm), DepthSource.Bridged));
        }

        /// <summary>A hand that no arm of this frame explains goes on as expected while the sensor is blind there, for a short time.</summary>
        private void Carry(ref HandTrack track, DepthGrid grid, long timeUs, HandObservations observations)
        {
            long blindUs = timeUs - track.MeasuredUs;
            Vector3D expected = track.Predict(timeUs);
            if (blindUs > _settings.BridgeUs
                || !HoleProbe.IsHole(grid, expected, 0.25 * _settings.HandLengthMm, _settings.LostShare))
                return;
            track.PalmMm = expected;
            track.TimeUs = timeUs;
            double sigma = _settings.PalmSigmaMm * (1 + blindUs / NominalFrameUs);
            observations.Add(Observe(track, sigma, Math.Sqrt(sigma * sigma + _settings.MuzzleSigmaMm * _settings.MuzzleSigmaMm), DepthSource.Bridged));
        }

        private HandObservation Observe(in HandTrack track, double sigma, double muzzleSigma, DepthSource source) => new HandObservation
        {
            TrackId = track.Id,
            PersonId = track.PersonId,
            Side = track.SideVotes >= NeededVotes ? HandSide.Right : track.SideVotes <= -NeededVotes ? HandSide.Left : HandSide.Unknown,
            PalmMm = track.PalmMm,
            MuzzleMm = track.PalmMm + track.MuzzleOffsetMm,
            AimDirection = track.Axis,
            SigmaMm = sigma,
            MuzzleSigmaMm = muzzleSigma,
            AimSigmaRad = track.AxisSigmaRad,
            SightDirection = track.Sight,
            SightSigmaRad = _settings.SightSigmaRad,
            DepthSource = source,
        };
    }
}
