using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// One shooter's body as a function of time, put together backwards from the light: the weapon lies on the line from the eye to
    /// the aim, the muzzle on the line to the dot, elbow and shoulder follow. With one hand the body is turned sideways, which brings
    /// the shoulder under the line of sight; with two it faces the screen. Proportions of the body: Drillis and Contini 1966.
    /// </summary>
    internal sealed class ShooterMotion
    {
        private const double GripToBoreM = 0.05;
        private const double GripToMuzzleM = 0.15;
        private const double WristToPalmM = 0.08;
        private const double SidewaysRad = 0.95;

        private readonly AimPath _aim;
        private readonly ShooterSettings _settings;
        private readonly Vector3D _feet;
        private readonly Rotation3D _boresight;

        public ShooterMotion(ShooterSettings settings, AimPath aim, Vector3D feetM, Rotation3D boresight)
        {
            _settings = settings;
            _aim = aim;
            _feet = feetM;
            _boresight = boresight;
        }

        public Vector3D FeetM => _feet;

        /// <summary>+1 for right-handed, -1 for left-handed.</summary>
        public double Side => _settings.Hand == HandSide.Left ? -1 : 1;

        public Vector2D DotM(double timeS) => _aim.PointM(timeS);

        public TrueHand Hand(double timeS)
        {
            TrueHand hand = Still(timeS);
            const double step = 0.004;
            hand.SpeedMPerS = (Still(timeS + step).PalmM - Still(timeS - step).PalmM).Length / (2 * step);
            return hand;
        }

        public BodyPose Body(double timeS)
        {
            double h = _settings.HeightM, side = Side;
            var body = new BodyPose { Weapon = Hand(timeS) };
            body.HeadM = Eye() + new Vector3D(-side * 0.03, 0.006 * h, -0.08);
            body.ShoulderAxis = (Shoulder(side) - Shoulder(-side)).Normalized * side;
            body.NeckM = _feet + new Vector3D(0, -0.84 * h, 0.02);
            body.HipM = _feet + new Vector3D(0, -0.52 * h, -0.02);
            Vector3D shoulder = Shoulder(-side), palm, wrist;
            if (_settings.TwoHanded)
            {
                palm = body.Weapon.PalmM + new Vector3D(-side * 0.045, 0.02, 0.015);
                wrist = palm - (palm - shoulder).Normalized * WristToPalmM;
            }
            else
            {
                palm = shoulder + new Vector3D(-side * 0.06, 0.36 * h, 0.03);
                wrist = palm - new Vector3D(0, WristToPalmM, 0);
            }

            body.SupportShoulderM = shoulder;
            body.SupportPalmM = palm;
            body.SupportWristM = wrist;
            body.SupportElbowM = Elbow(shoulder, wrist, new Vector3D(-side * 0.6, 1, -0.2));
            return body;
        }

        private TrueHand Still(double timeS)
        {
            double h = _settings.HeightM, side = Side;
            Vector2D dot = _aim.PointM(timeS);
            var dotPoint = new Vector3D(dot.X, dot.Y, 0);
            Vector3D eye = Eye();
            Vector3D shoulder = Shoulder(side);
            Vector3D sight = (dotPoint - eye).Normalized;
            // The palm: a little below the line of sight, where the nearly straight arm reaches it.
            Vector3D origin = eye + new Vector3D(0, 0.07, 0) - shoulder;
            double reach = (_settings.TwoHanded ? 0.97 : 0.985) * (0.186 + 0.146) * h + WristToPalmM;
            double b = Vector3D.Dot(origin, sight), c = origin.LengthSquared - reach * reach;
            double along = -b + Math.Sqrt(Math.Max(0, b * b - c));
            Vector3D palm = shoulder + origin + sight * along;
            Vector3D bore = palm - new Vector3D(0, GripToBoreM, 0);
            Vector3D light = (dotPoint - bore).Normalized;
            Vector3D wrist = palm - (palm - shoulder).Normalized * WristToPalmM;
            return new TrueHand
            {
                ShoulderM = shoulder,
                // As near behind the weapon as the arm allows: the forearm takes the recoil.
                ElbowM = Elbow(shoulder, wrist, wrist - light * (0.146 * h) - shoulder + new Vector3D(side * 0.01, 0.01, 0)),
                WristM = wrist,
                PalmM = palm,
                MuzzleM = bore + light * GripToMuzzleM,
                LightDirection = light,
                BarrelDirection = _boresight * light,
                DotM = dot,
            };
        }

        // With a weapon up the head comes down a little and the shoulders rise.
        private double TurnRad => _settings.TwoHanded ? 0 : SidewaysRad;

        private Vector3D Eye() => _feet + new Vector3D(Side * (_settings.TwoHanded ? 0.03 : 0.08), -0.922 * _settings.HeightM, 0.12);

        // The weapon's shoulder comes forward when the body turns.
        private Vector3D Shoulder(double side)
        {
            double half = 0.115 * _settings.HeightM;
            return _feet + new Vector3D(side * half * Math.Cos(TurnRad), -0.825 * _settings.HeightM, 0.04 + side * Side * half * Math.Sin(TurnRad));
        }

        private Vector3D Elbow(Vector3D shoulder, Vector3D wrist, Vector3D wanted)
        {
            double upper = 0.186 * _settings.HeightM, fore = 0.146 * _settings.HeightM;
            Vector3D axis = wrist - shoulder;
            double distance = Math.Max(1e-6, axis.Length);
            axis = axis.Normalized;
            double along = Math.Max(0, Math.Min(upper, (upper * upper - fore * fore + distance * distance) / (2 * distance)));
            Vector3D bend = (wanted - axis * Vector3D.Dot(wanted, axis)).Normalized;
            return shoulder + axis * along + bend * Math.Sqrt(Math.Max(0, upper * upper - along * along));
        }
    }
}
