using System;

namespace LaserTracking.Fusion
{
    /// <summary>Settings of <see cref="ShooterAssignment"/> and <see cref="HandHistory"/>.</summary>
    public sealed class FusionSettings
    {
        public FusionMode Mode { get; set; } = FusionMode.Assigned;

        /// <summary>Largest distance in time between a shot and a hand, microseconds. Published: 1.0 s.</summary>
        public long WindowUs { get; set; } = 1_000_000;

        /// <summary>
        /// Two sightings of a hand farther apart than this are not interpolated between; the nearer is taken as it is. 250 ms: a
        /// hand can go and come back in more.
        /// </summary>
        public long MaxInterpolationUs { get; set; } = 250_000;

        /// <summary>ε of d̂ = v / (|v| + ε), metres. Published without a value; only keeps the division from failing.</summary>
        public double EpsilonM { get; set; } = 1e-9;

        /// <summary>
        /// Standard deviation between forearm and barrel about one axis, radians. 15°: the arm comes from the shoulder, the line of
        /// fire from the eye, 0.2 m apart over an arm's length, and the wrist bends.
        /// </summary>
        public double WristSigmaRad { get; set; } = 0.26;

        /// <summary>Share of shots fired along the sights (eye over muzzle) rather than along the arm, where the head is seen.</summary>
        public double SightedShare { get; set; } = 0.93;

        /// <summary>Standard deviation between the line of sight over the muzzle and the light about one axis, radians, beside what the tracker says.</summary>
        public double SightSpreadRad { get; set; } = 0.003;

        /// <summary>How far the bore lies below the line from the eye over the sights, metres.</summary>
        public double SightHeightM { get; set; } = 0.025;

        /// <summary>For how many shots the expected spread counts beside what is seen of somebody's own.</summary>
        public double SpreadShots { get; set; } = 2.5;

        /// <summary>So much smaller than expected, at most, is somebody's spread believed to be.</summary>
        public double MinSpreadScale { get; set; } = 0.25;

        /// <summary>A shot teaches where somebody aims over only when it is theirs with that probability: a wrong one spoils what follows.</summary>
        public double LearnProbability { get; set; } = 0.5;

        /// <summary>Share of shots fired from a swing, the muzzle faster than <see cref="SwingMPerS"/> across its line.</summary>
        public double SwingShare { get; set; } = 0.12;

        /// <summary>Share of the time in which the weapon of somebody who does not fire just then swings.</summary>
        public double IdleSwingShare { get; set; } = 0.4;

        /// <summary>Metres a second: tremor and sway stay below a tenth of it, swings to the next target reach three times it.</summary>
        public double SwingMPerS { get; set; } = 0.2;

        /// <summary>Share of sightings that are far worse than they say (a finger taken for the barrel), with three times the standard deviation.</summary>
        public double PoorSightShare { get; set; } = 0.05;

        /// <summary>How much a hand still counts whose forearm points elsewhere than its sight line: bent elbows do.</summary>
        public double BentArmShare { get; set; } = 0.2;

        /// <summary>Growth of the aim's standard deviation with the distance in time to the nearest sighting, radians a second.</summary>
        public double AimDriftRadPerS { get; set; } = 0.15;

        /// <summary>Growth of the muzzle's standard deviation with the same, metres a second.</summary>
        public double MuzzleDriftMPerS { get; set; } = 0.5;

        /// <summary>Share of shots whose line has nothing to do with the arm seen (a bent wrist, a wrong arm): spread over all directions.</summary>
        public double OutlierShare { get; set; } = 0.005;

        /// <summary>Probability, before anything is seen, that a shot came from none of the hands in sight.</summary>
        public double NobodyPrior { get; set; } = 0.015;

        /// <summary>How much less likely than a person a hand whose person is not known is to fire: half a second of a chair, a raised foot.</summary>
        public double StrangerShare { get; set; } = 0.3;

        /// <summary>Probability that somebody whose weapon is not seen fires although it should be in camera 1's picture: hidden behind an arm or a body.</summary>
        public double HiddenShare { get; set; } = 0.3;

        /// <summary>The same where it would be outside the picture.</summary>
        public double OutOfViewShare { get; set; } = 0.6;

        /// <summary>Share of the picture's width and height along each edge that does not count as seen.</summary>
        public double ViewMargin { get; set; } = 0.05;

        /// <summary>From the eyes to the muzzle of somebody who aims and has not fired yet, metres.</summary>
        public double ReachM { get; set; } = 0.7;

        /// <summary>Standard deviation of that between people: with one hand 0.87, with two 0.69.</summary>
        public double ReachSigmaM { get; set; } = 0.18;

        /// <summary>Standard deviation of one person's, who aims at different places.</summary>
        public double ReachSpreadM { get; set; } = 0.05;

        /// <summary>Standard deviation between the bearing of a weapon's picture and its line of fire: 0.07 held with one hand, 0.18 with two.</summary>
        public double BearingSigmaRad { get; set; } = 0.18;

        /// <summary>Probability that somebody fires with a hand that is not seen although a weapon is that surely is theirs.</summary>
        public double SecondWeaponShare { get; set; } = 0.002;

        /// <summary>Weight of a hand that seems to be a neighbour's before its weapon is looked at: arms are given to the nearest head, which may be wrong.</summary>
        public double NeighbourShare { get; set; } = 0.3;

        /// <summary>Over which a shot from nobody in sight is spread evenly, m². The published screen has 8.4.</summary>
        public double ScreenAreaM2 { get; set; } = 8.4;

