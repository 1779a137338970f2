using System.Collections.Generic;
using System.Linq;

namespace LaserTracking.Editor
{
    /// <summary>Says of a set-up what is active, what is missing, and the one thing to do next.</summary>
    public static class SetupCheck
    {
        /// <summary>In the order in which one sets a range up.</summary>
        public static IReadOnlyList<SetupLine> Check(SetupFacts facts)
        {
            // First of all: until it compiles, nothing else that is done takes effect.
            List<SetupLine> lines = facts.LibraryProblems.Select(problem => new SetupLine("libraries", SetupState.Missing, problem)).ToList();
            lines.Add(Range(facts));
            if (facts.Ranges > 0)
            {
                lines.Add(Source(facts));
                lines.Add(Screen(facts));
                if (facts.HasScreen)
                    lines.Add(Calibration(facts));
                lines.Add(facts.HasViewpoint
                    ? new SetupLine("viewpoint", SetupState.Active, "shots are cast from it through the screen")
                    : new SetupLine("viewpoint", SetupState.Missing, "drag the camera that draws the picture into the LaserRange, or tag it MainCamera"));
                lines.Add(Targets(facts));
                lines.Add(facts.HasHandCamera
                    ? new SetupLine("camera 1", SetupState.Active, "who fired is known where the calibration says where it stands")
                    : new SetupLine("camera 1", SetupState.Asleep, "not used: nobody knows who fires; drag a depth source into Hand Source"));
            }

            lines.Add(Library("Azure Kinect and Femto", facts.IsKinectAwake, "install the wrapper (Documentation~/cameras.md)"));
            lines.Add(Library("OpenCV webcams", facts.IsOpenCvAwake, "install OpenCvSharp and define RANGE_OPENCV (Documentation~/cameras.md)"));
            lines.Add(Library("calibration of lenses and camera pairs", facts.IsMathNetAwake, "install MathNet.Numerics, or calibrate with range calibrate"));
            return lines;
        }

        /// <summary>What to do first; empty when nothing is missing.</summary>
        public static string NextStep(IEnumerable<SetupLine> lines)
        {
            SetupLine[] open = lines.Where(line => line.State >= SetupState.Advised).ToArray();
            foreach (SetupState state in new[] { SetupState.Missing, SetupState.Advised })
            {
                foreach (SetupLine line in open.Where(line => line.State == state))
                    return line.Name + ": " + line.Text;
            }

            return "";
        }

        private static SetupLine Range(SetupFacts facts)
        {
            if (facts.Ranges == 0)
                return new SetupLine("range", SetupState.Missing, "choose GameObject > Laser Tracking > Laser Range");
            return facts.Ranges == 1 ? new SetupLine("range", SetupState.Active, "the scene has a LaserRange")
                : new SetupLine("range", SetupState.Advised, "the scene has " + facts.Ranges + " of them; leave one, or give each a camera of its own");
        }

        private static SetupLine Source(SetupFacts facts) => facts.Source.Length > 0
            ? new SetupLine("camera 0", SetupState.Active, facts.Source)
            : new SetupLine("camera 0", SetupState.Missing, "drag a source into the LaserRange; Create > Laser Tracking > Simulation Source needs no camera");

        private static SetupLine Screen(SetupFacts facts)
        {
            if (!facts.HasScreen)
                return new SetupLine("screen", SetupState.Missing, "drag a ScreenSurface into the LaserRange");
            return facts.HasScreenSize ? new SetupLine("screen", SetupState.Active, "it has a size") : new SetupLine("screen", SetupState.Missing, "give the ScreenSurface the size of the projected picture in metres");
        }

        private static SetupLine Calibration(SetupFacts facts)
        {
            if (facts.CalibrationProblem.Length > 0)
                return new SetupLine("calibration", SetupState.Missing, facts.CalibrationProblem);
            return facts.HasCalibration ? new SetupLine("calibration", SetupState.Active, "shots have a place on the screen")
                : new SetupLine("calibration", SetupState.Missing, "calibrate with a CalibrationScreen or range calibrate, and drag the file into the ScreenSurface");
        }

        private static SetupLine Targets(SetupFacts facts)
        {
            if (facts.Targets == 0)
                return new SetupLine("targets", SetupState.Advised, "nothing can be hit: put LaserTarget on an object with a collider");
            return facts.TargetsWithoutCollider.Length == 0 ? new SetupLine("targets", SetupState.Active, facts.Targets.ToString(System.Globalization.CultureInfo.InvariantCulture))
                : new SetupLine("targets", SetupState.Missing, "without a collider nothing hits " + string.Join(", ", facts.TargetsWithoutCollider.Take(5)) + "; add one");
        }

        private static SetupLine Library(string name, bool isAwake, string remedy) =>
            isAwake ? new SetupLine(name, SetupState.Active, "its library is there") : new SetupLine(name, SetupState.Asleep, "not there; who needs it: " + remedy);
    }
}
