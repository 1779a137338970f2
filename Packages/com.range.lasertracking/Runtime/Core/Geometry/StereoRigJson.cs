using System;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Two cameras in calibration files: "left" and "right" as in <see cref="LensCameraJson"/>, "R":[[…]] and "T":[…] with
    /// x_right = R x_left + T, T in mm.
    /// </summary>
    public static class StereoRigJson
    {
        /// <summary>Reads a calibration of kind "stereo".</summary>
        /// <exception cref="InputException">Missing, not JSON, of another kind or a newer version, or a field that is absent or impossible.</exception>
        public static StereoRig ReadFile(string path)
        {
            JObject root = CalibrationJson.ReadFile(path);
            CalibrationJson.CheckKind(root, path, "stereo", "'./range calibrate stereo'");
            return Parse(root, path);
        }

        /// <param name="root">Holds left, right, R and T.</param>
        /// <param name="name">The file as the user named it, for messages.</param>
        /// <exception cref="InputException">A field that is absent, not finite or impossible.</exception>
        public static StereoRig Parse(JObject root, string name)
        {
            LensCamera left = Camera(root, "left", name), right = Camera(root, "right", name);
            if (!Rotation3D.TryFromMatrix(CalibrationJson.Matrix(root["R"], 3, name, "R"), out Rotation3D rotation))
                throw new InputException(name, "field R is no rotation", CalibrationJson.Remedy);
            double[] t = CalibrationJson.Numbers(root["T"], 3, name, "T");
            return new StereoRig(left, right, new Pose(new Vector3D(t[0], t[1], t[2]), rotation));
        }

        /// <summary>The four fields.</summary>
        public static JObject Format(StereoRig rig) => new JObject
        {
            ["left"] = LensCameraJson.Format(rig.Left),
            ["right"] = LensCameraJson.Format(rig.Right),
            ["R"] = CalibrationJson.Rows(rig.LeftToRight.Rotation.ToMatrix(), 3),
            ["T"] = new JArray(rig.LeftToRight.Position.X, rig.LeftToRight.Position.Y, rig.LeftToRight.Position.Z),
        };

        private static LensCamera Camera(JObject root, string side, string name) => root[side] is JObject camera
            ? LensCameraJson.Parse(camera, name, side + ".")
            : throw new InputException(name, FormattableString.Invariant($"field {side} must be a camera"), CalibrationJson.Remedy);
    }
}
