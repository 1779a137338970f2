using System;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>One colour for each shooter, so that marks, rays and scores of one person can be told at a glance.</summary>
    [Serializable]
    public sealed class ShooterColors
    {
        [Tooltip("For a shot that nobody is known to have fired.")]
        public Color unknown = new Color(0.95f, 0.95f, 0.95f, 1);

        [Tooltip("Shooter 1, 2, …; begins again after the last.")]
        public Color[] shooters =
        {
            // Okabe and Ito 2008: told apart also by those who see colours differently.
            new Color(0.90f, 0.62f, 0f, 1), new Color(0.34f, 0.71f, 0.91f, 1), new Color(0f, 0.62f, 0.45f, 1),
            new Color(0.94f, 0.89f, 0.26f, 1), new Color(0.80f, 0.47f, 0.65f, 1), new Color(0.84f, 0.37f, 0f, 1),
        };

        /// <param name="shooter">From 1; 0: unknown.</param>
        public Color Of(int shooter) => shooter <= 0 || shooters.Length == 0 ? unknown : shooters[(shooter - 1) % shooters.Length];
    }
}
