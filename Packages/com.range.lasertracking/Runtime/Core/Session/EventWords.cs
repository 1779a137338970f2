using System;
using LaserTracking.Detection;
using LaserTracking.Hands;

namespace LaserTracking.Session
{
    /// <summary>
    /// The words that events.jsonl uses for enumerations: the member's name in lower case with underscores ("not_isolated"), so
    /// that a new member has its word at once. Documentation~/events.md lists them.
    /// </summary>
    public static class EventWords
    {
        private static readonly string[] Colors = WordsOf(typeof(LaserColor));
        private static readonly string[] Reasons = WordsOf(typeof(RejectionReason));
        private static readonly string[] HealthKinds = WordsOf(typeof(HealthKind));
        private static readonly string[] HandSides = WordsOf(typeof(HandSide));
        private static readonly string[] DepthSources = WordsOf(typeof(DepthSource));

        public static string Of(LaserColor color) => At(Colors, (int)color);

        public static string Of(RejectionReason reason) => At(Reasons, (int)reason);

        public static string Of(HealthKind kind) => At(HealthKinds, (int)kind);

        public static string Of(HandSide side) => At(HandSides, (int)side);

        public static string Of(DepthSource source) => At(DepthSources, (int)source);

        public static bool TryParse(string word, out LaserColor color)
        {
            bool known = TryFind(Colors, word, out int index);
            color = (LaserColor)index;
            return known;
        }

        public static bool TryParse(string word, out RejectionReason reason)
        {
            bool known = TryFind(Reasons, word, out int index);
            reason = (RejectionReason)index;
            return known;
        }

        public static bool TryParse(string word, out HealthKind kind)
        {
            bool known = TryFind(HealthKinds, word, out int index);
            kind = (HealthKind)index;
            return known;
        }

        public static bool TryParse(string word, out HandSide side)
        {
            bool known = TryFind(HandSides, word, out int index);
            side = (HandSide)index;
            return known;
        }

        public static bool TryParse(string word, out DepthSource source)
        {
            bool known = TryFind(DepthSources, word, out int index);
            source = (DepthSource)index;
            return known;
        }

        private static bool TryFind(string[] words, string word, out int index)
        {
            index = Array.IndexOf(words, word);
            bool found = index >= 0;
            index = Math.Max(index, 0);
            return found;
        }

        private static string At(string[] words, int index) => (uint)index < (uint)words.Length ? words[index] : "unknown";

        private static string[] WordsOf(Type type)
        {
            Array values = Enum.GetValues(type);
            var words = new string[values.Length];
            for (int i = 0; i < words.Length; i++)
            {
                object value = values.GetValue(i)!;
                int index = Convert.ToInt32(value, System.Globalization.CultureInfo.InvariantCulture);
                if (index != i)
                    throw new InvalidOperationException(type.Name + ": members must count from 0 without gaps");
                words[i] = SnakeCase(value.ToString()!);
            }

            return words;
        }

        private static string SnakeCase(string name)
        {
            var word = new System.Text.StringBuilder();
            for (int i = 0; i < name.Length; i++)
            {
                if (i > 0 && char.IsUpper(name[i]))
                    word.Append('_');
                word.Append(char.ToLowerInvariant(name[i]));
            }

            return word.ToString();
        }
    }
}
