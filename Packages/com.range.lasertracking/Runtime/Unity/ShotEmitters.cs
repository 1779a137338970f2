using System.Collections.Generic;
using LaserTracking.Session;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// What is enabled and emits shots, of all loaded scenes: whoever finds something set wrongly tells it here, so that it reaches the
    /// Console and everybody's HealthChanged. Static because the parts of a range need not know each other; emptied when play begins,
    /// since editors may keep statics from the last run. Main thread.
    /// </summary>
    internal static class ShotEmitters
    {
        private static readonly List<ShotEmitter> Enabled = new List<ShotEmitter>();

        public static int Count => Enabled.Count;

        public static ShotEmitter At(int index) => Enabled[index];

        public static void Add(ShotEmitter emitter) => Enabled.Add(emitter);

        public static void Remove(ShotEmitter emitter) => Enabled.Remove(emitter);

        /// <summary>Tells those who shoot at a screen that it stands for this frame where it does now.</summary>
        public static void RememberViews(ScreenSurface screen)
        {
            for (int i = 0; i < Enabled.Count; i++)
            {
                if (Enabled[i].Screen == screen)
                    Enabled[i].RememberView();
            }
        }

        /// <summary>Something about the scene is wrong that no emitter has to do with.</summary>
        /// <param name="context">What the Console shows beside the message.</param>
        /// <param name="text">What it is and what to do, in one line.</param>
        /// <param name="isError">It will not work at all.</param>
        public static void Report(Object context, string text, bool isError)
        {
            Log(context, text, isError);
            var health = new HealthEvent { FrameIndex = -1, Kind = HealthKind.SetUp, Text = text };
            for (int i = 0; i < Enabled.Count; i++)
                Enabled[i].AddHealth(health);
        }

        public static void Log(Object context, string text, bool isError)
        {
            if (isError)
                Debug.LogError(text, context);
            else
                Debug.LogWarning(text, context);
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Clear() => Enabled.Clear();
    }
}
