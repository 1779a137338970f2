using System.Collections.Generic;

namespace LaserTracking.Unity
{
    /// <summary>What a trainer may choose on the player's command line. Arguments that are not ours are Unity's and passed over.</summary>
    public sealed class PlayerArguments
    {
        /// <summary>For help texts.</summary>
        public const string Usage = "[-range-scene NAME] [-range-calibration FILE] [-range-source NAME] [-range-hand-source NAME]";

        private PlayerArguments()
        {
        }

        /// <summary>Name of the scene to play; empty: the first.</summary>
        public string Scene { get; private set; } = "";

        /// <summary>File of the screen's calibration; empty: the scene's own.</summary>
        public string Calibration { get; private set; } = "";

        /// <summary>Name of camera 0's source; empty: the scene's own.</summary>
        public string Source { get; private set; } = "";

        /// <summary>Name of camera 1's source; empty: the scene's own.</summary>
        public string HandSource { get; private set; } = "";

        /// <param name="arguments">As the operating system gives them.</param>
        /// <param name="parsed">Valid only when true is returned.</param>
        /// <param name="problem">What is wrong, one line.</param>
        public static bool TryParse(IReadOnlyList<string> arguments, out PlayerArguments parsed, out string problem)
        {
            parsed = new PlayerArguments();
            problem = "";
            for (int i = 0; i < arguments.Count; i++)
            {
                string name = arguments[i];
                if (!name.StartsWith("-range-", System.StringComparison.Ordinal))
                    continue;
                string value = i + 1 < arguments.Count ? arguments[i + 1] : "";
                if (value.Length == 0 || value[0] == '-')
                {
                    problem = name + " needs a value; use " + Usage;
                    return false;
                }

                switch (name)
                {
                    case "-range-scene": parsed.Scene = value; break;
                    case "-range-calibration": parsed.Calibration = value; break;
                    case "-range-source": parsed.Source = value; break;
                    case "-range-hand-source": parsed.HandSource = value; break;
                    default:
                        problem = name + " is not known; use " + Usage;
                        return false;
                }

                i++;
            }

            return true;
        }
    }
}