        /// <summary>
        /// Share of that over which such a shot, and one whose weapon is hidden, is spread: people aim where targets stand, others too. On the simulated range
        /// somebody who does not fire aims within 12 mrad of another's dot ten times as often as evenly over the screen; those who are half hidden, evenly.
        /// </summary>
        public double AimedShare { get; set; } = 0.7;

        /// <summary>Probability that a shooter's next dot shows their usual colour.</summary>
        public double ColorKeptProbability { get; set; } = 0.97;

        /// <summary>
        /// How much more others who aim near the dot count in what is said than in what is reckoned: lines of sight err together more often
        /// than a normal distribution lets them. Fitted so that shooter_p is met (simulated range, seeds 1 to 3).
        /// </summary>
        public double RivalWeight { get; set; } = 1.5;

        /// <summary>
        /// The same of others whose weapon camera 1's picture of just then does not show, above 0. <see cref="HiddenShare"/> is how often a weapon is hidden
        /// where few are; where somebody stands before others it is near 1, and this is its inverse.
        /// </summary>
        public double HiddenRivalWeight { get; set; } = 3;

        /// <summary>Below this probability the shooter is unknown.</summary>
        public double MinProbability { get; set; } = 0.9;

        /// <summary>A muzzle that far from a shooter's last one, when their own hand is no longer seen, is theirs again. Metres.</summary>
        public double RelinkM { get; set; } = 0.35;

        /// <summary>For how long a shooter is remembered at their last place, microseconds.</summary>
        public long RelinkUs { get; set; } = 20_000_000;

        /// <summary>Two tracks that close to each other while both are seen hold one weapon. Below half the 0.4 m between neighbours.</summary>
        public double SameWeaponM { get; set; } = 0.18;

        /// <summary>Shots of one frame that are examined together; further ones go to nobody.</summary>
        public int MaxShots { get; set; } = 16;

        /// <summary>Hands that are considered for one shot.</summary>
        public int MaxHands { get; set; } = 16;

        /// <summary>Sightings kept, over all hands: 2 s of 12 hands at 30 frames/s, and some.</summary>
        public int HistoryLength { get; set; } = 1024;

        /// <summary>Over which shots of unseen weapons are spread evenly, m².</summary>
        internal double AimedAreaM2 => AimedShare * ScreenAreaM2;

        /// <exception cref="ArgumentException">A value is outside its range.</exception>
        public void Validate()
        {
            Check(WindowUs >= 0 && MaxInterpolationUs >= 0 && RelinkUs >= 0, "times not negative");
            Check(EpsilonM >= 0 && RelinkM >= 0 && SameWeaponM >= 0, "lengths not negative");
            Check(WristSigmaRad > 0 && AimDriftRadPerS >= 0 && MuzzleDriftMPerS >= 0, "WristSigmaRad above zero, drifts not negative");
            Check(SwingShare > 0 && SwingShare < 1 && IdleSwingShare > 0 && IdleSwingShare < 1 && SwingMPerS > 0, "SwingShare and IdleSwingShare between 0 and 1, SwingMPerS above zero");
            Check(LearnProbability >= 0 && LearnProbability <= 1 && SpreadShots > 0 && MinSpreadScale > 0, "LearnProbability 0…1, SpreadShots and MinSpreadScale above zero");
            Check(SightedShare >= 0 && SightedShare <= 1 && SightSpreadRad >= 0, "SightedShare 0…1, SightSpreadRad not negative");
            Check(Math.Abs(SightHeightM) <= 1, "SightHeightM at most 1 m up or down");
            Check(PoorSightShare >= 0 && PoorSightShare < 1 && BentArmShare > 0 && BentArmShare <= 1, "PoorSightShare 0…1, BentArmShare above 0, at most 1");
            Check(OutlierShare >= 0 && OutlierShare < 1, "OutlierShare at least 0, below 1");
            Check(NobodyPrior > 0 && NobodyPrior < 1, "NobodyPrior between 0 and 1");
            Check(StrangerShare > 0 && HiddenShare >= 0 && HiddenShare < 1 && OutOfViewShare >= 0 && OutOfViewShare < 1, "StrangerShare above 0, HiddenShare and OutOfViewShare at least 0, below 1");
            Check(ViewMargin >= 0 && ViewMargin < 0.5 && ReachM > 0 && ReachSigmaM > 0 && ReachSpreadM > 0 && BearingSigmaRad > 0 && SecondWeaponShare >= 0 && SecondWeaponShare <= 1 && NeighbourShare >= 0 && NeighbourShare <= 1, "ViewMargin 0…0.5, lengths and BearingSigmaRad above zero, SecondWeaponShare and NeighbourShare 0…1");
            Check(ScreenAreaM2 > 0 && AimedShare > 0 && AimedShare <= 1, "ScreenAreaM2 above zero, AimedShare above 0, at most 1");
            Check(ColorKeptProbability > 0.25 && ColorKeptProbability < 1, "ColorKeptProbability between 0.25 and 1");
            Check(RivalWeight > 0 && HiddenRivalWeight > 0, "RivalWeight and HiddenRivalWeight above zero");
            Check(MinProbability >= 0 && MinProbability <= 1, "MinProbability 0…1");
            Check(MaxShots >= 1 && MaxShots <= 64 && MaxHands >= 1 && MaxHands <= 64, "MaxShots and MaxHands 1…64");
            Check(HistoryLength >= 16 && HistoryLength <= 1 << 20, "HistoryLength 16…1048576");
        }

        private static void Check(bool condition, string rule)
        {
            if (!condition)
                throw new ArgumentException("fusion settings: " + rule);
        }
    }
}
