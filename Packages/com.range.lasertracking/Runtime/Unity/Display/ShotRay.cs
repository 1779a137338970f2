using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>One pooled line from the muzzle through the dot on the screen to where the shot ended, for a moment.</summary>
    internal sealed class ShotRay
    {
        /// <summary>A line from the eye itself would be a point to it: without a muzzle it comes from a little below.</summary>
        private const float BelowEyeM = 0.25f;

        private readonly LineRenderer _line;
        private double _untilS;

        public ShotRay(Transform parent, Material? material, float widthM)
        {
            var owner = new GameObject("Ray");
            owner.transform.SetParent(parent, false);
            _line = owner.AddComponent<LineRenderer>();
            _line.sharedMaterial = material;
            _line.useWorldSpace = true;
            _line.startWidth = _line.endWidth = widthM;
            _line.positionCount = 3;
            _line.enabled = false;
        }

        public bool IsShown => _line.enabled;

        public void Show(in ShotTrace trace, Color color, MaterialPropertyBlock block, double untilS)
        {
            Vector3 from = trace.From;
            if (!trace.Shot.HasMuzzle)
                from.y -= BelowEyeM;
            _line.SetPosition(0, from);
            _line.SetPosition(1, trace.OnScreen);
            _line.SetPosition(2, trace.End);
            // The line's own colours for materials that use them, the block for those that do not.
            _line.startColor = _line.endColor = color;
            _line.SetPropertyBlock(block);
            _line.enabled = true;
            _untilS = untilS;
        }

        public void Update(double nowS)
        {
            if (_line.enabled && nowS >= _untilS)
                Hide();
        }

        public void Hide() => _line.enabled = false;
    }
}
