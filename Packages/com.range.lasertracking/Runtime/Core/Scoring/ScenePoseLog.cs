using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using LaserTracking.Geometry;
using LaserTracking.Session;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// What a scene showed over a session, as lines of JSON: first the scene itself with all that moves as a function of time, then,
    /// for screen, eye and objects that something else moves, a pose whenever it changes. One thread; no allocation per pose once warm.
    /// </summary>
    public sealed class ScenePoseLog : IDisposable
    {
        /// <summary>Number of the screen's surface among the objects.</summary>
        public const int Surface = -1;

        /// <summary>Number of the eye, of whose pose the position counts.</summary>
        public const int Viewpoint = -2;

        private const int Decimals = 9;
        private const int ViewCount = 2;

        private readonly Stream _stream;
        private readonly Sample[] _last;
        private readonly Utf8JsonLineWriter _json = new Utf8JsonLineWriter();

        /// <param name="stream">Written to in whole lines; disposed with this.</param>
        /// <param name="scene">Poses are logged by the numbers of its objects.</param>
        public ScenePoseLog(Stream stream, SceneModel scene)
        {
            _stream = stream;
            _last = new Sample[scene.Objects.Count + ViewCount];
            // While they stay nothing is written, so that they keep their last bit.
            _last[Surface + ViewCount] = new Sample { IsKnown = true, TimeS = double.NegativeInfinity, Pose = scene.Surface };
            _last[Viewpoint + ViewCount] = new Sample { IsKnown = true, TimeS = double.NegativeInfinity, Pose = new Pose(scene.Viewpoint, Rotation3D.Identity) };
            _stream.Write(Encoding.UTF8.GetBytes(SceneModelJson.Format(scene).ToString(Formatting.None) + "\n"));
            _stream.Flush();
        }

        /// <summary>Notes where an object is. Times rise; of an equal or earlier one nothing is kept.</summary>
        /// <param name="objectIndex">Its number in the scene, <see cref="Surface"/> or <see cref="Viewpoint"/>.</param>
        /// <param name="timeS">On the scene's clock.</param>
        /// <param name="pose">In the scene.</param>
        public void Add(int objectIndex, double timeS, Pose pose)
        {
            ref Sample last = ref _last[objectIndex + ViewCount];
            if (last.IsKnown && !(timeS > last.TimeS))
                return;
            bool isSame = last.IsKnown && IsSame(last.Pose, pose);
            // While it rests nothing is written; when it moves on, from where it rested until then.
            if (!isSame && last.IsHeldBack)
                Write(objectIndex, last.TimeS, last.Pose);
            if (!isSame)
                Write(objectIndex, timeS, pose);
            last = new Sample { IsKnown = true, IsHeldBack = isSame, TimeS = timeS, Pose = pose };
        }

        public void Dispose() => _stream.Dispose();

        /// <summary>The scene with all that moved in it. A last line that is cut off is passed over.</summary>
        /// <exception cref="InputException">Missing, or no such log.</exception>
        public static SceneModel Read(string path)
        {
            string[] lines;
            try
            {
                lines = File.ReadAllText(path).Split('\n');
            }
            catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException)
            {
                throw new InputException(path, "cannot be read (" + problem.Message.Replace('\n', ' ').TrimEnd('.') + ")", "check that it is there and may be read");
            }

            SceneModel scene = SceneModelJson.Parse(CalibrationJson.Parse(lines[0], path), path);
            var times = new List<double>?[scene.Objects.Count + ViewCount];
            var poses = new List<Pose>?[scene.Objects.Count + ViewCount];
            for (int i = 1; i < lines.Length - 1; i++)
                ReadPose(CalibrationJson.Parse(lines[i], path + ", line " + (i + 1)), path + ", line " + (i + 1), times, poses);
            return Moved(scene, times, poses);
        }

        private static void ReadPose(JObject line, string name, List<double>?[] times, List<Pose>?[] poses)
        {
            double[] numbers = CalibrationJson.Numbers(new JArray(line["object"] ?? JValue.CreateNull(), line["time_s"] ?? JValue.CreateNull()), 2, name, "object, time_s");
            int item = numbers[0] >= -ViewCount && numbers[0] < times.Length - ViewCount ? (int)numbers[0] + ViewCount : -1;
            if (item < 0)
                throw new InputException(name, "the scene has no such object", "take the file as it was recorded");
            List<double> known = times[item] ??= new List<double>();
            if (known.Count > 0 && !(numbers[1] > known[known.Count - 1]))
                throw new InputException(name, "the time does not lie after the one before", "take the file as it was recorded");
            known.Add(numbers[1]);
            double[] pose = CalibrationJson.Numbers(line["pose"], 7, name, "pose");
            (poses[item] ??= new List<Pose>()).Add(new Pose(new Vector3D(pose[0], pose[1], pose[2]), new Rotation3D(pose[3], pose[4], pose[5], pose[6])));
        }

        private static SceneModel Moved(SceneModel scene, List<double>?[] times, List<Pose>?[] poses)
        {
            PoseTrack? Track(int index) => times[index + ViewCount] == null ? null : new PoseTrack(times[index + ViewCount]!, poses[index + ViewCount]!);
            var objects = new SceneObject[scene.Objects.Count];
            for (int i = 0; i < objects.Length; i++)
                objects[i] = Track(i) is PoseTrack track ? scene.Objects[i].MovedBy(track) : scene.Objects[i];
            return new SceneModel(scene.Name, scene.Surface, scene.ScreenSizeM, scene.Viewpoint, scene.LayerMask, objects, Track(Surface), Track(Viewpoint));
        }

        private static bool IsSame(Pose a, Pose b) => (a.Position.X, a.Position.Y, a.Position.Z) == (b.Position.X, b.Position.Y, b.Position.Z)
            && (a.Rotation.X, a.Rotation.Y, a.Rotation.Z, a.Rotation.W) == (b.Rotation.X, b.Rotation.Y, b.Rotation.Z, b.Rotation.W);

        private void Write(int objectIndex, double timeS, Pose pose)
        {
            _json.BeginObject();
            _json.Name("object");
            _json.Number(objectIndex);
            _json.Name("time_s");
            _json.Number(timeS, Decimals);
            _json.Name("pose");
            _json.BeginArray();
            _json.Number(pose.Position.X, Decimals);
            _json.Number(pose.Position.Y, Decimals);
            _json.Number(pose.Position.Z, Decimals);
            _json.Number(pose.Rotation.X, Decimals);
            _json.Number(pose.Rotation.Y, Decimals);
            _json.Number(pose.Rotation.Z, Decimals);
            _json.Number(pose.Rotation.W, Decimals);
            _json.EndArray();
            _json.EndObject();
            _json.EndLine();
            _stream.Write(_json.Written);
            _json.Clear();
        }

        private struct Sample
        {
            public bool IsKnown;
            public bool IsHeldBack;
            public double TimeS;
            public Pose Pose;
        }
    }
}
