using LaserTracking.Hands;

namespace LaserTracking.Simulation
{
    /// <summary>One trainee: where they stand, how they hold the weapon, how well they aim.</summary>
    public sealed class ShooterSettings
    {
        public string Name { get; set; } = "";

        /// <summary>Where the feet stand, metres to the right of the screen's middle.</summary>
        public double OffsetXM { get; set; }

        /// <summary>Metres from the screen.</summary>
        public double DistanceM { get; set; } = 2.3;

        public double HeightM { get; set; } = 1.78;

        /// <summary>The hand that holds the weapon: Left or Right.</summary>
        public HandSide Hand { get; set; } = HandSide.Right;

        /// <summary>The other hand supports the weapon hand; otherwise it hangs down.</summary>
        public bool TwoHanded { get; set; }

        public LaserSettings Laser { get; } = new LaserSettings();

        public TremorSettings Tremor { get; } = new TremorSettings();

        /// <summary>Standard deviation of the aim per shot along each axis, mrad; not for shots at a screen point.</summary>
        public double AimErrorMrad { get; set; } = 6;

        /// <summary>Standard deviation of the fixed angle between the weapon's barrel and its light along each axis, mrad.</summary>
        public double BoresightErrorMrad { get; set; } = 3;

        internal void Visit(ScenarioVisitor v)
        {
            Name = v.Text("name", Name);
            OffsetXM = v.Number("offset_x_m", OffsetXM, -50, 50);
            DistanceM = v.Number("distance_m", DistanceM, 1, 50);
            HeightM = v.Number("height_m", HeightM, 1, 2.5);
            Hand = v.Choice("hand", Hand);
            TwoHanded = v.Flag("two_handed", TwoHanded);
            v.Group("laser", Laser.Visit);
            v.Group("tremor", Tremor.Visit);
            AimErrorMrad = v.Number("aim_error_mrad", AimErrorMrad, 0, 200);
            BoresightErrorMrad = v.Number("boresight_error_mrad", BoresightErrorMrad, 0, 200);
            if (Hand == HandSide.Unknown)
                v.Refuse("hand", "is unknown", "give left or right");
        }
    }
}
