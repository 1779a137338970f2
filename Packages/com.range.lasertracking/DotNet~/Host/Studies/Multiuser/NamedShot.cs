using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Session;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Multiuser
{
    /// <summary>A shot as reported and as fired.</summary>
    /// <param name="Said">As reported.</param>
    /// <param name="Fired">As it was.</param>
    /// <param name="Meant">The person whom the reported number stands for, from 1; 0: nobody was named.</param>
    /// <param name="IsSwitch">This person's last named shot had another number.</param>
    /// <param name="IsArmSeen">Forearm, hand and muzzle lie in camera 1's view.</param>
    /// <param name="WhyNot">Why it was not named rightly; empty where it was.</param>
    internal sealed record NamedShot(ShotEvent Said, TrueShot Fired, int Meant, bool IsSwitch, bool IsArmSeen, string WhyNot)
    {
        public bool IsNamed => Said.Shooter > 0;

        public bool IsRight => IsNamed && Meant == Fired.Shooter;

        public bool HasRightMuzzle => IsRight && Said.HasMuzzle;

        public bool IsSideSaid => IsRight && Said.Hand != HandSide.Unknown;

        public double MuzzleErrorMm => (Said.MuzzleM - Fired.MuzzleM).Length * 1000;

        public double DirectionErrorDeg => Math.Acos(Math.Clamp(Vector3D.Dot(Said.Direction, Fired.Direction) / (Said.Direction.Length * Fired.Direction.Length), -1, 1)) * 180 / Math.PI;
    }
}
