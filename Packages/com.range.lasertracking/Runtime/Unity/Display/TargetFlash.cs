using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Lights a target for a moment after a hit: emission where its materials have some, else their colour. Set in a property block, so
    /// that no material is copied or changed; blocks that others have set come back afterwards.
    /// </summary>
    internal sealed class TargetFlash
    {
        private static readonly int Emission = Shader.PropertyToID("_EmissionColor");
        private static readonly int BaseColor = Shader.PropertyToID("_BaseColor");
        private static readonly int MainColor = Shader.PropertyToID("_Color");

        private readonly Renderer[] _renderers;
        private readonly MaterialPropertyBlock[] _before;
        private readonly MaterialPropertyBlock _light = new MaterialPropertyBlock();
        private double _untilS;

        public TargetFlash(LaserTarget target)
        {
            Target = target;
            _renderers = target.GetComponentsInChildren<Renderer>();
            _before = System.Array.ConvertAll(_renderers, _ => new MaterialPropertyBlock());
        }

        public LaserTarget Target { get; }

        public bool IsLit { get; private set; }

        public void Light(Color color, double untilS)
        {
            _light.SetColor(Emission, color);
            _light.SetColor(BaseColor, color);
            _light.SetColor(MainColor, color);
            for (int i = 0; i < _renderers.Length; i++)
            {
                if (_renderers[i] == null)
                    continue;
                if (!IsLit)
                    _renderers[i].GetPropertyBlock(_before[i]);
                _renderers[i].SetPropertyBlock(_light);
            }

            IsLit = true;
            _untilS = untilS;
        }

        public void Update(double nowS)
        {
            if (IsLit && nowS >= _untilS)
                PutOut();
        }

        public void PutOut()
        {
            for (int i = 0; i < _renderers.Length && IsLit; i++)
            {
                if (_renderers[i] != null)
                    _renderers[i].SetPropertyBlock(_before[i].isEmpty ? null : _before[i]);
            }

            IsLit = false;
        }
    }
}
