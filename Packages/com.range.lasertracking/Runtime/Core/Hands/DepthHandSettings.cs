using System;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Settings of <see cref="DepthHandTracker"/>. Lengths in millimetres, areas in square millimetres. Defaults fit adults who stand
    /// 0.8 to 3 m in front of an Azure Kinect class camera that looks at them from the screen.
    /// </summary>
    public sealed class DepthHandSettings
    {
        /// <summary>Nearest distance that counts. Below 400 mm the sensor is unreliable (the published bound).</summary>
        public double NearMm { get; set; } = 400;

        /// <summary>
        /// Farthest distance that counts, bodies included: the torso behind a hand tells arm from body. 3000 mm because noise reaches
        /// 17 mm and a palm is under 16 px wide there. Lower it to cut off what stands behind the trainees.
        /// </summary>
        public double FarMm { get; set; } = 3000;

        /// <summary>
        /// Width of a grid cell in radians; pixels are gathered into cells of this size. 8 mrad is 8 mm at 1 m: ten cells across a
        /// palm, and four pixels of the 640×576 mode.
        /// </summary>
        public double CellRad { get; set; } = 0.008;

        /// <summary>
        /// Largest step between neighbouring cells of one surface. Above the step of a forearm seen at 80° and the sensor's noise,
        /// below the 100 mm by which an aiming arm stands clear of what is behind it.
        /// </summary>
        public double SurfaceStepMm { get; set; } = 60;

        /// <summary>Longest hole in a row or column that is filled from its two ends: half a palm.</summary>
        public double HoleMm { get; set; } = 50;

        /// <summary>
        /// How far before the torso a part counts as an arm. Above what a head or a belly stands out (about 150 mm), below the reach
        /// of an aiming arm (450 mm).
        /// </summary>
        public double ForwardMm { get; set; } = 180;

        /// <summary>
        /// How far before the body an arm's end must reach. An aiming hand is 400 mm and more away, a head that leans forward and a
        /// hand that hangs or rests are not.
        /// </summary>
        public double MinReachMm { get; set; } = 280;

        /// <summary>From the crown down to the eyes: adult mean 115 mm.</summary>
        public double EyeBelowCrownMm { get; set; } = 115;

        /// <summary>Standard deviation of the line from the eyes over the muzzle about one axis: 70 mm of the head over 0.6 m.</summary>
        public double SightSigmaRad { get; set; } = 0.12;

        /// <summary>From the forearm's visible surface to its middle: its radius.</summary>
        public double ForearmRadiusMm { get; set; } = 30;

        /// <summary>Half the width of the body over which the torso's distance is taken (median): half a shoulder width.</summary>
        public double TorsoHalfWidthMm { get; set; } = 200;

        /// <summary>Smallest visible surface of an arm; below it is noise or a finger.</summary>
        public double MinArmAreaMm2 { get; set; } = 3000;

        /// <summary>Largest visible surface of an arm, or of two that hold one weapon; a larger part is itself a body.</summary>
        public double MaxArmAreaMm2 { get; set; } = 120000;

        /// <summary>Largest visible surface of the last <see cref="HandLengthMm"/>; heads have 30000 and more.</summary>
        public double MaxHandAreaMm2 { get; set; } = 22000;

        /// <summary>Wrist to fingertips (adult mean 170 to 190 mm).</summary>
        public double HandLengthMm { get; set; } = 170;

        /// <summary>How far behind the hand the forearm is looked at for the arm's axis.</summary>
        public double ForearmLengthMm { get; set; } = 250;

        /// <summary>
        /// Standard deviation between the eyes as found and the point over which the weapon is aimed, along one axis: posture, the
        /// shape of the head and hair.
        /// </summary>
        public double EyeSigmaMm { get; set; } = 45;

        /// <summary>The same of the height alone: crown to eyes, hair and caps.</summary>
        public double EyeHeightSigmaMm { get; set; } = 25;

        /// <summary>From the visible surface to the middle of the hand: half a palm's thickness.</summary>
        public double HandHalfThicknessMm { get; set; } = 13;

        /// <summary>
        /// Narrowest part that counts as the hand; a narrower one before it is a weapon, and its end the muzzle. Slides and barrels
        /// are up to 40 mm wide, fists at least 70.
        /// </summary>
        public double MinHandWidthMm { get; set; } = 52;

        /// <summary>Longest narrow part before the hand that counts as a weapon: pistols reach 130 mm beyond the fist's front.</summary>
        public double MaxWeaponMm { get; set; } = 250;

        /// <summary>
        /// What is seen about the foremost point lies that close to its middle line (root mean square) if it is a weapon: 10 to 16 mm a pistol's
        /// front, above 22 mm a fist.
        /// </summary>
        public double MaxWeaponSpreadMm { get; set; } = 20;

        /// <summary>Where no weapon is seen: from the palm to the muzzle along the arm. 130 mm fits a pistol held in a fist.</summary>
        public double MuzzleBeyondPalmMm { get; set; } = 130;

        /// <summary>From the middle of the grip to the muzzle along the bore: 150 mm of a full-size pistol. More than <see cref="MuzzleBeyondPalmMm"/>, as a fist's visible front lies before its middle.</summary>
        public double GripToMuzzleMm { get; set; } = 150;

        /// <summary>Standard deviation between forearm and bore about one axis: 15°, the wrist bends and the eye is not in the shoulder.</summary>
        public double WristSigmaRad { get; set; } = 0.26;

        /// <summary>The same for two arms on one weapon, of which the axis is that of one or of both: a shoulder beside the line, over an arm's length.</summary>
        public double TwoArmsSigmaRad { get; set; } = 0.5;

        /// <summary>How far a pistol's bore lies above the middle of the hand that holds it.</summary>
        public double BoreAboveGripMm { get; set; } = 50;

        /// <summary>
        /// A weapon's thin end comes and goes in depth. While the hand has moved less than this since it was seen, it is where it was on
        /// the hand.
        /// </summary>
        public double WeaponKeptMm { get; set; } = 80;

        /// <summary>For how long that holds, microseconds.</summary>
        public long WeaponKeptUs { get; set; } = 1_000_000;

        /// <summary>Standard deviation of the sensor and of the hand's shape together, along one axis.</summary>
        public double PalmSigmaMm { get; set; } = 12;

        /// <summary>The same of a palm that is hardly seen: hidden with its weapon, cut off, or of two arms. On the simulated range such palms were off by 40 to 100 mm.</summary>
        public double HiddenPalmSigmaMm { get; set; } = 60;

        /// <summary>Smallest visible surface of a hand that is seen whole; a fist shows 9500 to 16000.</summary>
        public double MinPalmAreaMm2 { get; set; } = 9000;

        /// <summary>Standard deviation across the bore of a muzzle that is seen pixel by pixel; twice that of one of which only cells tell. Measured on the simulated range at 2.4 to 2.7 m: 2 to 4 mm.</summary>
        public double SeenMuzzleSigmaMm { get; set; } = 3.5;

        /// <summary>Standard deviation of a muzzle that is not seen itself, along one axis.</summary>
        public double MuzzleSigmaMm { get; set; } = 35;

        /// <summary>The same of an arm that reaches the edge of what the camera sees: somewhere within half an arm along itself, much less across.</summary>
        public double CutSigmaMm { get; set; } = 90;

        /// <summary>How far a hand may be from where its track expects it, one frame later: 3 m/s at 15 frames/s.</summary>
        public double TrackGateMm { get; set; } = 200;

        /// <summary>How long an unseen hand keeps its track, microseconds.</summary>
        public long TrackMemoryUs { get; set; } = 500_000;

        /// <summary>How long a hand whose depth is lost goes on being reported as bridged, microseconds.</summary>
        public long BridgeUs { get; set; } = 300_000;

        /// <summary>Share of invalid cells where the hand should be, from which its depth counts as lost.</summary>
        public double LostShare { get; set; } = 0.5;

        /// <summary>Largest number of hands at once; further ones are ignored, farthest first.</summary>
        public int MaxHands { get; set; } = 12;

        /// <exception cref="ArgumentException">A value is outside its range.</exception>
        public void Validate()
        {
            Check(NearMm >= 0 && FarMm > NearMm && FarMm <= 20000, "0 <= NearMm < FarMm <= 20000");
            Check(CellRad > 0.0005 && CellRad < 0.1, "CellRad between 0.0005 and 0.1");
            Check(SurfaceStepMm > 0 && HoleMm >= 0 && ForwardMm > 0 && MinReachMm >= 0 && EyeBelowCrownMm >= 0 && EyeSigmaMm > 0 && EyeHeightSigmaMm > 0 && SightSigmaRad > 0 && ForearmRadiusMm >= 0 && TorsoHalfWidthMm > 0, "lengths above zero");
            Check(MinArmAreaMm2 > 0 && MaxArmAreaMm2 > MinArmAreaMm2 && MaxHandAreaMm2 > MinArmAreaMm2, "areas above zero, limits in order");
            Check(HandLengthMm > 0 && ForearmLengthMm > 0 && HandHalfThicknessMm >= 0 && MinHandWidthMm >= 0, "sizes of the hand above zero");
            Check(MaxWeaponSpreadMm >= 0 && MuzzleBeyondPalmMm >= 0 && GripToMuzzleMm >= 0 && WristSigmaRad > 0 && TwoArmsSigmaRad >= 0 && BoreAboveGripMm >= 0 && WeaponKeptMm >= 0 && WeaponKeptUs >= 0 && PalmSigmaMm > 0 && HiddenPalmSigmaMm > 0 && SeenMuzzleSigmaMm > 0 && MuzzleSigmaMm > 0 && CutSigmaMm > 0, "uncertainties above zero");
            Check(MinPalmAreaMm2 >= 0, "MinPalmAreaMm2 not negative");
            Check(TrackGateMm > 0 && TrackMemoryUs >= 0 && BridgeUs >= 0, "TrackGateMm above zero, times not negative");
            Check(LostShare > 0 && LostShare <= 1, "LostShare above 0, at most 1");
            Check(MaxHands >= 1 && MaxHands <= 64, "MaxHands 1…64");
        }

        private static void Check(bool condition, string rule)
        {
            if (!condition)
                throw new ArgumentException("depth hand settings: " + rule);
        }
    }
}
